#pragma once

#include <string>

#include "effect/effect.hpp"
#include "experiment/experiment.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// What a new effect is placed by.
struct NewEffectPlace {
    Box body;             // bounds of the body at rest [m]
    double time_s = 0.0;  // within the first trial, for events
};

/// An effect with a start value for each parameter, optional ones included: the middle of the range of plausible
/// amounts, forces at the free end of the body, everything else in its middle, directions by gravity, and the first
/// marker, trial or actuator. A name that the experiment lacks is the name of the parameter, which the reader refuses.
effect::EffectDeclaration new_effect(const effect::Effect& effect, const Experiment& experiment,
                                     const NewEffectPlace& place);

/// What the experiment lacks for the effect to act at all, as "a tendon", for messages; empty: nothing.
std::string lacking_for(const effect::Effect& effect, const Experiment& experiment);

}  // namespace myo::experiment
