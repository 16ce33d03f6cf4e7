#pragma once

#include <Eigen/Core>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Test whether the residuals of different markers are independent in time. A missing force moves many markers at the
/// same time; measurement errors act on each marker separately.
struct IndependenceTest {
    // p-value of a pattern across markers as strong as the observed, under independent courses; Bonferroni over trials.
    // 0 if no trial can be tested
    double p = 0.0;
    double typical_share = 0.0;   // systematic mean square of the median marker over the mean of all markers: near 1 if
                                  // all are similar, near 0 if few dominate
    double constant_share = 1.0;  // constant share of the systematic squares; constants cannot be tested here

    /// Classifies the residual as measurement drift: uncorrelated between markers, present in most markers and varying
    /// in time.
    bool is_drift() const { return p > 0.01 && typical_share > 0.25 && constant_share < 0.5; }
};
/// Circular-shift test on the largest singular value of the (series x samples) matrix of each trial, mean of each
/// series removed.
///
/// Null distribution: the three coordinates of a marker are shifted together in time, circularly and by a random lag
/// per marker. This preserves the autocorrelation of each marker and destroys the correlation between markers. Trials
/// with fewer than three markers are skipped.
/// @param r      N, see ResidualLayout
/// @param draws  size of the null sample
/// @param seed   of the random lags; the same seed gives the same result
IndependenceTest independence_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws = 199,
                                   unsigned seed = 1);

}  // namespace myo::statistics
