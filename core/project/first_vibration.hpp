#pragma once

namespace myo {

struct Model;

/// Angular frequency [rad/s] of the slowest natural vibration about the straight, passive body; 0 where none is found,
/// as of a body that turns freely.
double first_vibration_rad_s(const Model& model);

}  // namespace myo
