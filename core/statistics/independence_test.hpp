#pragma once

#include <Eigen/Core>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Does each marker go its own way? What a force does to a body all markers show at the same time; what cameras make of
/// a marker, they make of that one.
struct IndependenceTest {
    double p = 0.0;  // chance of a pattern over the markers as strong as that of some trial, were their courses
                     // independent; Bonferroni. 0 where no trial can tell
    double typical_share = 0.0;   // systematic mean square of the median marker over their mean: near 1 where all do
                                  // alike, near 0 where few do much
    double constant_share = 1.0;  // of the systematic squares, what does not vary in time: of that nothing can be told
                                  // here

    /// Wander of the measurement, not of the body: in all markers, in each by itself, and as time goes on.
    bool is_drift() const { return p > 0.01 && typical_share > 0.25 && constant_share < 0.5; }
};
/// The largest singular value of the (series x samples) matrix of each trial, less the mean of each series, against
/// that of the same courses shifted in time, round its end, each marker's three together and by a random time of its
/// own: that keeps their colour and takes away what they share. Trials of fewer than three markers tell nothing.
IndependenceTest independence_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws = 199,
                                   unsigned seed = 1);

}  // namespace myo::statistics
