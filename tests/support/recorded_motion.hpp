#pragma once

#include <gtest/gtest.h>

#include <random>

#include "prediction/prediction.hpp"

namespace myo::test {

/// Replaces the measured tracks of a trial by a simulated motion plus white noise of the declared size.
///
/// @param values  parameters that the motion was simulated with
/// @param seed  of the noise
inline void record(setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                   const dynamics::Trace& trace, unsigned seed = 1) {
    ASSERT_TRUE(trace.complete()) << trace.message;
    const prediction::TrialPrediction seen = prediction::observe_trial(setup, trial, values, trace);
    // The noise has the size that the experiment declares, so a correct model leaves a residual of this size.
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise;
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
        Eigen::Matrix3Xd& track = setup.trials[trial].measured.tracks[m];
        track = seen.positions_m[m];
        for (double& x : track.reshaped()) x += setup.noise_m(static_cast<Eigen::Index>(m)) * noise(random);
    }
}

}  // namespace myo::test
