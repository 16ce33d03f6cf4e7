#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// A short time of one trial that holds most of a residual.
struct ResidualSpot {
    int trial = 0;
    std::vector<int> markers;  // that make nearly all of it there, rising
    double from_s = 0.0, to_s = 0.0;
    double share = 0.0;  // of the squares of all trials
};

/// The shortest time of a trial that holds four fifths of the squares of all trials, where it is at most a quarter of
/// that trial. Faults of the data gather so (markers taken for each other or touched), and what acts once; a law that
/// the model lacks acts as long as the body moves.
std::optional<ResidualSpot> residual_spot(const Eigen::VectorXd& r, const ResidualLayout& layout);

}  // namespace myo::statistics
