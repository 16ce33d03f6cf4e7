#pragma once

#include "effect/effect.hpp"

namespace myo::effect {

/// Index of a marker on the body; -1 if no marker has this name.
int marker_number(const EffectSite& site, const std::string& name);

}  // namespace myo::effect
