#pragma once

#include <string>
#include <vector>

#include "effect/effect.hpp"
#include "law/law.hpp"

namespace myo::effect {

/// What the file of a law states.
struct LawStatement {
    std::string id;
    std::string sentence;  // for people
    law::Law law;
    std::vector<EffectParameterEntry> parameters;  // one per parameter of the law, in its order
    std::vector<EffectParameters> starts;          // of all parameters, where searches begin; one or more
    std::string amount;                            // number of which multiples are tried; empty: none
    bool absent_at_infinity = false;               // the law does nothing at an infinite amount, instead of at 0
};

/// Entry of a law, in addition to those of the catalogue. Laws at points have the parameter `position_m` as well, laws
/// of signals the optional parameter `signal`. Asserts a start, and one parameter entry per parameter of the law. The
/// law is compiled once and shared by all runs.
Effect law_effect(LawStatement statement);

}  // namespace myo::effect
