#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace myo::dynamics {

/// Where a smooth motion goes next: the parabola through its last three positions. Starts anew where loads jump, and
/// holds its tongue where the velocity changes by two fifths of itself between the positions: the steps do not resolve
/// the motion.
class Extrapolation {
public:
    void restart(double time_s, const Eigen::Matrix3Xd& x) {
        points_.clear();
        add(time_s, x);
    }

    void clear() { points_.clear(); }
    bool known() const { return !points_.empty(); }

    void add(double time_s, const Eigen::Matrix3Xd& x) {
        if (points_.size() == 3) points_.erase(points_.begin());
        points_.emplace_back(time_s, x);
    }

    /// Nothing when fewer than three positions are known or they are too far apart.
    std::optional<Eigen::Matrix3Xd> at(double time_s) const {
        if (points_.size() < 3) return std::nullopt;
        const auto velocity = [&](std::size_t k) -> Eigen::Matrix3Xd {
            return (points_[k + 1].second - points_[k].second) / (points_[k + 1].first - points_[k].first);
        };
        const Eigen::Matrix3Xd before = velocity(0), last = velocity(1);
        if ((last - before).norm() > 0.4 * std::max(last.norm(), before.norm())) return std::nullopt;
        return parabola_at(time_s);
    }

    /// The parabola through the last three, whatever the motion does; the straight line or the position where fewer are
    /// known.
    Eigen::Matrix3Xd parabola_at(double time_s) const {
        Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, points_.back().second.cols());
        for (const auto& [t, position] : points_) {
            double weight = 1.0;
            for (const auto& [other, unused] : points_)
                if (other != t) weight *= (time_s - other) / (t - other);
            x += weight * position;
        }
        return x;
    }

private:
    std::vector<std::pair<double, Eigen::Matrix3Xd>> points_;
};

}  // namespace myo::dynamics
