#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace myo::test {

inline constexpr double hidden = std::numeric_limits<double>::quiet_NaN();

/// Five markers along a beam that is let go at 0.2 s and swings in two modes, its tip by 30 mm; 100 Hz.
inline std::vector<Eigen::Matrix3Xd> swinging_markers(double noise_m, unsigned seed, Eigen::Index samples = 120) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<Eigen::Matrix3Xd> tracks;
    for (int m = 0; m < 5; ++m) {
        const double s = 0.2 + 0.2 * m;
        Eigen::Matrix3Xd track(3, samples);
        for (Eigen::Index t = 0; t < samples; ++t) {
            const double time = std::max(0.0, 0.01 * static_cast<double>(t) - 0.2);
            const double first = 1.0 - std::exp(-2.0 * time) * std::cos(18.0 * time),
                         second = std::exp(-5.0 * time) * std::sin(70.0 * time);
            const double down_m = -0.015 * s * s * first + 0.003 * std::sin(4.0 * s) * second;
            track.col(t) = Eigen::Vector3d(0.12 * s - 3.0 * down_m * down_m, 0.03 * (m % 2), 0.01 + down_m);
            for (int axis = 0; axis < 3; ++axis) track(axis, t) += noise_m * noise(random);
        }
        tracks.push_back(track);
    }
    return tracks;
}

/// Hides the samples [first, end).
inline void hide(Eigen::Matrix3Xd& track, Eigen::Index first, Eigen::Index end) {
    track.middleCols(first, end - first).setConstant(hidden);
}

}  // namespace myo::test
