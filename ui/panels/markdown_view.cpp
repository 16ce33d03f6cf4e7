#include "panels/markdown_view.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/wrapped_text.hpp"

namespace myo::ui::panels {
namespace {

using help::Block;

/// A heading; the two outer levels have the accent colour and more room above.
void draw_heading(const platform::Theme& theme, const Block& block) {
    ImGui::Dummy({0.0f, (block.level <= 2 ? 8.0f : 4.0f) * theme.scale});
    ImGui::PushFont(theme.strong);
    ImGui::PushStyleColor(ImGuiCol_Text, block.level <= 2 ? theme.accent : theme.text);
    wrapped_text(block.text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

/// An item of a list: its sign ends where the indent of its level does, so that texts align whatever the sign.
void draw_item(const platform::Theme& theme, const Block& block) {
    const float indent = (18.0f + 18.0f * static_cast<float>(block.level)) * theme.scale;
    ImGui::Dummy({indent - ImGui::CalcTextSize(block.sign.c_str()).x, 0.0f});
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextColored(theme.muted, "%s", block.sign.c_str());
    ImGui::SameLine(0.0f, 6.0f * theme.scale);
    wrapped_text(block.text);
}

/// Lines of code keep their breaks; long ones scroll sideways.
void draw_code(const platform::Theme& theme, const Block& block, std::size_t index) {
    const auto lines = 1 + std::count(block.text.begin(), block.text.end(), '\n');
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme.raised);
    ImGui::BeginChild(static_cast<ImGuiID>(index + 1),
                      {0.0f, static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() +
                                 ImGui::GetStyle().ScrollbarSize + 8.0f * theme.scale},
                      false, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::Dummy({0.0f, 0.0f});
    ImGui::Indent(8.0f * theme.scale);
    ImGui::TextUnformatted(block.text.c_str());
    ImGui::Unindent(8.0f * theme.scale);
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

/// Share of the width that a column gets: its longest text, within limits that keep short columns readable.
float column_weight(const Block& block, std::size_t column) {
    constexpr std::size_t least = 6, most = 40;
    std::size_t longest = least;
    for (const auto& row : block.rows)
        if (column < row.size()) longest = std::max(longest, row[column].size());
    return static_cast<float>(std::min(longest, most));
}

/// A table. Its first row is the heading, in the secondary colour.
void draw_table(const platform::Theme& theme, const Block& block, std::size_t index) {
    std::size_t columns = 0;
    // Rows may have different numbers of cells; the longest one decides.
    for (const auto& row : block.rows) columns = std::max(columns, row.size());
    if (columns == 0) return;
    ImGui::PushID(static_cast<int>(index));
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
    if (ImGui::BeginTable("table", static_cast<int>(columns), flags)) {
        for (std::size_t c = 0; c < columns; ++c)
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, column_weight(block, c));
        for (std::size_t r = 0; r < block.rows.size(); ++r) {
            ImGui::TableNextRow();
            for (const std::string& cell : block.rows[r]) {
                ImGui::TableNextColumn();
                ImGui::PushStyleColor(ImGuiCol_Text, r == 0 ? theme.muted : theme.text);
                wrapped_text(cell);
                ImGui::PopStyleColor();
            }
        }
        ImGui::EndTable();
    }
    ImGui::PopID();
}

/// @param index  of the block in the page: ImGui's id of code and tables
void draw_block(const platform::Theme& theme, const Block& block, std::size_t index) {
    switch (block.kind) {
        case Block::Kind::heading: return draw_heading(theme, block);
        case Block::Kind::item: return draw_item(theme, block);
        case Block::Kind::code: return draw_code(theme, block, index);
        case Block::Kind::table: return draw_table(theme, block, index);
        case Block::Kind::paragraph: return wrapped_text(block.text);
    }
}

}  // namespace

void draw_markdown(const platform::Theme& theme, const std::vector<Block>& blocks, std::optional<std::size_t> shown) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (shown == b) ImGui::SetScrollHereY(0.0f);
        draw_block(theme, blocks[b], b);
        if (blocks[b].kind != Block::Kind::item) ImGui::Spacing();
    }
}

}  // namespace myo::ui::panels
