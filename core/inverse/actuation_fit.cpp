#include "inverse/actuation_fit.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "base/throttle.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

struct ActuationFitPolicy {
    /// Unit of the optimiser's variables: a tenth of a signal's scale keeps its first update moderate.
    double value_unit = 0.1;
};
constexpr ActuationFitPolicy actuation_fit_policy;

/// Unit of the optimiser's variables for each signal.
Eigen::VectorXd value_units(const SoughtSignals& sought) {
    return actuation_fit_policy.value_unit * signal_scales(sought);
}

/// Objective function of the optimiser: loss relative to the start, values in their unit. Logs every evaluation.
class Search {
public:
    Search(const ActuationProblem& problem, const ActuationFitOptions& options, const Progress& progress,
           ActuationFit& fit)
        : problem_(problem), options_(options), progress_(progress), fit_(fit) {}

    void stop_with(nlopt_opt optimiser) { optimiser_ = optimiser; }

    /// Scaled loss at `values`, with its gradient if not null.
    double at(const MatrixXd& values, double* gradient) {
        if (fit_.log.empty() || values != last_values_) evaluate(values);
        if (progress_.cancelled() && optimiser_ != nullptr) nlopt_force_stop(optimiser_);
        MatrixXd slope = last_.gradient;
        double value = last_.loss_m2;
        if (!last_.ok()) {
            // Substitute for a failed run: a paraboloid far above the best loss, centred at the best values.
            const Eigen::VectorXd scales = signal_scales(problem_.sought);
            const MatrixXd away = scales.cwiseInverse().asDiagonal() * (values - fit_.values);
            const double steepness = 10.0 * fit_.first.loss_m2 / std::max(away.squaredNorm(), 1e-12);
            value = fit_.best.loss_m2 + steepness * away.squaredNorm();
            slope = 2.0 * steepness * (scales.cwiseInverse().asDiagonal() * away);
        }
        const double scale = fit_.first.loss_m2 > 0.0 ? fit_.first.loss_m2 : 1.0;
        if (gradient != nullptr)
            Eigen::Map<MatrixXd>(gradient, values.rows(),
                                 values.cols()) = (value_units(problem_.sought) / scale).asDiagonal() * slope;
        return value / scale;
    }

    const ActuationEvaluation& last() const { return last_; }

    /// Norm of the gradient by values over their scales, without the components that point out of the bounds.
    double projected_norm(const MatrixXd& values, const MatrixXd& gradient) const {
        double sum = 0.0;
        for (Index s = 0; s < values.rows(); ++s) {
            const SoughtSignal& signal = problem_.sought.signals[static_cast<std::size_t>(s)];
            for (Index k = 0; k < values.cols(); ++k) {
                const double g = signal.scale * gradient(s, k);
                if ((g > 0.0 && values(s, k) <= signal.lower) || (g < 0.0 && values(s, k) >= signal.upper)) continue;
                sum += g * g;
            }
        }
        return std::sqrt(sum);
    }

private:
    void evaluate(const MatrixXd& values) {
        ActuationIterate line;
        report(0.0);
        const Progress inner = progress_.with_sink([this](const ProgressEvent& event) {
            if (event.total > 0.0 && throttle_.ready()) report(std::clamp(event.done / event.total, 0.0, 0.999));
        });
        {
            const TimedScope scope(line.seconds);
            last_ = evaluate_actuation(problem_, values, inner);
        }
        if (last_.status == dynamics::RunStatus::cancelled) return;  // incomplete: not logged
        last_values_ = values;
        line.ok = last_.ok();
        if (line.ok) {
            line.loss_m2 = last_.loss_m2;
            line.rms_m = last_.rms_m;
            line.gradient_norm_m2 = projected_norm(values, last_.gradient);
            if (!fit_.first.ok()) fit_.first = last_;
            if (!fit_.best.ok() || last_.loss_m2 < fit_.best.loss_m2) {
                fit_.best = last_;
                fit_.values = values;
                fit_.gradient_norm_m2 = line.gradient_norm_m2;
            }
        }
        fit_.log.push_back(line);
        report(0.0);
        if (options_.evaluated) options_.evaluated(fit_);
    }

    void report(double share) const {
        std::string words;
        if (!fit_.log.empty()) {
            const ActuationIterate& line = fit_.log.back();
            words = line.ok ? "rms " + format_number(1e3 * line.rms_m, 4) + " mm, loss " +
                                  format_number(1e6 * line.loss_m2, 4) + " mm2, gradient " +
                                  format_number(1e6 * line.gradient_norm_m2, 3) + " mm2"
                            : last_.message;
        }
        progress_.report({"optimize", static_cast<double>(fit_.log.size()) + share,
                          static_cast<double>(options_.max_evaluations), "evaluations", words});
    }

    const ActuationProblem& problem_;
    const ActuationFitOptions& options_;
    const Progress& progress_;
    ActuationFit& fit_;
    nlopt_opt optimiser_ = nullptr;
    MatrixXd last_values_;
    ActuationEvaluation last_;
    Throttle throttle_;
};

/// Bounds of all values.
struct Bounds {
    MatrixXd lower, upper;  // signals x knots
    Eigen::VectorXd units;  // of the optimiser, per signal

