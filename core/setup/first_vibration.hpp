#pragma once

#include <vector>

namespace myo::model {
struct Model;
}  // namespace myo::model

namespace myo::setup {

/// Lowest natural angular frequency [rad/s] about the straight, passive body; 0 if none is found, e.g. for a body that
/// can rotate freely, or after a cancellation. Undamped.
double first_vibration_rad_s(const model::Model& model);

/// The `count` lowest natural angular frequencies [rad/s] about the straight, passive body, ascending; empty if none
/// are found.
std::vector<double> slowest_vibrations_rad_s(const model::Model& model, int count);

}  // namespace myo::setup
