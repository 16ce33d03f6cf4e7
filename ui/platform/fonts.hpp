#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "platform/theme.hpp"

namespace myo::ui::platform {

/// Icons of Font Awesome 4.7 as UTF-8 strings, to be put in front of a label. Drawn as replacement characters if
/// load_fonts() found no icon font.
namespace icon {
inline constexpr const char* folder = "\xef\x81\xbc";         // f07c
inline constexpr const char* closed_folder = "\xef\x81\xbb";  // f07b
inline constexpr const char* file = "\xef\x80\x96";           // f016
inline constexpr const char* play = "\xef\x81\x8b";           // f04b
inline constexpr const char* pause = "\xef\x81\x8c";          // f04c
inline constexpr const char* to_start = "\xef\x81\x89";       // f049
inline constexpr const char* stop = "\xef\x81\x8d";           // f04d
inline constexpr const char* warning = "\xef\x81\xb1";        // f071
inline constexpr const char* failure = "\xef\x81\x97";        // f057
inline constexpr const char* information = "\xef\x81\x9a";    // f05a
inline constexpr const char* done = "\xef\x81\x98";           // f058
inline constexpr const char* cube = "\xef\x86\xb2";           // f1b2
inline constexpr const char* sliders = "\xef\x87\x9e";        // f1de
inline constexpr const char* rocket = "\xef\x84\xb5";         // f135
inline constexpr const char* target = "\xef\x81\x9b";         // f05b
inline constexpr const char* undo = "\xef\x83\xa2";           // f0e2
inline constexpr const char* redo = "\xef\x80\x9e";           // f01e
inline constexpr const char* expand = "\xef\x82\xb2";         // f0b2
inline constexpr const char* up = "\xef\x81\xa2";             // f062
inline constexpr const char* list = "\xef\x80\xba";           // f03a
inline constexpr const char* eye = "\xef\x81\xae";            // f06e
inline constexpr const char* chart = "\xef\x88\x81";          // f201
inline constexpr const char* stethoscope = "\xef\x83\xb1";    // f0f1
inline constexpr const char* plus = "\xef\x81\xa7";           // f067
inline constexpr const char* brush = "\xef\x87\xbc";          // f1fc
inline constexpr const char* eraser = "\xef\x84\xad";         // f12d
inline constexpr const char* drop = "\xef\x81\x83";           // f043
inline constexpr const char* bolt = "\xef\x83\xa7";           // f0e7
inline constexpr const char* hand = "\xef\x89\x95";           // f255
inline constexpr const char* line_chart = "\xef\x88\x81";     // f201
inline constexpr const char* clock = "\xef\x80\x97";          // f017
inline constexpr const char* tasks = "\xef\x82\xae";          // f0ae
inline constexpr const char* grid = "\xef\x80\x8a";           // f00a
inline constexpr const char* flask = "\xef\x83\x83";          // f0c3
inline constexpr const char* camera = "\xef\x80\xbd";         // f03d
inline constexpr const char* report = "\xef\x85\x9c";         // f15c
inline constexpr const char* check = "\xef\x80\x8c";          // f00c
inline constexpr const char* stale = "\xef\x80\xa1";          // f021
inline constexpr const char* save = "\xef\x83\x87";           // f0c7
inline constexpr const char* star = "\xef\x80\x85";           // f005
inline constexpr const char* empty_star = "\xef\x80\x86";     // f006
inline constexpr const char* home = "\xef\x80\x95";           // f015
inline constexpr const char* shield = "\xef\x84\xb2";         // f132
inline constexpr const char* arrow = "\xef\x81\xa1";          // f061
inline constexpr const char* remove = "\xef\x80\x8d";         // f00d
}  // namespace icon

/// Font files found on this system. An empty text_file means that ImGui's built-in font is used; an empty icon_file
/// means that icons are missing.
struct FontReport {
    std::string text_file;  // full path
    std::string icon_file;  // full path
};

/// Builds the font atlas of the current ImGui context through FreeType and stores the fonts in the theme, at sizes
/// multiplied by theme.scale.
///
/// The text font is Inter, with DejaVu Sans for glyphs that Inter lacks; DejaVu Sans alone if Inter is not installed;
/// ImGui's built-in font if neither is. The atlas owns the fonts: pointers in the theme are valid until the atlas is
/// cleared.
///
/// @param letters  further letters to load, as ranges of ImGui, ended by 0: those of names in other scripts. What no
///                 installed font has is drawn as U+FFFD. Must live until the atlas is built
FontReport load_fonts(Theme& theme, const std::vector<ImWchar>& letters = {});

/// Builds an atlas with only the theme's small font, for labels in exported images. The theme's other fonts become
/// null.
///
/// @param letters  as in load_fonts(); must live until the atlas is built
void load_label_font(Theme& theme, const std::vector<ImWchar>& letters = {});

}  // namespace myo::ui::platform
