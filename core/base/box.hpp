#pragma once

#include <Eigen/Core>

namespace myo {

/// Axis-aligned box; the keys `box_m` of experiment.toml are read into it.
struct Box {
    Eigen::Vector3d lowest = Eigen::Vector3d::Zero();   // [m] corner with the smallest coordinates
    Eigen::Vector3d highest = Eigen::Vector3d::Zero();  // [m] corner with the largest coordinates

    /// @return  true for points inside the box and on its boundary
    bool contains(const Eigen::Vector3d& point) const {
        return (point.array() >= lowest.array()).all() && (point.array() <= highest.array()).all();
    }
    Eigen::Vector3d size() const { return highest - lowest; }
    bool operator==(const Box& other) const { return lowest == other.lowest && highest == other.highest; }
};

}  // namespace myo
