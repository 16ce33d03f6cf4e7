#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/fit_data.hpp"
#include "planning/planning_policy.hpp"

namespace myo::planning {

/// Rows of a stacked residual that share one numerical error: those of a trial.
struct ErrorBlock {
    Eigen::Index begin = 0, size = 0;
};

/// Blocks of a flat residual, one per trial, with `offset` rows before them.
std::vector<ErrorBlock> error_blocks(const statistics::ResidualLayout& layout, Eigen::Index offset = 0);

/// Noncentrality of the test for a difference d of predictions in units of the noise:
/// |d|^2 / (1 + e^2 sum_b n_b |u_b|^2) with u = d / |d|.
///
/// The noise is white. The numerical error has the rms e in each block of n_b rows, is independent between blocks, and
/// lies wholly along d there, which is the worst case. Rows outside of all blocks have none.
/// @param numerical_error  e [noise levels, 1 sigma]
double noncentrality(const Eigen::VectorXd& d, const std::vector<ErrorBlock>& blocks, double numerical_error);

/// Probability with which the chi^2 test of level alpha rejects, for a noncentrality. alpha for 0.
/// @param freedom  degrees of freedom: number of directions that the test allows, > 0
/// Source: Patnaik 1949, Biometrika 36, 202.
double detection_probability(double noncentrality, double freedom, double alpha);

/// Noncentrality with which the test rejects with a probability: inverse of detection_probability().
/// At most DetectionPolicy::most_noncentrality.
double needed_noncentrality(double probability, double freedom, const DetectionPolicy& policy);

}  // namespace myo::planning
