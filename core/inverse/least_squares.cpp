#include "inverse/least_squares.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include "inverse/fit_evaluations.hpp"

namespace myo {
namespace {

using Eigen::VectorXd;

/// Ceres asks first for residuals, then, when it accepts the step, for the Jacobian.
class ResidualBlock final : public ceres::CostFunction {
public:
    ResidualBlock(const std::vector<Parameter>& parameters, FitEvaluations& evaluations, int residuals) : parameters_(parameters), evaluations_(evaluations) {
        set_num_residuals(residuals);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters.size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        const VectorXd internal = Eigen::Map<const VectorXd>(blocks[0], static_cast<Eigen::Index>(parameters_.size()));
        const ResidualEvaluation& evaluation = evaluations_.at(physical_values(parameters_, internal));
        if (!evaluation.ok || evaluation.residuals.size() != num_residuals()) return false;
        std::copy(evaluation.residuals.begin(), evaluation.residuals.end(), residuals);
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
            Eigen::Map<RowMajor>(jacobians[0], evaluation.jacobian.rows(), evaluation.jacobian.cols()) =
                evaluation.jacobian * physical_slopes(parameters_, internal).asDiagonal();
        }
        return true;
    }

private:
    const std::vector<Parameter>& parameters_;
    FitEvaluations& evaluations_;
};

/// Ends a fit that was cancelled, and one whose steps change the cost by no more than the model's own rounding: Ceres counts a step that gains
/// little as convergence, but goes on shortening one that loses as little.
class EndFit final : public ceres::IterationCallback {
public:
    EndFit(const Progress& progress, double relative_decrease) : progress_(progress), relative_decrease_(relative_decrease) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
        if (progress_.cancelled()) return ceres::SOLVER_ABORT;
        const bool vain = step.step_is_valid && !step.step_is_successful && std::abs(step.cost_change) <= relative_decrease_ * step.cost;
        return vain ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
    }

private:
    const Progress& progress_;
    double relative_decrease_;
};

}  // namespace

LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals, const LeastSquaresOptions& options,
                                     const Progress& progress) {
    LeastSquaresReport report;
    const auto n = static_cast<Eigen::Index>(parameters.size());
    report.start.resize(n);
    VectorXd internal(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
        report.start(i) = parameter.value;
        internal(i) = internal_value(parameter, parameter.value);
    }
    report.values = report.start;
    FitEvaluations evaluations(residuals, options, progress, report);
    const ResidualEvaluation first = evaluations.at(physical_values(parameters, internal));
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

    ceres::Problem problem;
    problem.AddResidualBlock(new ResidualBlock(parameters, evaluations, static_cast<int>(first.residuals.size())), nullptr, internal.data());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Parameter& parameter = parameters[i];
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
    EndFit end(progress, options.relative_decrease);
    settings.callbacks.push_back(&end);
    ceres::Solver::Summary summary;
    FLAGS_minloglevel = google::GLOG_FATAL;   // Ceres prints whole residual vectors where a model could not be run; the report says it
    ceres::Solve(settings, &problem, &summary);

    if (progress.cancelled()) {
        report.status = FitStatus::cancelled;
        report.message = "stopped by the user";
    } else if (summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS) {
        report.status = FitStatus::converged;
    } else {
        report.status = FitStatus::not_converged;
        report.message = summary.message;
    }
    report.jacobian = evaluations.best().jacobian;
    set_covariance(parameters, evaluations.best(), report);
    return report;
}

}  // namespace myo
