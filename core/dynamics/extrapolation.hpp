#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace myo::dynamics {

/// Predictor for the next stage: quadratic extrapolation of the last three positions.
///
/// restart() forgets the history, as is necessary at a jump of the loads. at() returns no prediction if the velocity
/// changes by more than 40 % between the two intervals, because the steps then do not resolve the motion.
class Extrapolation {
public:
    /// Discards the history and starts with one position, x: 3 x n [m].
    void restart(double time_s, const Eigen::Matrix3Xd& x) {
        points_.clear();
        add(time_s, x);
    }

    void clear() { points_.clear(); }
    bool known() const { return !points_.empty(); }

    /// Appends a position; only the last three are kept. Times must differ.
    void add(double time_s, const Eigen::Matrix3Xd& x) {
        if (points_.size() == 3) points_.erase(points_.begin());
        points_.emplace_back(time_s, x);
    }

    /// Extrapolated positions, 3 x n [m]; nullopt with fewer than three positions or an unresolved motion.
    std::optional<Eigen::Matrix3Xd> at(double time_s) const {
        if (points_.size() < 3) return std::nullopt;
        const auto velocity = [&](std::size_t k) -> Eigen::Matrix3Xd {
            return (points_[k + 1].second - points_[k].second) / (points_[k + 1].first - points_[k].first);
        };
        const Eigen::Matrix3Xd before = velocity(0), last = velocity(1);
        if ((last - before).norm() > 0.4 * std::max(last.norm(), before.norm())) return std::nullopt;
        return parabola_at(time_s);
    }

    /// Lagrange polynomial through the known positions: quadratic with three of them, linear with two, constant with
    /// one. No check of the velocity change; needs at least one position.
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
    std::vector<std::pair<double, Eigen::Matrix3Xd>> points_;  // (time [s], positions), oldest first
};

}  // namespace myo::dynamics
