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
using Eigen::VectorXd;

struct ActuationFitPolicy {
    /// Unit of the optimiser's variables: a tenth of an unknown's scale keeps its first update moderate.
    double value_unit = 0.1;
};
constexpr ActuationFitPolicy actuation_fit_policy;

/// All unknowns of a search in one vector: the values of the signals, signal index fastest, then those of the design.
struct Unknowns {
    Index signals = 0, knots = 0;
    VectorXd lower, upper, scales;  // one entry per unknown

    Unknowns(const ActuationProblem& problem, const MatrixXd& like) : signals(like.rows()), knots(like.cols()) {
        const DesignBounds design = design_bounds(problem.design);
        const Index count = like.size() + design.scales.size();
        lower.resize(count), upper.resize(count), scales.resize(count);
        for (Index i = 0; i < like.size(); ++i) {
            const SoughtSignal& signal = problem.sought.signals[static_cast<std::size_t>(i % signals)];
            lower(i) = signal.lower, upper(i) = signal.upper, scales(i) = signal.scale;
        }
        lower.tail(design.lower.size()) = design.lower;
        upper.tail(design.upper.size()) = design.upper;
        scales.tail(design.scales.size()) = design.scales;
    }
    MatrixXd values(const VectorXd& x) const { return x.head(signals * knots).reshaped(signals, knots); }
    VectorXd design(const VectorXd& x) const { return x.tail(x.size() - signals * knots); }
    /// Conversion to optimiser units and back can leave a value one bit outside.
    VectorXd inside(const VectorXd& x) const { return x.cwiseMax(lower).cwiseMin(upper); }
    /// Units of the optimiser's variables.
    VectorXd units() const { return actuation_fit_policy.value_unit * scales; }
};

VectorXd in_one(const MatrixXd& values, const VectorXd& design) {
    VectorXd all(values.size() + design.size());
    all << values.reshaped(), design;
    return all;
}

/// Objective function of the optimiser: loss relative to the start, unknowns in their unit. Logs every evaluation.
class Search {
public:
    Search(const ActuationProblem& problem, const ActuationFitOptions& options, const Progress& progress,
           const Unknowns& unknowns, ActuationFit& fit)
        : problem_(problem), options_(options), progress_(progress), unknowns_(unknowns), fit_(fit) {}

    void stop_with(nlopt_opt optimiser) { optimiser_ = optimiser; }

    /// Scaled loss at `x`, with its gradient if not null.
    double at(const VectorXd& x, double* gradient) {
        if (fit_.log.empty() || x != last_x_) evaluate(x);
        if (progress_.cancelled() && optimiser_ != nullptr) nlopt_force_stop(optimiser_);
        VectorXd slope = in_one(last_.gradient, last_.design_gradient);
        double value = last_.loss_m2;
        if (!last_.ok()) {
            // Substitute for a failed run: a paraboloid far above the best loss, centred at the best values.
            const VectorXd away = (x - in_one(fit_.values, fit_.design)).cwiseQuotient(unknowns_.scales);
            const double steepness = 10.0 * fit_.first.loss_m2 / std::max(away.squaredNorm(), 1e-12);
            value = fit_.best.loss_m2 + steepness * away.squaredNorm();
            slope = 2.0 * steepness * away.cwiseQuotient(unknowns_.scales);
        }
        const double scale = fit_.first.loss_m2 > 0.0 ? fit_.first.loss_m2 : 1.0;
        if (gradient != nullptr)
            Eigen::Map<VectorXd>(gradient, x.size()) = unknowns_.units().cwiseProduct(slope) / scale;
        return value / scale;
    }

    const ActuationEvaluation& last() const { return last_; }

private:
    /// Norm of the gradient by unknowns over their scales, without the components that point out of the bounds.
    double projected_norm(const VectorXd& x) const {
        const VectorXd gradient = unknowns_.scales.cwiseProduct(in_one(last_.gradient, last_.design_gradient));
        double sum = 0.0;
        for (Index i = 0; i < x.size(); ++i) {
            const double g = gradient(i);
            if ((g > 0.0 && x(i) <= unknowns_.lower(i)) || (g < 0.0 && x(i) >= unknowns_.upper(i))) continue;
            sum += g * g;
        }
        return std::sqrt(sum);
    }

