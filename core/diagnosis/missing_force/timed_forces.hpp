#pragma once

#include <Eigen/Core>

#include <vector>

#include "fibre/signal.hpp"
#include "model/force_element.hpp"

namespace myo::diagnosis {

/// Force of fixed direction and distribution with a magnitude that follows a course over time.
struct TimedForce {
    Eigen::Matrix3Xd pattern;  // 3 x n [N per unit of the course]
    fibre::Signal course;
};

/// Sum of the forces, each multiplied by `factor`; the factors are the parameters of the element.
model::ForceElementPointer timed_forces(std::vector<TimedForce> forces, double factor = 1.0);

}  // namespace myo::diagnosis
