#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/folds.hpp"

namespace myo {

/// What is known of the parameters besides the data: independent and normal.
struct ParameterPrior {
    Eigen::VectorXd precision;    // p, 1 / deviation^2; 0: nothing is known. Empty: of none
    Eigen::VectorXd offset;       // p: mean of the prior - value at the fitted point. Empty: zeros
};

struct LinearCrossValidation {
    struct Fold {
        double squares = 0.0;         // of the predicted held-out residual
        Eigen::Index samples = 0;
        Eigen::VectorXd change;       // p: of the parameters, without this fold
        int undetermined = 0;         // directions that the other folds leave free; they stay as fitted
    };
    std::vector<Fold> folds;
    double squares = 0.0;         // all folds together
    Eigen::Index samples = 0;
    Eigen::VectorXd residual;     // N: predicted from the other folds; NaN where in no fold

    double mean_square() const { return samples > 0 ? squares / static_cast<double>(samples) : 0.0; }
};

/// Cross-validation without refitting: from the fitted point one Gauss-Newton step on the data without a fold, and its
/// residual there to first order. Exact for linear models.
///
/// A parameter that acts in one fold only (a start time, the pose of a trial) is not determined without it and stays as
/// fitted, which flatters it; a prior takes it back to its mean instead.
/// @param r, J  N and N x p at the fitted point, see ResidualLayout
/// Source: Hastie, Tibshirani & Friedman 2009, ch. 7.10.
LinearCrossValidation linear_cross_validation(const Eigen::VectorXd& r, const Eigen::MatrixXd& J, const Folds& folds,
                                              const ParameterPrior& prior = {});

}  // namespace myo
