#pragma once

#include "effect/effect.hpp"

namespace myo::effect {

/// Number of a marker on the body; -1 where there is none of this name.
int marker_number(const EffectSite& site, const std::string& name);

}  // namespace myo::effect
