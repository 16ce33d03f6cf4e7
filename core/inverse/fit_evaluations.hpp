#pragma once

#include "base/throttle.hpp"
#include "inverse/least_squares.hpp"

namespace myo::inverse {

/// The number that a fit moves, in units of what matters, and back, to the last bit at the parameter's own value; and
/// the derivative of the way back.
double internal_value(const Parameter& p, double value);
double physical_value(const Parameter& p, double internal);
double physical_slope(const Parameter& p, double internal);

/// The same for all numbers of a fit.
Eigen::VectorXd physical_values(const std::vector<Parameter>& parameters, const Eigen::VectorXd& internal);
Eigen::VectorXd physical_slopes(const std::vector<Parameter>& parameters, const Eigen::VectorXd& internal);

/// How far the numbers may go at once from where they are, in what a fit moves: to their bounds, and over decades by a
/// factor of e squared.
struct StepBounds {
    Eigen::VectorXd lower, upper;
};
StepBounds internal_step_bounds(const std::vector<Parameter>& parameters, const Eigen::VectorXd& internal);

/// The evaluations of a fit: each point once, the best one kept, all of them in the report and its progress.
class FitEvaluations {
public:
    /// All are kept by reference.
    FitEvaluations(const ResidualFunction& function, const LeastSquaresOptions& options, const Progress& progress,
                   LeastSquaresReport& report);

    /// The residuals there; not ok where the model could not be run, or the fit was cancelled. Holds until the third
    /// new point after it.
    const ResidualEvaluation& at(const Eigen::VectorXd& values);

    /// With the least cost so far.
    const ResidualEvaluation& best() const { return best_; }

private:
    struct Point {
        Eigen::VectorXd values;
        ResidualEvaluation evaluation;
    };

    const ResidualFunction& function_;
    const Progress& progress_;
    double most_evaluations_;
    LeastSquaresReport& report_;
    Throttle throttle_;  // of what is shown within evaluations, however short these are
    std::string last_words_;
    ResidualEvaluation best_;
    std::vector<Point> latest_;
    ResidualEvaluation stopped_{false, "stopped by the user", {}, {}};
};

/// Sets the report's deviations, correlations and undetermined parameters from the Jacobian of an evaluation, see
/// identifiability().
void set_covariance(const std::vector<Parameter>& parameters, const ResidualEvaluation& end,
                    LeastSquaresReport& report);

}  // namespace myo::inverse
