#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "inverse/identifiability.hpp"

namespace myo::inverse {

/// A scalar unknown of a fit.
struct Parameter {
    std::string name;    // with its unit, e.g. youngs_modulus_Pa
    double value = 0.0;  // start value
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    double scale = 1.0;  // a change of this size matters
    /// Non-negative with unknown order of magnitude: the fit moves ln(1 + value / scale), so that its updates are
    /// relative.
    bool over_decades = false;

    /// Equal bounds: the value is exact and not moved.
    bool is_fixed() const { return !(lower < upper); }
};

/// Residuals r (m), in units of their standard deviation, and J = dr/dp (m x n) at p.
struct ResidualEvaluation {
    bool ok = false;  // false: the model could not be run; the optimiser retreats
    std::string message;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
};

/// One evaluation at `values`. Its own progress (`done` of `total` in any unit) becomes its share of the progress of
/// the fit; it may report from several threads. If the progress is cancelled, it stops and returns ok = false.
using ResidualFunction = std::function<ResidualEvaluation(const Eigen::VectorXd& values, const Progress& progress)>;

/// J = dr/dp (m x n) at values that have been evaluated, for models whose derivatives cost more than their residuals.
/// Empty result: the model could not be run, or the fit was cancelled.
using JacobianFunction = std::function<Eigen::MatrixXd(const Eigen::VectorXd& values, const ResidualEvaluation& there,
                                                       const Progress& progress)>;

/// Outcome of a fit.
enum class FitStatus { not_run, converged, not_converged, cancelled, failed };

/// One evaluation of a fit.
struct FitIterate {
    Eigen::VectorXd values;
    double cost = 0.0;     // |r|^2 / 2; infinite if the model could not be run
    double seconds = 0.0;  // duration of the evaluation

    /// Whether the model could be run.
    bool ok() const { return cost < std::numeric_limits<double>::infinity(); }
};

/// Result of a fit with n parameters and m residuals.
struct LeastSquaresReport {
    FitStatus status = FitStatus::not_run;
    std::string message;
    Eigen::VectorXd start;   // start values, n
    Eigen::VectorXd values;  // values with the least cost; the first ones if several are equal
    /// Standard deviations; NaN: not determined by the data, 0: fixed.
    Eigen::VectorXd deviations;
    Eigen::MatrixXd correlation;             // n x n
    std::vector<Undetermined> undetermined;  // parameters without a deviation, with the reason
    double cost_before = 0.0;                // at the start
    double cost_after = 0.0;                 // at `values`
    Eigen::MatrixXd jacobian;                // m x n at `values`, or nearby if it was requested separately
    int evaluations = 0;                     // complete ones
    int jacobians = 0;                       // requested separately
    std::vector<FitIterate> history;         // all complete evaluations, in order

    /// Whether a convergence criterion was met.
    bool converged() const { return status == FitStatus::converged; }
    /// Whether at least one evaluation succeeded. The fit may have been stopped or not have converged.
    bool usable() const {
        return std::any_of(history.begin(), history.end(), [](const FitIterate& iterate) { return iterate.ok(); });
    }
};

/// Options of the fits.
struct LeastSquaresOptions {
    int max_evaluations = 60;
    double relative_decrease = 1e-6;  // convergence criterion for the cost
    double relative_step = 1e-6;      // convergence criterion for the parameters
    /// A Jacobian is reused as long as it predicts the change of the residuals since its evaluation within this
    /// relative error. At the end of a fit it may be wrong by twice as much, and the values by some hundredths of a
    /// standard deviation.
    double max_prediction_error = 0.02;
    Eigen::MatrixXd
        jacobian_guess;        // fit_by_secants(): approximate m x n Jacobian at the start, saves one evaluation of it
    int max_jacobians = 1000;  // fit_by_secants(): limit of requested Jacobians; afterwards secant updates only
};

/// Minimises |r(p)|^2 within bounds: Levenberg-Marquardt (Ceres) with exact Jacobians, one run of the model per
/// evaluation.
///
/// Only a sufficient subset of the parameters is moved, see sufficient_parameters(): one without influence stays at its
/// start value, and of a linearly dependent set all but the redundant ones move. Otherwise errors of the derivatives
/// would drive them anywhere. If a parameter becomes influential at the solution, the fit continues with it.
///
/// Deviations: (J'J)^-1 at the end, restricted to what the data determine (identifiability()), times the residual
/// variance if that exceeds 1. In that case the model does not explain the data to within their noise, and the noise
/// alone would underestimate the deviations.
///
/// @param progress  counts evaluations, the running one as a fraction; at most ten reports per second
/// Errors: cancelled or not_converged with the best values so far and their deviations; failed if the model could not
/// be run at the start.
/// Source: Nocedal & Wright 2006, ch. 10; Ceres Solver.
LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const LeastSquaresOptions& options = {}, const Progress& progress = {});

/// Least squares for models whose derivatives dominate the cost: `residuals` omits them, and the fit requests a
/// Jacobian only where the last one does not predict the residuals (LeastSquaresOptions::max_prediction_error).
LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const JacobianFunction& jacobian, const LeastSquaresOptions& options,
                                     const Progress& progress);

/// Least squares for Jacobians that cost many evaluations. `residuals` omits derivatives.
///
/// The fit requests a Jacobian at the start, and wherever the last one, updated by Broyden's secant formula, predicts
/// an update badly. At the end it requests one unless the last requested Jacobian predicts the way from there to 10 %.
/// Source: Broyden 1965, Math. Comp. 19; Madsen, Nielsen & Tingleff 2004, Methods for non-linear least squares
/// problems, 3.4.
LeastSquaresReport fit_by_secants(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                  const JacobianFunction& jacobian, const LeastSquaresOptions& options,
                                  const Progress& progress);

}  // namespace myo::inverse
