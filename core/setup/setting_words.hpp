#pragma once

// Where settings are chosen, in words that hold on the command line and in the window.

namespace myo::setup {

inline constexpr const char* step_setting = "--dt, or Step h of Run in the window";
inline constexpr const char* edge_setting = "--resolution, or Edge length of Mesh in the window";

}  // namespace myo::setup
