#pragma once

#include <optional>
#include <vector>

#include "help/markdown.hpp"
#include "platform/theme.hpp"

namespace myo::ui::panels {

/// Draws a page into the current ImGui window, which scrolls.
///
/// @param shown  block to scroll to and to mark in this frame
void draw_markdown(const platform::Theme& theme, const std::vector<help::Block>& blocks,
                   std::optional<std::size_t> shown);

}  // namespace myo::ui::panels
