#pragma once

#include "base/throttle.hpp"
#include "inverse/least_squares.hpp"

namespace myo::inverse {

/// Transformation of a parameter to the internal value that the optimiser moves: value / scale, or ln(1 + value /
/// scale) over decades. physical_value() is the inverse, exact to the last bit at the parameter's own value;
/// physical_slope() is its derivative.
double internal_value(const Parameter& p, double value);
/// Inverse of internal_value(); exact to the last bit at the parameter's own value.
double physical_value(const Parameter& p, double internal);
/// Derivative of physical_value() with respect to the internal value.
double physical_slope(const Parameter& p, double internal);

/// The same for all parameters.
Eigen::VectorXd physical_values(const std::vector<Parameter>& parameters, const Eigen::VectorXd& internal);
/// physical_slope() of all parameters.
Eigen::VectorXd physical_slopes(const std::vector<Parameter>& parameters, const Eigen::VectorXd& internal);

/// Bounds of a single update in internal values: up to the bounds of the parameters, and at most a factor of
/// e squared for parameters over decades.
struct StepBounds {
    Eigen::VectorXd lower, upper;
};
/// Bounds of the next update at the given internal values. Zero is always within them.
StepBounds internal_step_bounds(const std::vector<Parameter>& parameters, const Eigen::VectorXd& internal);

/// Evaluations of a fit. Repeated points are evaluated once; the best one is kept; all are entered in report and
/// progress.
class FitEvaluations {
public:
    /// Keeps references to all arguments.
    FitEvaluations(const ResidualFunction& function, const LeastSquaresOptions& options, const Progress& progress,
                   LeastSquaresReport& report);

    /// Residuals at `values`; not ok if the model could not be run or the fit was cancelled. The reference is valid
    /// until the third new point after it.
    const ResidualEvaluation& at(const Eigen::VectorXd& values);

    /// Evaluation with the least cost so far.
    const ResidualEvaluation& best() const { return best_; }

private:
    struct Point {
        Eigen::VectorXd values;
        ResidualEvaluation evaluation;
    };

    const ResidualFunction& function_;
    const Progress& progress_;
    double max_evaluations_;
    LeastSquaresReport& report_;
    Throttle throttle_;  // limits progress reports from within evaluations
    std::string last_words_;
    ResidualEvaluation best_;
    std::vector<Point> latest_;
    ResidualEvaluation stopped_{false, "stopped by the user", {}, {}};
};

/// Sets deviations, correlations and undetermined parameters of the report from the Jacobian of an evaluation; see
/// identifiability(). If `end` is not ok, all deviations are NaN.
void set_covariance(const std::vector<Parameter>& parameters, const ResidualEvaluation& end,
                    LeastSquaresReport& report);

}  // namespace myo::inverse
