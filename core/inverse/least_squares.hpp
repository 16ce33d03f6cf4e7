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

/// A number to be found.
struct Parameter {
    std::string name;    // with its unit: "youngs_modulus_Pa"
    double value = 0.0;  // start
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    double scale = 1.0;  // a change of this size matters
    /// Of values from 0 over decades: the fit moves ln(1 + value / scale), so that its steps are shares of the value.
    bool over_decades = false;

    /// The bounds are one value: exact, a fit does not move it.
    bool is_fixed() const { return !(lower < upper); }
};

/// Residuals r (m) in units of their standard deviation and J = dr/dp (m x n) at p.
struct ResidualEvaluation {
    bool ok = false;  // false: the model could not be run there; the optimiser steps back
    std::string message;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
};

/// One evaluation. What it reports, `done` of `total` in any unit, becomes its share of the fit's progress; it may
/// report from several threads, and stops when the progress is cancelled (ok = false then).
using ResidualFunction = std::function<ResidualEvaluation(const Eigen::VectorXd& values, const Progress& progress)>;

/// J = dr/dp (m x n) at values that were evaluated, where it costs more than the residuals. Empty: the model could not
/// be run, or the fit was cancelled.
using JacobianFunction = std::function<Eigen::MatrixXd(const Eigen::VectorXd& values, const ResidualEvaluation& there,
                                                       const Progress& progress)>;

enum class FitStatus { not_run, converged, not_converged, cancelled, failed };

struct FitIterate {
    Eigen::VectorXd values;
    double cost = 0.0;     // |r|^2 / 2; infinite where the model could not be run
    double seconds = 0.0;  // of the evaluation

    bool ok() const { return cost < std::numeric_limits<double>::infinity(); }
};

struct LeastSquaresReport {
    FitStatus status = FitStatus::not_run;
    std::string message;
    Eigen::VectorXd start;
    Eigen::VectorXd values;  // of the evaluation with the least cost: the first of these, where several are equal
    /// Standard deviations; NaN where the data do not determine the parameter, 0 where it is fixed.
    Eigen::VectorXd deviations;
    Eigen::MatrixXd correlation;             // n x n
    std::vector<Undetermined> undetermined;  // the parameters without a deviation
    double cost_before = 0.0;
    double cost_after = 0.0;
    Eigen::MatrixXd jacobian;         // m x n at the values, or near them where it was asked for apart
    int evaluations = 0;              // complete ones
    int jacobians = 0;                // asked for apart
    std::vector<FitIterate> history;  // every complete evaluation, in order

    bool converged() const { return status == FitStatus::converged; }
    /// There are values from at least one evaluation, though the fit may have been stopped or not have converged.
    bool usable() const {
        return std::any_of(history.begin(), history.end(), [](const FitIterate& iterate) { return iterate.ok(); });
    }
};

struct LeastSquaresOptions {
    int max_evaluations = 60;
    double relative_decrease = 1e-6;  // of the cost, below which it has converged
    double relative_step = 1e-6;      // of the parameters
    /// A Jacobian is used again while it foretells the change of the residuals since it was worked out but for this
    /// share. A fit may end with one that is wrong by twice as much, and its values be off by some hundredths of a
    /// standard deviation.
    double most_surprise = 0.02;
    Eigen::MatrixXd jacobian_guess;  // of fit_by_secants(): m x n at the start, about; saves asking for one there
    int most_jacobians = 1000;       // of fit_by_secants(): asked for apart; after these secants have to do
};

/// Minimises |r(p)|^2 within bounds: Levenberg-Marquardt by Ceres on exact Jacobians, one run of the model per
/// evaluation.
///
/// Moved are parameters that suffice, see sufficient_parameters(): one without influence on the residuals stays at its
/// start, and of some that only act together all but one; with errors of derivatives as their only slopes they would go
/// anywhere. One that acts by itself where the others ended is fitted from there.
///
/// Cancelled or not converged, it gives the best values so far, with their deviations; status failed means that the
/// model could not be run at the start. Progress counts evaluations, with the running one as a fraction, at most ten
/// times a second.
///
/// Deviations: (J'J)^-1 at the end, on what the data determine (identifiability()), times the residual variance where
/// that exceeds 1 (the model does not explain the data to their noise, so the noise alone would promise too much).
/// Source: Nocedal & Wright 2006, ch. 10; Ceres Solver.
LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const LeastSquaresOptions& options = {}, const Progress& progress = {});

/// Least squares where derivatives take most of an evaluation: `residuals` leaves them out, and the fit asks for them
/// at those of its points whose residuals the last Jacobian did not foretell from where it was worked out.
LeastSquaresReport fit_least_squares(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                     const JacobianFunction& jacobian, const LeastSquaresOptions& options,
                                     const Progress& progress);

/// For Jacobians that cost many evaluations: `residuals` leaves them out, and the fit asks for one at the start, and
/// for one wherever the last, turned by the secants of the steps since, foretells a step badly; at the end, where the
/// last one that was asked for did not foretell the way from there to a tenth.
///
/// Source: Broyden 1965, Math. Comp. 19; Madsen, Nielsen & Tingleff 2004, Methods for non-linear least squares
/// problems, 3.4.
LeastSquaresReport fit_by_secants(const std::vector<Parameter>& parameters, const ResidualFunction& residuals,
                                  const JacobianFunction& jacobian, const LeastSquaresOptions& options,
                                  const Progress& progress);

}  // namespace myo::inverse
