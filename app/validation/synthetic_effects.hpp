#pragma once

#include <string>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// What an effect needs to show at all.
struct EffectNeeds {
    bool muscles = false;
    bool deep_clamp = false;   // others are held on a face
    bool hung_weight = false;  // a force that goes on
    bool known_damping = false;
    bool straight_start = false;
};

/// How an effect of the catalogue is drawn and made larger or smaller.
struct EffectDraw {
    EffectNeeds needs;
    std::string amount;                  // parameter that scales it; empty: it comes as it is
    double lowest = 0.0, highest = 0.0;  // plausible sizes of the amount
    bool grows = true;                   // larger with a larger amount
    effect::EffectParameters (*others)(const SyntheticCase&, RandomStream&) = nullptr;  // all but the amount
    double (*most)(const SyntheticCase&) = nullptr;  // that a body can have of it; null: as many as is plausible
};

/// The largest amount of a case's own effect, which is in the catalogue.
double most_amount(const SyntheticCase& c);

/// Null for an id that is not in the catalogue.
const EffectDraw* find_effect_draw(const std::string& id);

/// The effect with random parameters, its amount in the geometric middle of what is plausible, with a random sign where
/// it may have one.
effect::EffectDeclaration drawn_effect(const std::string& id, const SyntheticCase& body_and_trials,
                                       RandomStream& random);

/// Size of the effect's amount, and the effect with another; a vector keeps its direction.
double effect_amount(const effect::EffectDeclaration& effect);
effect::EffectDeclaration with_amount(effect::EffectDeclaration effect, double amount);

}  // namespace myo::validation
