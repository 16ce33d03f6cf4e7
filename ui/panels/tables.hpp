#pragma once

#include <string>
#include <vector>

#include "platform/theme.hpp"

// Cells and headings of tables, and texts that fit into them.

namespace myo::ui::panels {

/// Stands in a cell where there is no number.
inline constexpr const char* dash = "\xe2\x80\x93";

/// As much of a text as fits, with an ellipsis where some is left out.
std::string elided(const std::string& text, float width);
/// The same for text that wraps.
std::string elided_lines(const std::string& text, float width, int lines);

/// Right-aligned.
void number_cell(const platform::Theme& theme, const std::string& text, const ImVec4* color = nullptr);
/// A cell that may be narrower than its text; the whole is shown on hovering.
void text_cell(const platform::Theme& theme, const std::string& text, const ImVec4& color);

struct Heading {
    std::string title;
    std::string tip;
    bool number = false;
};
/// A column of numbers, as wide as its heading; flags of ImGuiTableColumnFlags_ beside that.
void number_column(const platform::Theme& theme, const Heading& heading, int flags = 0);
void heading_row(const platform::Theme& theme, const std::vector<Heading>& headings);

}  // namespace myo::ui::panels
