#pragma once

#include <string>
#include <vector>

#include "platform/item_rectangles.hpp"

namespace myo::test {

/// A piece of text as it was drawn in the last frame: letters that follow each other on one line.
struct DrawnText {
    std::string window;            // ImGui's name of the window that drew it
    std::string text;              // without spaces that are narrower than a few pixels
    ui::platform::Rectangle part;  // visible part [pixels]
    bool cut = false;              // letters are cut off at the left or right
};

/// All visible text of the last frame, read from the triangles that ImGui has made of it. Text that is scrolled out of
/// sight at the top or bottom is left out. A text cut exactly between two letters counts as whole.
std::vector<DrawnText> drawn_text();

/// Descriptions of the texts that are cut, and of pairs of one window that lie over each other by more than two pixels.
std::vector<std::string> text_defects(const std::vector<DrawnText>& texts);

}  // namespace myo::test
