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

/// Evaluates once per point: Ceres asks first for residuals, then, when it accepts the step, for the Jacobian.
class Evaluator {
public:
    Evaluator(const std::vector<Parameter>& parameters, const ResidualFunction& function, const Progress& progress,
              const LeastSquaresOptions& options, LeastSquaresReport& report)
        : parameters_(parameters), function_(function), progress_(progress), shown_(progress, options.max_evaluations), report_(report) {}

    const ResidualEvaluation& at(const VectorXd& values) {
        for (const auto& [point, evaluation] : cache_)
            if (point == values) return evaluation;
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
        cache_.emplace_back(values, std::move(fresh));
        const ResidualEvaluation& evaluation = cache_.back().second;
        ++report_.evaluations;
        if (evaluation.ok) keep(iterate, evaluation);
        report_.history.push_back(std::move(iterate));
        last_words_ = quality_words(evaluation);
        shown_.report(report_.evaluations, last_words_);
        return evaluation;
    }

    /// The evaluation with the least cost so far.
    const ResidualEvaluation& best() const { return best_; }

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
    const Progress& progress_;
    EvaluationProgress shown_;
    LeastSquaresReport& report_;
    std::string last_words_;
    ResidualEvaluation best_;
    std::vector<std::pair<VectorXd, ResidualEvaluation>> cache_;
    const ResidualEvaluation stopped_{false, "stopped by the user", {}, {}};
};

class ResidualBlock final : public ceres::CostFunction {
public:
    ResidualBlock(Evaluator& evaluator, int residuals) : evaluator_(evaluator) {
        set_num_residuals(residuals);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(evaluator.parameters().size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        const ResidualEvaluation& evaluation = evaluator_.at(evaluator_.physical(blocks[0]));
        if (!evaluation.ok || evaluation.residuals.size() != num_residuals()) return false;
        std::copy(evaluation.residuals.begin(), evaluation.residuals.end(), residuals);
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
            Eigen::Map<RowMajor>(jacobians[0], evaluation.jacobian.rows(), evaluation.jacobian.cols()) =
                evaluation.jacobian * evaluator_.slopes(blocks[0]).asDiagonal();
        }
        return true;
    }

private:
    Evaluator& evaluator_;
};

class StopWhenCancelled final : public ceres::IterationCallback {
public:
    explicit StopWhenCancelled(const Progress& progress) : progress_(progress) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return progress_.cancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    const Progress& progress_;
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

}  // namespace

LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const LeastSquaresOptions& options, const Progress& progress) {
    LeastSquaresReport report;
    const auto n = static_cast<Eigen::Index>(parameters.size());
    report.start.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) report.start(i) = parameters[static_cast<std::size_t>(i)].value;
    report.values = report.start;
    Evaluator evaluator(parameters, residuals, progress, options, report);
    std::vector<double> internal;
    for (const Parameter& parameter : parameters) internal.push_back(internal_value(parameter, parameter.value));

    const ResidualEvaluation first = evaluator.at(evaluator.physical(internal.data()));
    set_covariance(parameters, first, report);
    if (!first.ok) {
        report.status = progress.cancelled() ? FitStatus::cancelled : FitStatus::failed;
        report.message = first.message;
        return report;
    }
    if (n == 0) {
        report.status = FitStatus::converged;
        return report;
    }

    ceres::Problem problem;
    problem.AddResidualBlock(new ResidualBlock(evaluator, static_cast<int>(first.residuals.size())), nullptr, internal.data());
    for (int i = 0; i < static_cast<int>(n); ++i) {
        const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
        if (std::isfinite(parameter.lower)) problem.SetParameterLowerBound(internal.data(), i, internal_value(parameter, parameter.lower));
        if (std::isfinite(parameter.upper)) problem.SetParameterUpperBound(internal.data(), i, internal_value(parameter, parameter.upper));
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
    StopWhenCancelled stop(progress);
    settings.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    FLAGS_minloglevel = google::GLOG_FATAL;   // Ceres prints whole residual vectors where a model could not be run; the report says it
    ceres::Solve(settings, &problem, &summary);

    if (progress.cancelled()) {
        report.status = FitStatus::cancelled;
        report.message = "stopped by the user";
    } else if (summary.termination_type == ceres::CONVERGENCE) {
        report.status = FitStatus::converged;
    } else {
        report.status = FitStatus::not_converged;
        report.message = summary.message;
    }
    set_covariance(parameters, evaluator.best(), report);
    return report;
}

}  // namespace myo