    Bounds(const SoughtSignals& sought, const MatrixXd& like) : lower(like), upper(like), units(value_units(sought)) {
        for (Index s = 0; s < like.rows(); ++s) {
            lower.row(s).setConstant(sought.signals[static_cast<std::size_t>(s)].lower);
            upper.row(s).setConstant(sought.signals[static_cast<std::size_t>(s)].upper);
        }
    }
    /// Conversion to optimiser units and back can leave a value one bit outside.
    MatrixXd inside(const MatrixXd& values) const { return values.cwiseMax(lower).cwiseMin(upper); }
    /// Values in the units of the optimiser.
    MatrixXd in_units(const MatrixXd& values) const { return values.cwiseQuotient(units.replicate(1, values.cols())); }
};

struct Objective {
    Search& search;
    const Bounds& bounds;
};

/// Callback of NLopt.
double objective(unsigned, const double* x, double* gradient, void* data) {
    const Objective& o = *static_cast<Objective*>(data);
    const Eigen::Map<const MatrixXd> scaled(x, o.bounds.lower.rows(), o.bounds.lower.cols());
    return o.search.at(o.bounds.inside(o.bounds.units.asDiagonal() * scaled), gradient);
}

using Optimiser = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Optimiser bounded_optimiser(const Bounds& bounds, const ActuationFitOptions& options) {
    Optimiser optimiser(nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(bounds.lower.size())), nlopt_destroy);
    const MatrixXd lower = bounds.in_units(bounds.lower), upper = bounds.in_units(bounds.upper);
    nlopt_set_lower_bounds(optimiser.get(), lower.data());
    nlopt_set_upper_bounds(optimiser.get(), upper.data());
    nlopt_set_ftol_rel(optimiser.get(), options.relative_decrease);
    nlopt_set_maxeval(optimiser.get(), options.max_evaluations);
    return optimiser;
}

/// Status and message from the return code of NLopt.
void set_ending(const ActuationFitOptions& options, const Progress& progress, nlopt_result ended, ActuationFit& fit) {
    if (progress.cancelled()) {
        fit.status = FitStatus::cancelled;
        fit.message = "stopped by the user";
    } else if (ended == NLOPT_MAXEVAL_REACHED) {
        fit.status = FitStatus::not_converged;
        fit.message = "it took all of the " + std::to_string(options.max_evaluations) + " evaluations that it may";
    } else if (ended > 0 || fit.best.loss_m2 < fit.first.loss_m2 || fit.gradient_norm_m2 == 0.0) {
        // The line search also fails where rounding hides any further decrease; this counts as converged.
        fit.status = FitStatus::converged;
    } else {
        fit.status = FitStatus::not_converged;
        fit.message = "no step from the start makes the loss smaller";
    }
}

}  // namespace

ActuationEvaluation evaluate_actuation(const ActuationProblem& problem, const MatrixXd& values,
                                       const Progress& progress) {
    const model::Model model = driven_model(problem.model, acting_commands(problem.sought, problem.acting, values));
    ActuationEvaluation result;
    MarkerTarget target = problem.target;
    // The placement is optimised inside the loss: by the envelope theorem the gradient is that at fixed placement.
    const auto loss = [&](const sensitivity::NodeMotion& motion) {
        if (problem.placement_bounds) target.placement = best_placement(target, motion, *problem.placement_bounds);
        return mean_square(target, motion);
    };
    sensitivity::GradientRun run = sensitivity::simulate_with_gradient(model, problem.options,
                                                                       {target.markers.nodes, loss}, {}, progress);
    result.placement = target.placement;
    result.status = run.status;
    result.message = run.message;
    if (!run.complete()) return result;
    result.gradient = acting_value_gradient(problem.sought, problem.acting, values,
                                            driven_gradient(model, run.gradient, problem.sought.groups.size()));
    result.rms_m = std::sqrt(run.loss);
    const double weight = problem.smoothness_m_s * problem.smoothness_m_s;
    result.loss_m2 = run.loss + weight * mean_square_rate(problem.sought, values, weight, result.gradient);
    result.motion = std::move(run.motion);
    result.steps = run.steps;
    if (!std::isfinite(result.loss_m2) || !result.gradient.allFinite()) {
        result.status = dynamics::RunStatus::failed;
        result.message = "the loss or its gradient is not a finite number";
    }
    return result;
}

ActuationFit fit_actuation(const ActuationProblem& problem, const MatrixXd& start, const ActuationFitOptions& options,
                           const Progress& progress) {
    assert(start.size() > 0 && problem.target.coordinates() > 0);
    const Stopwatch watch;
    const Bounds bounds(problem.sought, start);
    ActuationFit fit;
    fit.start = fit.values = bounds.inside(start);
    Search search(problem, options, progress, fit);
    search.at(fit.start, nullptr);
    if (fit.usable() && fit.first.loss_m2 <= options.met_rms_m * options.met_rms_m) {
        fit.status = FitStatus::converged;
        fit.message = "the target is met from the start";
    } else if (fit.usable()) {
        const Optimiser optimiser = bounded_optimiser(bounds, options);
        Objective data{search, bounds};
        search.stop_with(optimiser.get());
        nlopt_set_min_objective(optimiser.get(), objective, &data);
        MatrixXd x = bounds.in_units(fit.start);
        double least = 0.0;
        set_ending(options, progress, nlopt_optimize(optimiser.get(), x.data(), &least), fit);
    } else {
        fit.status = progress.cancelled() ? FitStatus::cancelled : FitStatus::failed;
        fit.message = progress.cancelled() ? "stopped by the user" : search.last().message;
    }
    fit.seconds = watch.seconds();
    return fit;
}

}  // namespace myo::inverse
