#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace myo::ui::platform {

/// Folders in which fonts are installed: those of the system, then those of the user.
std::vector<std::filesystem::path> font_folders();

/// Fonts with Chinese, Japanese and Korean letters, each file name once, those with the most letters first. Folders
/// that are not there are left out.
///
/// @param folders  searched with all folders in them
std::vector<std::string> wide_fonts(const std::vector<std::filesystem::path>& folders);

/// What makes these letters visible, as a sentence for the user.
inline constexpr const char* wide_font_hint =
    "Some names have letters that no font of this machine has; a question mark in a diamond stands for each. Install "
    "fonts-noto-cjk or fonts-wqy-microhei and start the program again.";

}  // namespace myo::ui::platform
