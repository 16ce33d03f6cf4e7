#pragma once

#include "model/force_element.hpp"
#include "model/mount_motion.hpp"

namespace myo::model {

// A body on a moving mount is simulated in the mount's frame, in which its clamped nodes stand still. Its internal
// forces are the same there. Inertia forces join them, and what is fixed in the laboratory is seen from the mount.

/// Inertia forces -M (a + spin_rate x r + spin x (spin x r) + 2 spin x V) of the moving frame, r from the pivot, and
/// the turn of weight and dead loads from the laboratory to the mount's frame.
///
/// A state without velocities is one at rest against a mount at rest: only weight and loads are turned. Directional
/// masses turn with the mount.
/// @param model   masses, weight and loads are those of this model; later changes of it are not followed
/// @param motion  not null
/// Parameter: density_kg_m3, of the body in these forces alone; the derivative by the density of the body is that by
/// the model's density plus this one.
/// Source: Goldstein, Poole, Safko 2002, Classical Mechanics, 4.10.
ForceElementPointer mount_forces(const Model& model, MountMotionPointer motion);

/// A force element of the laboratory (drag of the air at rest, a stop, an obstacle) that acts on a body in the mount's
/// frame: it is given positions and velocities in the laboratory. Parameters are those of the element.
///
/// @param element  without a command
/// @param motion   not null
ForceElementPointer in_laboratory(ForceElementPointer element, MountMotionPointer motion);

}  // namespace myo::model
