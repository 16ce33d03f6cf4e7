#pragma once

#include <string>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// Features that an experiment needs to show an effect.
struct EffectNeeds {
    bool muscles = false;
    bool deep_clamp = false;   // otherwise clamped at the face
    bool hung_weight = false;  // a permanent force
    bool known_damping = false;
    bool straight_start = false;
};

/// How an effect of the catalogue is drawn and scaled.
struct EffectDraw {
    EffectNeeds needs;
    std::string amount;                  // parameter that scales it; empty: not scalable
    double lowest = 0.0, highest = 0.0;  // plausible range of the amount
    bool grows = true;                   // a larger amount has a larger effect
    effect::EffectParameters (*others)(const SyntheticCase&, RandomStream&) = nullptr;  // all parameters but the amount
    double (*most)(const SyntheticCase&) = nullptr;  // limit of the amount for a body; null: highest
};

/// Largest amount of the case's own effect, which must be in the catalogue.
double most_amount(const SyntheticCase& c);

/// Draw of an effect, or null if the id is unknown.
const EffectDraw* find_effect_draw(const std::string& id);

/// The effect with random parameters; its amount is the geometric mean of the plausible range, with a random sign if it
/// may be negative.
effect::EffectDeclaration drawn_effect(const std::string& id, const SyntheticCase& body_and_trials,
                                       RandomStream& random);

/// Absolute amount of an effect, and the effect with another amount; a vector keeps its direction.
double effect_amount(const effect::EffectDeclaration& effect);
effect::EffectDeclaration with_amount(effect::EffectDeclaration effect, double amount);

}  // namespace myo::validation
