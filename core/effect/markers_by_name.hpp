#pragma once

#include "effect/effect.hpp"

namespace myo::effect {

/// Index of a marker on the body; -1 if no marker has this name.
/// Fixed markers have no index: they are not bound to the body.
int marker_number(const TrialContext& context, const std::string& name);

}  // namespace myo::effect