    void evaluate(const VectorXd& x) {
        ActuationIterate line;
        report(0.0);
        const Progress inner = progress_.with_sink([this](const ProgressEvent& event) {
            if (event.total > 0.0 && throttle_.ready()) report(std::clamp(event.done / event.total, 0.0, 0.999));
        });
        {
            const TimedScope scope(line.seconds);
            last_ = evaluate_actuation(problem_, unknowns_.values(x), unknowns_.design(x), inner);
        }
        if (last_.status == dynamics::RunStatus::cancelled) return;  // incomplete: not logged
        last_x_ = x;
        line.ok = last_.ok();
        if (line.ok) {
            line.loss_m2 = last_.loss_m2;
            line.rms_m = last_.rms_m;
            line.gradient_norm_m2 = projected_norm(x);
            if (!fit_.first.ok()) fit_.first = last_;
            if (!fit_.best.ok() || last_.loss_m2 < fit_.best.loss_m2) {
                fit_.best = last_;
                fit_.values = unknowns_.values(x);
                fit_.design = unknowns_.design(x);
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
    const Unknowns& unknowns_;
    ActuationFit& fit_;
    nlopt_opt optimiser_ = nullptr;
    VectorXd last_x_;
    ActuationEvaluation last_;
    Throttle throttle_;
};

struct Objective {
    Search& search;
    const Unknowns& unknowns;
    VectorXd units;
};

/// Callback of NLopt.
double objective(unsigned count, const double* x, double* gradient, void* data) {
    const Objective& o = *static_cast<Objective*>(data);
    const Eigen::Map<const VectorXd> scaled(x, static_cast<Index>(count));
    return o.search.at(o.unknowns.inside(o.units.cwiseProduct(scaled)), gradient);
}

using Optimiser = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Optimiser bounded_optimiser(const Unknowns& unknowns, const ActuationFitOptions& options) {
    Optimiser optimiser(nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(unknowns.lower.size())), nlopt_destroy);
    const VectorXd lower = unknowns.lower.cwiseQuotient(unknowns.units()),
                   upper = unknowns.upper.cwiseQuotient(unknowns.units());
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

ActuationEvaluation evaluate_actuation(const ActuationProblem& problem, const MatrixXd& values, const VectorXd& design,
                                       const Progress& progress) {
    const model::Model model = designed_model(
        problem.design, design, driven_model(problem.model, acting_commands(problem.sought, problem.acting, values)));
    ActuationEvaluation result;
    MarkerTarget target = problem.target;
    // The placement is optimised inside the loss: by the envelope theorem the gradient is that at fixed placement.
    const auto loss = [&](const sensitivity::NodeMotion& motion) {
        if (problem.placement_bounds) target.placement = best_placement(target, motion, *problem.placement_bounds);
        return mean_square(target, motion);
    };
    sensitivity::AdjointOptions adjoint;
    adjoint.fibre_points = std::any_of(problem.design.begin(), problem.design.end(),
                                       [](const DesignVariablePointer& each) { return each->changes_fibres(); });
    sensitivity::GradientRun run = sensitivity::simulate_with_gradient(model, problem.options,
                                                                       {target.markers.nodes, loss}, adjoint, progress);
    result.placement = target.placement;
    result.status = run.status;
    result.message = run.message;
    if (!run.complete()) return result;
    result.gradient = acting_value_gradient(problem.sought, problem.acting, values,
                                            driven_gradient(model, run.gradient, problem.sought.groups.size()));
    result.design_gradient = design_gradient(problem.design, design, model, run.gradient);
    result.rms_m = std::sqrt(run.loss);
    const double weight = problem.smoothness_m_s * problem.smoothness_m_s,
                 evenness = problem.design_smoothness_m * problem.design_smoothness_m;
    result.loss_m2 = run.loss + weight * mean_square_rate(problem.sought, values, weight, result.gradient) +
                     evenness * design_roughness(problem.design, design, evenness, result.design_gradient);
    result.motion = std::move(run.motion);
    result.steps = run.steps;
    if (!std::isfinite(result.loss_m2) || !result.gradient.allFinite() || !result.design_gradient.allFinite()) {
        result.status = dynamics::RunStatus::failed;
        result.message = "the loss or its gradient is not a finite number";
    }
    return result;
}

ActuationEvaluation evaluate_actuation(const ActuationProblem& problem, const MatrixXd& values,
                                       const Progress& progress) {
    return evaluate_actuation(problem, values, declared_design(problem.design), progress);
}

ActuationFit fit_actuation(const ActuationProblem& problem, const ActuationStart& start,
                           const ActuationFitOptions& options, const Progress& progress) {
    const Unknowns unknowns(problem, start.values);
    assert(unknowns.scales.size() > 0 && problem.target.coordinates() > 0);
    const Stopwatch watch;
    ActuationFit fit;
    VectorXd x = unknowns.inside(
        in_one(start.values, start.design.size() > 0 ? start.design : declared_design(problem.design)));
    fit.start = fit.values = unknowns.values(x);
    fit.design = unknowns.design(x);
    Search search(problem, options, progress, unknowns, fit);
    search.at(x, nullptr);
    if (fit.usable() && fit.first.loss_m2 <= options.met_rms_m * options.met_rms_m) {
        fit.status = FitStatus::converged;
        fit.message = "the target is met from the start";
    } else if (fit.usable()) {
        const Optimiser optimiser = bounded_optimiser(unknowns, options);
        Objective data{search, unknowns, unknowns.units()};
        search.stop_with(optimiser.get());
        nlopt_set_min_objective(optimiser.get(), objective, &data);
        x = x.cwiseQuotient(unknowns.units());
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
