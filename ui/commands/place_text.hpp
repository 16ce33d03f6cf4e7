#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::ui::commands {

/// A place [m] as it is written into a declaration: to 0.1 um, as the view computes with single precision and its
/// further digits mean nothing.
Eigen::Vector3d written_place(const Eigen::Vector3d& place_m);

/// TOML array of written_place().
std::string place_text(const Eigen::Vector3d& place_m);

}  // namespace myo::ui::commands
