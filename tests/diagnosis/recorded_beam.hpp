#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/diagnose_settings.hpp"
#include "effect/catalogue.hpp"
#include "prediction/predict_trials.hpp"
#include "support/swung_beam.hpp"

// A swung beam whose motion was simulated with effects, by the same simulator on the same mesh.

namespace myo::test {

/// The setup whose traces, which hold the markers at rest, are replaced by what these values give, with noise.
inline setup::Setup recorded(setup::Setup setup, const prediction::ParameterValues& truth) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const prediction::TrialPrediction made = prediction::predict_trial(setup, t, truth);
        EXPECT_TRUE(made.ok()) << made.message;
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            Eigen::Matrix3Xd& track = setup.trials[t].measured.tracks[m];
            track += made.residual_m[m];
            for (double& x : track.reshaped()) x += setup.noise_m(static_cast<Eigen::Index>(m)) * noise(random);
        }
    }
    return setup;
}

/// The beam whose traces hold a motion with the effects, and noise.
/// @param share_of_noise  factor on the noise of the swung beam, of the traces and as declared
inline setup::Setup recorded_with(const Folder& folder, const std::vector<effect::EffectDeclaration>& effects,
                                  double share_of_noise = 1.0) {
    setup::Setup setup = swung_beam(folder);
    setup.noise_m *= share_of_noise;
    prediction::ParameterValues truth = prediction::declared_values(setup);
    truth.youngs_modulus_Pa *= 1.08;
    truth.effects = effects;
    return recorded(std::move(setup), truth);
}

/// Few effects may be named, so that a test is short.
inline diagnosis::DiagnoseSettings among(const std::vector<std::string>& allowed) {
    diagnosis::DiagnoseSettings settings;
    settings.refine_mesh = false;
    for (const effect::Effect& effect : effect::effect_catalogue())
        if (std::find(allowed.begin(), allowed.end(), effect.id) == allowed.end())
            settings.without.push_back(effect.id);
    return settings;
}

inline std::vector<std::string> ids_of(const std::vector<effect::EffectDeclaration>& effects) {
    std::vector<std::string> ids;
    for (const effect::EffectDeclaration& effect : effects) ids.push_back(effect.id);
    return ids;
}

}  // namespace myo::test
