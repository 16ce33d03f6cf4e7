#include "experiment/goal.hpp"

#include <algorithm>
#include <cassert>

namespace myo::experiment {

Eigen::Vector3d place_at(const GoalDeclaration& goal, double time_s) {
    assert(goal.times_s.size() > 0 && goal.times_s.size() == goal.places_m.cols());
    const auto next = std::upper_bound(goal.times_s.begin(), goal.times_s.end(), time_s) - goal.times_s.begin();
    // upper_bound() finds the first knot after the time, so knot next - 1 is at or before it.
    if (next == 0) return goal.places_m.col(0);
    if (next == goal.times_s.size()) return goal.places_m.rightCols<1>();
    const double share = (time_s - goal.times_s(next - 1)) / (goal.times_s(next) - goal.times_s(next - 1));
    return (1.0 - share) * goal.places_m.col(next - 1) + share * goal.places_m.col(next);
}

}  // namespace myo::experiment
