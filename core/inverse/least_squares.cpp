#include "inverse/least_squares.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "inverse/fit_evaluations.hpp"
#include "inverse/reused_jacobian.hpp"

namespace myo::inverse {
namespace {

using Eigen::VectorXd;

/// Adapter to Ceres, which requests residuals first and the Jacobian only for an accepted update. The parameter block
/// contains the moved parameters; the others keep their place in `internal`.
class ResidualBlock final : public ceres::CostFunction {
public:
    ResidualBlock(const std::vector<Parameter>& parameters, const VectorXd& internal,
                  const std::vector<Eigen::Index>& moved, FitEvaluations& evaluations, ReusedJacobian& jacobian,
                  int residuals)
        : parameters_(parameters), internal_(internal), moved_(moved), evaluations_(evaluations), jacobian_(jacobian) {
        set_num_residuals(residuals);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(moved.size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        VectorXd internal = internal_;
        internal(moved_) = Eigen::Map<const VectorXd>(blocks[0], static_cast<Eigen::Index>(moved_.size()));
        const VectorXd values = physical_values(parameters_, internal);
        const ResidualEvaluation& evaluation = evaluations_.at(values);
        if (!evaluation.ok || evaluation.residuals.size() != num_residuals()) return false;
        std::copy(evaluation.residuals.begin(), evaluation.residuals.end(), residuals);
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
            const Eigen::MatrixXd J = jacobian_.at(values, evaluation);
            if (J.size() == 0) return false;
            const VectorXd slopes = physical_slopes(parameters_, internal);
            Eigen::Map<RowMajor>(jacobians[0], J.rows(),
                                 static_cast<Eigen::Index>(moved_.size())) = J(Eigen::all, moved_) *
                                                                             slopes(moved_).asDiagonal();
        }
        return true;
    }

private:
    const std::vector<Parameter>& parameters_;
    VectorXd internal_;
    std::vector<Eigen::Index> moved_;
    FitEvaluations& evaluations_;
    ReusedJacobian& jacobian_;
};

/// Ends a cancelled fit, and one whose updates change the cost by no more than the rounding of the model: Ceres counts
/// a update with a small gain as convergence, but keeps shortening one with an equally small loss.
class EndFit final : public ceres::IterationCallback {
public:
    EndFit(const Progress& progress, double relative_decrease)
        : progress_(progress), relative_decrease_(relative_decrease) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
        if (progress_.cancelled()) return ceres::SOLVER_ABORT;
        const bool vain = step.step_is_valid && !step.step_is_successful &&
                          std::abs(step.cost_change) <= relative_decrease_ * step.cost;
        return vain ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
    }

private:
    const Progress& progress_;
    double relative_decrease_;
};

/// Ceres options; the dense QR suits few parameters and many residuals.
ceres::Solver::Options solver_settings(const LeastSquaresOptions& options) {
    ceres::Solver::Options settings;
    settings.linear_solver_type = ceres::DENSE_QR;
    settings.logging_type = ceres::SILENT;
    settings.max_num_iterations = options.max_evaluations;
    settings.function_tolerance = options.relative_decrease;
    settings.parameter_tolerance = options.relative_step;
    settings.gradient_tolerance = 1e-12;
    settings.initial_trust_region_radius = 1e4;
    settings.num_threads = 1;
    return settings;
}

/// Optimises the parameters `moved` from their present values; `internal` returns the result.
ceres::Solver::Summary move_numbers(const std::vector<Parameter>& parameters, const std::vector<Eigen::Index>& moved,
                                    int residuals, const LeastSquaresOptions& options, const Progress& progress,
                                    FitEvaluations& evaluations, ReusedJacobian& jacobian, VectorXd& internal) {
    VectorXd block = internal(moved);
    ceres::Problem problem;
    problem.AddResidualBlock(new ResidualBlock(parameters, internal, moved, evaluations, jacobian, residuals), nullptr,
                             block.data());
    for (std::size_t k = 0; k < moved.size(); ++k) {
        const Parameter& parameter = parameters[static_cast<std::size_t>(moved[k])];
        if (std::isfinite(parameter.lower))
            problem.SetParameterLowerBound(block.data(), static_cast<int>(k),
                                           internal_value(parameter, parameter.lower));
        if (std::isfinite(parameter.upper))
            problem.SetParameterUpperBound(block.data(), static_cast<int>(k),
                                           internal_value(parameter, parameter.upper));
    }
    ceres::Solver::Options settings = solver_settings(options);
    EndFit end(progress, options.relative_decrease);
    settings.callbacks.push_back(&end);
    ceres::Solver::Summary summary;
    FLAGS_minloglevel = google::GLOG_FATAL;  // otherwise Ceres prints whole residual vectors of failed runs
    ceres::Solve(settings, &problem, &summary);
    internal(moved) = block;
    return summary;
}

}  // namespace

LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const LeastSquaresOptions& options, const Progress& progress) {
    return fit_least_squares(parameters, residuals, {}, options, progress);
}

LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const JacobianFunction& jacobian, const LeastSquaresOptions& options,
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
    ReusedJacobian derivatives(parameters, jacobian, options, progress, report);
    ResidualEvaluation first = evaluations.at(physical_values(parameters, internal));
    if (first.ok) {
        first.jacobian = derivatives.at(report.start, first);
        if (n > 0 && first.jacobian.size() == 0) {
            first.ok = false;
            first.message = "the model could not be run near these values";
        }
    }
    set_covariance(parameters, first, report);
    if (!first.ok) {
        report.status = progress.cancelled() ? FitStatus::cancelled : FitStatus::failed;
        report.message = first.message;
        return report;
    }
    report.jacobian = first.jacobian;
    std::vector<Eigen::Index> moved = sufficient_parameters(parameters, first.jacobian, {});
    if (moved.empty()) {
        report.status = FitStatus::converged;
        return report;
    }
    ceres::Solver::Summary summary;
    ResidualEvaluation best;
    while (true) {
        summary = move_numbers(parameters, moved, static_cast<int>(first.residuals.size()), options, progress,
                               evaluations, derivatives, internal);
        // A parameter without influence at the start may have one at the solution, e.g. the axis of a tilt that was
        // zero at first: continue with it.
        best = evaluations.best();
        best.jacobian = derivatives.at(report.values, best);
        if (progress.cancelled() || best.jacobian.size() == 0) break;
        std::vector<Eigen::Index> more = sufficient_parameters(parameters, best.jacobian, moved);
        if (more.size() == moved.size()) break;
        moved = std::move(more);
    }

    if (progress.cancelled()) {
        report.status = FitStatus::cancelled;
        report.message = "stopped by the user";
    } else if (summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS) {
        report.status = FitStatus::converged;
    } else {
        report.status = FitStatus::not_converged;
        report.message = summary.message;
    }
    best.ok = best.jacobian.size() > 0;
    report.jacobian = best.jacobian;
    set_covariance(parameters, best, report);
    return report;
}

}  // namespace myo::inverse
