#pragma once

#include <vector>

namespace myo::model {
struct Model;
}  // namespace myo::model

namespace myo::setup {

/// Angular frequency [rad/s] of the slowest natural vibration about the straight, passive body; 0 where none is found,
/// as of a body that turns freely.
double first_vibration_rad_s(const model::Model& model);

/// Angular frequencies [rad/s] of the `count` slowest natural vibrations about the straight, passive body, ascending;
/// empty where none are found.
std::vector<double> slowest_vibrations_rad_s(const model::Model& model, int count);

}  // namespace myo::setup
