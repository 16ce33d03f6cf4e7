#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Short interval of one trial that holds most of the squared residual.
struct ResidualSpot {
    int trial = 0;
    std::vector<int> markers;         // markers with nearly all of the squares in the interval, ascending
    double from_s = 0.0, to_s = 0.0;  // interval
    double share = 0.0;               // of the squares of all trials
};

/// Shortest interval of a trial with four fifths of the squares of all trials, if it is at most a quarter of that
/// trial.
///
/// Localised residuals point to data faults (swapped or touched markers) or to a single event. A missing force law acts
/// as long as the body moves.
/// @param r  N, see ResidualLayout
/// @return   empty if the residual is not localised
std::optional<ResidualSpot> residual_spot(const Eigen::VectorXd& r, const ResidualLayout& layout);

}  // namespace myo::statistics
