#pragma once

#include <vector>

namespace myo {

struct Model;

/// Angular frequency [rad/s] of the slowest natural vibration about the straight, passive body; 0 where none is found,
/// as of a body that turns freely.
double first_vibration_rad_s(const Model& model);

/// Of the `count` slowest ones, ascending; empty where none are found.
std::vector<double> slowest_vibrations_rad_s(const Model& model, int count);

}  // namespace myo
