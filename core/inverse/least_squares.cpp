#include "inverse/least_squares.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "base/throttle.hpp"

namespace myo {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Progress of the whole fit from what the running evaluation says of itself.
class EvaluationProgress {
public:
    EvaluationProgress(const Progress& outer, int most_evaluations) : outer_(outer), total_(most_evaluations) {}

    Progress inside(int complete, const std::string& message) {
        return outer_.with_sink([this, complete, message](const ProgressEvent& event) {
            if (!throttle_.ready()) return;
            const double share = event.total > 0.0 ? std::clamp(event.done / event.total, 0.0, 0.999) : 0.0;   // whole when evaluated
            report(complete + share, message);
        });
    }
    void report(double done, const std::string& message) const { outer_.report({"fit", done, total_, "evaluations", message}); }

private:
    const Progress& outer_;
    double total_;
    Throttle throttle_;
};

std::string quality_words(const ResidualEvaluation& evaluation) {
    if (!evaluation.ok) return evaluation.message;
    const auto count = static_cast<double>(std::max<Eigen::Index>(1, evaluation.residuals.size()));
    return "rms " + format_number(std::sqrt(evaluation.residuals.squaredNorm() / count), 4) + " times the noise";
}

/// The number that the fit moves, in units of what matters, and back; and the derivative of the way back.
double internal_value(const Parameter& p, double value) { return p.over_decades ? std::log1p(value / p.scale) : value / p.scale; }
double physical_value(const Parameter& p, double internal) { return p.over_decades ? p.scale * std::expm1(internal) : internal * p.scale; }
double physical_slope(const Parameter& p, double internal) { return p.over_decades ? p.scale * std::exp(internal) : p.scale; }

/// A secant is trusted for the next step where the last Jacobian foretold the change of the residuals to this share of it; a fit's end, where
/// the last that was asked for did to this one.
constexpr double trusted_secant = 0.3, trusted_end = 0.1;

/// Evaluates once per point: Ceres asks first for residuals, then, when it accepts the step, for the Jacobian.
class Evaluator {
public:
    Evaluator(const std::vector<Parameter>& parameters, const ResidualFunction& function, const JacobianFunction& jacobian, const Progress& progress,
              const LeastSquaresOptions& options, LeastSquaresReport& report)
        : parameters_(parameters), function_(function), jacobian_(jacobian), progress_(progress), shown_(progress, options.max_evaluations), report_(report) {}

    /// The evaluation there with its Jacobian: the residuals' own, a secant, or one that is asked for. Not ok where none is to be had.
    const ResidualEvaluation& with_jacobian(const VectorXd& values, bool exact = false) {
        ResidualEvaluation& evaluation = entry(values);
        const bool has = evaluation.jacobian.size() > 0;
        if (!evaluation.ok || !jacobian_ || (has && (!exact || was_asked(values)))) return evaluation;
        MatrixXd J = exact ? MatrixXd() : secant(values, evaluation.residuals);
        const bool asks = J.size() == 0;
        if (asks) {
            J = jacobian_(values, evaluation, progress_.with_sink({}));
            ++report_.jacobians;
        }
        if (J.size() == 0 || !J.allFinite()) return progress_.cancelled() ? stopped_ : no_derivatives_;
        evaluation.jacobian = std::move(J);
        last_ = {values, evaluation};
        if (asks) asked_ = last_;
        if (values == report_.values) best_ = evaluation;
        return evaluation;
    }

    const ResidualEvaluation& at(const VectorXd& values) { return entry(values); }

    /// Takes a Jacobian as if it were a secant.
    void adopt(const VectorXd& values, const MatrixXd& J) {
        ResidualEvaluation& evaluation = entry(values);
        if (!evaluation.ok) return;
        evaluation.jacobian = J;
        last_ = {values, evaluation};
        best_ = evaluation;
    }

    /// The best values have a Jacobian that was asked for, or that the residuals brought.
    bool asked_at_the_end() const { return !jacobian_ || was_asked(report_.values); }

