#pragma once

#include <Eigen/Core>

#include <vector>

#include "fibre/signal.hpp"
#include "model/force_element.hpp"

namespace myo::diagnosis {

/// A force of fixed direction and distribution whose size follows a course over time.
struct TimedForce {
    Eigen::Matrix3Xd pattern;  // 3 x n [N per unit of the course]
    fibre::Signal course;
};

/// All of them times one factor each; the factors are the parameters.
model::ForceElementPointer timed_forces(std::vector<TimedForce> forces, double factor = 1.0);

}  // namespace myo::diagnosis
