#pragma once

#include <cmath>
#include <random>

#include "measurement/recording.hpp"

namespace myo::test {

/// A body at rest that is let go and rings down: three markers that move and three that do not.
struct SyntheticTake {
    int samples = 500;
    double rate_Hz = 100.0;
    double start_s = 1.003;
    double amplitude_m = 0.01;
    double frequency_Hz = 6.0;
    double damping_1_s = 1.5;
    double drift_m_per_s = 0.0;  // of the held body
    double noise_m = 5e-6;
    unsigned seed = 1;
};

inline measurement::Recording make_take(const SyntheticTake& take) {
    std::mt19937 generator(take.seed);
    std::normal_distribution<double> noise(0.0, take.noise_m);
    measurement::Recording recording;
    recording.rate_Hz = take.rate_Hz;
    recording.time_s = Eigen::VectorXd::LinSpaced(take.samples, 0.0, (take.samples - 1) / take.rate_Hz);
    for (int i = 0; i < 6; ++i) {
        recording.labels.push_back((i < 3 ? "tip " : "base ") + std::to_string(i % 3 + 1));
        const Eigen::Vector3d place(0.1 * i, 0.05 - 0.03 * i, 0.02 * i * i);
        const double share = i < 3 ? 1.0 - 0.1 * i : 0.0;
        Eigen::Matrix3Xd track(3, take.samples);
        for (int t = 0; t < take.samples; ++t) {
            const double since = recording.time_s(t) - take.start_s;
            // From rest to a lower equilibrium: starts as t^2, as any body that is let go.
            const double omega = 2.0 * M_PI * take.frequency_Hz;
            const double d = since <= 0.0
                                 ? 0.0
                                 : take.amplitude_m * (1.0 - std::exp(-take.damping_1_s * since) *
                                                                 (std::cos(omega * since) +
                                                                  take.damping_1_s / omega * std::sin(omega * since)));
            const double drift = share * take.drift_m_per_s * std::min(recording.time_s(t), take.start_s);
            // One statement each: compilers order the arguments of one call differently.
            const double z = noise(generator), y = noise(generator), x = noise(generator);
            track.col(t) = place + share * d * Eigen::Vector3d(0.3, 0.1, -0.95) +
                           drift * Eigen::Vector3d(0.0, 1.0, 0.2) + Eigen::Vector3d(x, y, z);
        }
        recording.tracks.push_back(std::move(track));
    }
    return recording;
}

/// Every fifth sample shows the one before again, as in a polled stream.
inline void poll(measurement::Recording& recording) {
    for (Eigen::Matrix3Xd& track : recording.tracks) {
        for (Eigen::Index t = 5; t < track.cols(); t += 5) track.col(t) = track.col(t - 1);
    }
}

/// Rounds all positions to multiples of `step`.
inline void quantise(measurement::Recording& recording, double step) {
    for (Eigen::Matrix3Xd& track : recording.tracks) track = (track / step).array().round() * step;
}

}  // namespace myo::test