    /// The Jacobian that was asked for last holds where the best values are.
    bool knows_the_end() const {
        if (was_asked(report_.values)) return true;
        if (asked_.values.size() == 0) return false;
        const VectorXd change = best_.residuals - asked_.evaluation.residuals;
        return surprise(asked_, report_.values, best_.residuals).norm() < trusted_end * change.norm();
    }

    /// The evaluation with the least cost so far; where its Jacobian was not asked for, with the nearest to it.
    ResidualEvaluation best() const {
        ResidualEvaluation best = best_;
        if (best.ok && best.jacobian.size() == 0) best.jacobian = secant(report_.values, best.residuals);
        if (best.ok && best.jacobian.size() == 0) best.jacobian = last_.evaluation.jacobian;
        return best;
    }

    VectorXd physical(const double* internal) const {
        VectorXd values(static_cast<Eigen::Index>(parameters_.size()));
        for (std::size_t i = 0; i < parameters_.size(); ++i) values(static_cast<Eigen::Index>(i)) = physical_value(parameters_[i], internal[i]);
        return values;
    }

    VectorXd slopes(const double* internal) const {
        VectorXd slope(static_cast<Eigen::Index>(parameters_.size()));
        for (std::size_t i = 0; i < parameters_.size(); ++i) slope(static_cast<Eigen::Index>(i)) = physical_slope(parameters_[i], internal[i]);
        return slope;
    }
    const std::vector<Parameter>& parameters() const { return parameters_; }

private:
    struct Point {
        VectorXd values;
        ResidualEvaluation evaluation;
    };

    VectorXd internal(const VectorXd& values) const {
        VectorXd u(values.size());
        for (Eigen::Index i = 0; i < u.size(); ++i) u(i) = internal_value(parameters_[static_cast<std::size_t>(i)], values(i));
        return u;
    }

    bool was_asked(const VectorXd& values) const { return asked_.values.size() > 0 && asked_.values == values; }

    /// How far the residuals are from what the Jacobian at a point foretells.
    VectorXd surprise(const Point& from, const VectorXd& values, const VectorXd& residuals) const {
        const VectorXd u = internal(from.values);
        return residuals - from.evaluation.residuals - from.evaluation.jacobian * slopes(u.data()).cwiseProduct(internal(values) - u);
    }

    /// The last Jacobian turned so that it explains the step from there; empty where it foretold that step badly.
    MatrixXd secant(const VectorXd& values, const VectorXd& residuals) const {
        if (last_.values.size() == 0) return {};
        const VectorXd u = internal(last_.values), step = internal(values) - u;
        const VectorXd missed = surprise(last_, values, residuals);
        if (!(missed.norm() < trusted_secant * (residuals - last_.evaluation.residuals).norm())) return {};
        const MatrixXd J = last_.evaluation.jacobian * slopes(u.data()).asDiagonal();
        const VectorXd slope = slopes(internal(values).data());
        return (J + missed * step.transpose() / step.squaredNorm()) * slope.cwiseInverse().asDiagonal();
    }

    ResidualEvaluation& entry(const VectorXd& values) {
        for (Point& point : cache_)
            if (point.values == values) return point.evaluation;
        if (progress_.cancelled()) return stopped_;
        if (report_.evaluations == 0) shown_.report(0.0, {});   // something is seen while the first one is under way
        FitIterate iterate{values, std::numeric_limits<double>::infinity()};
        const Stopwatch watch;
        ResidualEvaluation fresh = function_(values, shown_.inside(report_.evaluations, last_words_));
        iterate.seconds = watch.seconds();
        if (!fresh.ok && progress_.cancelled()) return stopped_;   // ended half-way
        if (cache_.size() == 3) cache_.erase(cache_.begin());
        if (fresh.ok && !std::isfinite(fresh.residuals.squaredNorm())) {
            fresh.ok = false;
            fresh.message = "the sum of squared differences to the data is not a finite number";
        }
        cache_.push_back({values, std::move(fresh)});
        ResidualEvaluation& evaluation = cache_.back().evaluation;
        ++report_.evaluations;
        if (evaluation.ok) keep(iterate, evaluation);
        report_.history.push_back(std::move(iterate));
        last_words_ = quality_words(evaluation);
        shown_.report(report_.evaluations, last_words_);
        return evaluation;
    }

