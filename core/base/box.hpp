#pragma once

#include <Eigen/Core>

namespace myo {

/// Axis-aligned box; also the schema's `box_m`.
struct Box {
    Eigen::Vector3d lowest = Eigen::Vector3d::Zero();
    Eigen::Vector3d highest = Eigen::Vector3d::Zero();

    bool contains(const Eigen::Vector3d& point) const {
        return (point.array() >= lowest.array()).all() && (point.array() <= highest.array()).all();
    }
    Eigen::Vector3d size() const { return highest - lowest; }
};

}  // namespace myo
