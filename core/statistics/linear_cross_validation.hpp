#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/folds.hpp"

namespace myo::statistics {

/// Result of linear_cross_validation().
struct LinearCrossValidation {
    /// Prediction of one held-out fold from the others.
    struct Fold {
        double squares = 0.0;      // sum of squares of the predicted held-out residual
        Eigen::Index samples = 0;  // entries of the fold
        Eigen::VectorXd change;    // p: parameter change when this fold is left out
        int undetermined = 0;      // directions that the other folds barely determine; kept at the fitted value
    };
    std::vector<Fold> folds;
    double squares = 0.0;      // sum over the folds
    Eigen::Index samples = 0;  // sum over the folds
    Eigen::VectorXd residual;  // N: predicted from the other folds; NaN for entries in no fold

    /// Sum over the folds.
    int undetermined() const;

    /// Mean squared prediction error; 0 without samples.
    double mean_square() const { return samples > 0 ? squares / static_cast<double>(samples) : 0.0; }
};

/// Cross-validation without refitting: one Gauss-Newton step from the fitted point on the data without a fold, and the
/// held-out residual to first order. Exact for linear models.
///
/// A parameter that only one fold identifies (a start time, the pose of a trial, an effect in one trial) keeps its
/// fitted value. This flatters that fold, which then tests the other parameters. A direction counts as undetermined if
/// the other folds hold less than a thousandth of the information of all folds.
/// @param r      N, residual at the fitted point, see ResidualLayout
/// @param J      N x p, Jacobian at the fitted point
/// @param folds  partition of the N entries
/// Source: Hastie, Tibshirani & Friedman 2009, ch. 7.10.
LinearCrossValidation linear_cross_validation(const Eigen::VectorXd& r, const Eigen::MatrixXd& J, const Folds& folds);

}  // namespace myo::statistics
