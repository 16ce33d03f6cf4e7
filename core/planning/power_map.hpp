#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "effect/effect.hpp"
#include "planning/planning_policy.hpp"
#include "setup/setup.hpp"

namespace myo::planning {

/// Whether an effect of one size would be detected.
struct SizePower {
    double size = 0.0;           // value of the amount, in its unit; NaN: the effect has none
    double change_m = 0.0;       // rms of its change of the markers that recalibration leaves
    double noncentrality = 0.0;  // of the score test
    double probability = 0.0;    // of detection
};

/// What an experiment could reveal of one effect.
struct EffectPower {
    std::string id;
    std::string amount;                // parameter that is its size; empty: it has none
    effect::EffectParameters example;  // with the middle size, at a place of median visibility
    std::vector<SizePower> sizes;      // from weak to strong
    std::optional<double> detected;    // weakest size that is detected with DetectionPolicy::wanted
    bool beyond_range = false;         // that size is weaker than the plausible range
    double kept = 0.0;                 // share of its change that recalibration does not absorb
    std::string confused_with;         // the effect whose change is most similar; empty: none is run
    double cosine = 0.0;               // between both changes after recalibration
    std::string unseen;                // why this experiment cannot show it; empty: it can
};

/// How a power map is made.
struct PowerSettings {
    std::optional<double> numerical_error_m;  // rms; default: DetectionPolicy::numerical_error times the noise
    std::vector<std::string> only = {};       // effects that are considered; empty: all
    PlanningPolicy policy = {};
};

/// What an experiment could reveal, before or after its recordings exist.
struct PowerMap {
    // False-alarm rate and probability that counts as detected, see DetectionPolicy.
    double alpha = 0.0, wanted = 0.0;
    double noise_m = 0.0, numerical_error_m = 0.0;  // rms
    std::vector<std::string> trials;                // that count
    std::vector<std::string> parameters;            // of the recalibration
    Eigen::Index samples = 0;                       // compared coordinates
    std::vector<EffectPower> effects;               // in the order of the catalogue
    int runs = 0;                                   // of trials
    double seconds = 0.0;
    bool stopped = false;  // by the user; the map is then empty
    std::string failure;   // why there is none; empty: it is complete
};

/// Power of score tests for every effect of the catalogue at sizes over its plausible range.
///
/// The trials to fit and those without a recording count, with the samples that they have; those to predict do not. The
/// model has its declared values; what a calibration would fit is projected out. An effect that has a place is judged
/// where its visibility is the median of the places that a diagnosis tries, one with a direction by the mean of its
/// noncentrality over directions. An effect is taken by itself and its place as known, so that a search, which tests
/// many, detects a little later. All sizes are run; `detected` is interpolated once more with a run there.
/// @return  `failure` if the declared model cannot be run or no marker is seen; nothing is thrown
/// Source: Rao 1948 (score test); noise: DetectionPolicy, noncentrality().
PowerMap power_map(const setup::Setup& setup, const PowerSettings& settings, const Progress& progress = {});

}  // namespace myo::planning
