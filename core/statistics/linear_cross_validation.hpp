#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/folds.hpp"

namespace myo::statistics {

struct LinearCrossValidation {
    struct Fold {
        double squares = 0.0;  // of the predicted held-out residual
        Eigen::Index samples = 0;
        Eigen::VectorXd change;  // p: of the parameters, without this fold
        int undetermined = 0;    // directions of which the other folds know little or nothing; they stay as fitted
    };
    std::vector<Fold> folds;
    double squares = 0.0;  // all folds together
    Eigen::Index samples = 0;
    Eigen::VectorXd residual;  // N: predicted from the other folds; NaN where in no fold

    /// Over all folds.
    int undetermined() const;

    double mean_square() const { return samples > 0 ? squares / static_cast<double>(samples) : 0.0; }
};

/// Cross-validation without refitting: from the fitted point one Gauss-Newton step on the data without a fold, and its
/// residual there to first order. Exact for linear models.
///
/// What one fold alone tells of (a start time, the pose of a trial, an effect that acts in one trial) stays as fitted,
/// which flatters it: the fold then tests the other parameters. Little is less than a thousandth of the information
/// that all folds have on a direction.
/// @param r, J  N and N x p at the fitted point, see ResidualLayout
/// Source: Hastie, Tibshirani & Friedman 2009, ch. 7.10.
LinearCrossValidation linear_cross_validation(const Eigen::VectorXd& r, const Eigen::MatrixXd& J, const Folds& folds);

}  // namespace myo::statistics
