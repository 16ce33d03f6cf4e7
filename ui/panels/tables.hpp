#pragma once

#include <string>
#include <vector>

#include "platform/theme.hpp"

// Cells and headings of tables, and texts shortened to their width.
//
// A table is written as: ImGui::BeginTable(); one TableSetupColumn() or number_column() per column; heading_row(); then
// per row ImGui::TableNextRow() and one cell function per column; ImGui::EndTable(). Texts use the current font.

namespace myo::ui::panels {

/// Shown in a cell that has no number.
inline constexpr const char* dash = "\xe2\x80\x93";

/// Shortens a text to a width [pixels], with an ellipsis if something is left out. May be empty. Uses the current font.
std::string elided(const std::string& text, float width);
/// Shortens a text that wraps at `width` [pixels] to a number of lines.
std::string elided_lines(const std::string& text, float width, int lines);

/// Next cell of a table, right-aligned.
///
/// @param color  null: the colour of text
void number_cell(const platform::Theme& theme, const std::string& text, const ImVec4* color = nullptr);
/// Next cell of a table, shortened to its width; the tooltip contains the whole text.
void text_cell(const platform::Theme& theme, const std::string& text, const ImVec4& color);

/// Heading of a table column.
struct Heading {
    std::string title;    // with unit: "rms [mm]"
    std::string tip;      // tooltip; may be empty
    bool number = false;  // right-aligned, as its numbers
};
/// Begins a table of the side panel whose texts stand below those of other rows; its highlights reach beyond them.
/// Returns false if it is not drawn; otherwise the caller ends it with ImGui::EndTable().
bool begin_side_table(const char* id, int columns);
/// Declares a column of numbers as wide as its heading.
///
/// @param flags  further ImGuiTableColumnFlags_
void number_column(const platform::Theme& theme, const Heading& heading, int flags = 0);
/// Draws the row of headings. Call it after the columns were declared.
void heading_row(const platform::Theme& theme, const std::vector<Heading>& headings);

}  // namespace myo::ui::panels