    void keep(FitIterate& iterate, const ResidualEvaluation& evaluation) {
        iterate.cost = 0.5 * evaluation.residuals.squaredNorm();
        const bool first = !report_.usable();
        if (first) report_.cost_before = iterate.cost;
        if (!first && !(iterate.cost < report_.cost_after)) return;
        report_.values = iterate.values;
        report_.cost_after = iterate.cost;
        best_ = evaluation;
    }

    const std::vector<Parameter>& parameters_;
    const ResidualFunction& function_;
    const JacobianFunction& jacobian_;   // empty: the residuals bring theirs
    const Progress& progress_;
    EvaluationProgress shown_;
    LeastSquaresReport& report_;
    std::string last_words_;
    ResidualEvaluation best_;
    std::vector<Point> cache_;
    Point last_;            // where the last Jacobian was given
    Point asked_;           // where one was last asked for
    ResidualEvaluation stopped_{false, "stopped by the user", {}, {}};
    ResidualEvaluation no_derivatives_{false, "the model could not be run beside these values", {}, {}};
};

class ResidualBlock final : public ceres::CostFunction {
public:
    ResidualBlock(Evaluator& evaluator, int residuals) : evaluator_(evaluator) {
        set_num_residuals(residuals);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(evaluator.parameters().size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        const bool derivatives = jacobians != nullptr && jacobians[0] != nullptr;
        const VectorXd values = evaluator_.physical(blocks[0]);
        const ResidualEvaluation& evaluation = derivatives ? evaluator_.with_jacobian(values) : evaluator_.at(values);
        if (!evaluation.ok || evaluation.residuals.size() != num_residuals()) return false;
        std::copy(evaluation.residuals.begin(), evaluation.residuals.end(), residuals);
        if (derivatives) {
            using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
            Eigen::Map<RowMajor>(jacobians[0], evaluation.jacobian.rows(), evaluation.jacobian.cols()) =
                evaluation.jacobian * evaluator_.slopes(blocks[0]).asDiagonal();
        }
        return true;
    }

private:
    Evaluator& evaluator_;
};

/// Ends a descent that is cancelled, and one whose step along a secant did not help: an exact Jacobian is to be asked for.
class DescentWatch final : public ceres::IterationCallback {
public:
    DescentWatch(const Progress& progress, const Evaluator& evaluator) : progress_(progress), evaluator_(evaluator) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
        if (progress_.cancelled()) return ceres::SOLVER_ABORT;
        return step.step_is_successful || evaluator_.asked_at_the_end() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    }

private:
    const Progress& progress_;
    const Evaluator& evaluator_;
};

/// Deviations and correlations from J'J, in units of the parameters' scales to be well conditioned.
void set_covariance(const std::vector<Parameter>& parameters, const ResidualEvaluation& end, LeastSquaresReport& report) {
    const auto n = static_cast<Eigen::Index>(parameters.size());
    report.deviations = VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    report.correlation = Eigen::MatrixXd::Identity(n, n);
    if (!end.ok || n == 0) return;
    VectorXd scale(n);
    for (Eigen::Index i = 0; i < n; ++i) scale(i) = parameters[static_cast<std::size_t>(i)].scale;
    const Eigen::MatrixXd J = end.jacobian * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(J.transpose() * J);
    if (eigen.eigenvalues()(0) <= 1e-14 * eigen.eigenvalues()(n - 1)) return;   // a direction the data do not see
    const double freedom = static_cast<double>(std::max<Eigen::Index>(1, end.residuals.size() - n));
    const double variance = std::max(1.0, end.residuals.squaredNorm() / freedom);
    const Eigen::MatrixXd covariance =
        variance * eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
    const VectorXd deviation = covariance.diagonal().cwiseSqrt();
    report.deviations = deviation.cwiseProduct(scale);
    report.correlation = deviation.cwiseInverse().asDiagonal() * covariance * deviation.cwiseInverse().asDiagonal();
}

/// One descent from the internal values, which it moves.
ceres::TerminationType descend(Evaluator& evaluator, int residuals, const LeastSquaresOptions& options, const Progress& progress, std::vector<double>& internal, std::string& message) {
    ceres::Problem problem;
    problem.AddResidualBlock(new ResidualBlock(evaluator, residuals), nullptr, internal.data());
    for (std::size_t i = 0; i < internal.size(); ++i) {
        const Parameter& parameter = evaluator.parameters()[i];
        if (std::isfinite(parameter.lower)) problem.SetParameterLowerBound(internal.data(), static_cast<int>(i), internal_value(parameter, parameter.lower));
        if (std::isfinite(parameter.upper)) problem.SetParameterUpperBound(internal.data(), static_cast<int>(i), internal_value(parameter, parameter.upper));
    }
    ceres::Solver::Options settings;
    settings.linear_solver_type = ceres::DENSE_QR;
    settings.logging_type = ceres::SILENT;
    settings.max_num_iterations = options.max_evaluations;
    settings.function_tolerance = options.relative_decrease;
    settings.parameter_tolerance = options.relative_step;
    settings.gradient_tolerance = 1e-12;
    settings.initial_trust_region_radius = 1e4;
    settings.num_threads = 1;
    DescentWatch watch(progress, evaluator);
    settings.callbacks.push_back(&watch);
    ceres::Solver::Summary summary;
    FLAGS_minloglevel = google::GLOG_FATAL;   // Ceres prints whole residual vectors where a model could not be run; the report says it
    ceres::Solve(settings, &problem, &summary);
    message = summary.message;
    return summary.termination_type;
}

/// A descent along secants may end where they lead nowhere though the cost falls: it starts again from there with the exact Jacobian
/// until that finds no more than the tolerance, or so many times.
constexpr int most_descents = 8;

}  // namespace

LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals, const LeastSquaresOptions& options,
                                     const Progress& progress) {
    return fit_least_squares(parameters, residuals, {}, options, progress);
}

LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals, const JacobianFunction& jacobian,
                                     const LeastSquaresOptions& options, const Progress& progress) {
    LeastSquaresReport report;
    const auto n = static_cast<Eigen::Index>(parameters.size());
    report.start.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) report.start(i) = parameters[static_cast<std::size_t>(i)].value;
    report.values = report.start;
    Evaluator evaluator(parameters, residuals, jacobian, progress, options, report);
    std::vector<double> internal;
    for (const Parameter& parameter : parameters) internal.push_back(internal_value(parameter, parameter.value));

    const VectorXd origin = evaluator.physical(internal.data());
    if (jacobian && options.jacobian_guess.size() > 0 && options.jacobian_guess.allFinite()) evaluator.adopt(origin, options.jacobian_guess);
    const ResidualEvaluation first = evaluator.with_jacobian(origin);
    set_covariance(parameters, first, report);
    if (!first.ok) {
        report.status = progress.cancelled() ? FitStatus::cancelled : FitStatus::failed;
        report.message = first.message;
        return report;
    }
    report.jacobian = first.jacobian;
    if (n == 0) {
        report.status = FitStatus::converged;
        return report;
    }

    for (int descents = 0; descents < most_descents; ++descents) {
        const double before = report.cost_after;
        const ceres::TerminationType end = descend(evaluator, static_cast<int>(first.residuals.size()), options, progress, internal, report.message);
        if (progress.cancelled()) {
            report.status = FitStatus::cancelled;
            report.message = "stopped by the user";
            break;
        }
        report.status = end == ceres::CONVERGENCE ? FitStatus::converged : FitStatus::not_converged;
        if (report.converged()) report.message.clear();
        const bool interrupted = end == ceres::USER_SUCCESS;
        if (!jacobian || !(report.converged() || interrupted) || (report.converged() && evaluator.knows_the_end())) break;
        if (!evaluator.with_jacobian(report.values, true).ok) break;
        if (!interrupted && before - report.cost_after <= options.relative_decrease * before) break;
        for (std::size_t i = 0; i < internal.size(); ++i) internal[i] = internal_value(parameters[i], report.values(static_cast<Eigen::Index>(i)));
    }
    const ResidualEvaluation best = evaluator.best();
    report.jacobian = best.jacobian;
    set_covariance(parameters, best, report);
    return report;
}

}  // namespace myo
