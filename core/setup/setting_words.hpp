#pragma once

// Names of settings for messages: the option of the command line and the place in the window, so that a message is
// valid for both.

namespace myo::setup {

inline constexpr const char* step_setting = "--dt, or Step h of Run in the window";
inline constexpr const char* edge_setting = "--resolution, or Edge length of Mesh in the window";

}  // namespace myo::setup
