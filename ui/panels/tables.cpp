#include "panels/tables.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/widgets.hpp"

namespace myo::ui::panels {
namespace {

/// The longest beginning of a text that `fits` accepts, with an ellipsis if something is left out. Bisection, as
/// measuring a text is expensive.
template <class Fits>
std::string shortened(const std::string& text, const Fits& fits) {
    if (text.empty() || fits(text)) return text;
    const auto cut = [&](std::size_t length) {
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80)
            --length;  // not within a UTF-8 character
        return text.substr(0, length) + "\xe2\x80\xa6";
    };
    // Lengths in bytes; `cut` moves back to the beginning of a character.
    std::size_t shortest = 0, longest = text.size() - 1;
    while (shortest < longest) {
        const std::size_t middle = (shortest + longest + 1) / 2;
        if (fits(cut(middle)))
            shortest = middle;
        else
            longest = middle - 1;
    }
    return shortest > 0 ? cut(shortest) : std::string();
}

}  // namespace

// Both texts keep as many characters as there is room for; the caller shows the complete text in a tooltip.
std::string elided(const std::string& text, float width) {
    return shortened(text, [&](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x <= width; });
}

std::string elided_lines(const std::string& text, float width, int lines) {
    // Half a line of tolerance for rounding in the text height.
    const float height = (static_cast<float>(lines) + 0.5f) * ImGui::GetTextLineHeight();
    return shortened(text, [&](const std::string& part) {
        return ImGui::CalcTextSize(part.c_str(), nullptr, false, width).y <= height;
    });
}

void number_cell(const platform::Theme& theme, const std::string& text, const ImVec4* color) {
    ImGui::TableNextColumn();
    // Without room the text begins at the left, so that its first digits are seen.
    const float space = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (space > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + space);
    ImGui::TextColored(color ? *color : theme.text, "%s", text.c_str());
}

void text_cell(const platform::Theme& theme, const std::string& text, const ImVec4& color) {
    ImGui::TableNextColumn();
    const std::string shown = elided(text, ImGui::GetContentRegionAvail().x);
    ImGui::TextColored(color, "%s", shown.c_str());
    if (shown != text) tooltip(theme, text);
}

bool begin_side_table(const char* id, int columns) {
    // The table is wider than the panel's content by its padding, so that its texts align with the rows above.
    const float margin = ImGui::GetStyle().CellPadding.x, width = ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - margin);
    return ImGui::BeginTable(id, columns, ImGuiTableFlags_RowBg | ImGuiTableFlags_PadOuterX,
                             {width + 2.0f * margin, 0.0f});
}

// At least 40 pixels at scale 1, so that numbers fit below short titles.
void number_column(const platform::Theme& theme, const Heading& heading, int flags) {
    const float width = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, heading.title.c_str()).x;
    ImGui::TableSetupColumn(heading.title.c_str(), ImGuiTableColumnFlags_WidthFixed | flags,
                            std::ceil(std::max(width, 40.0f * theme.scale)) + 2.0f);
}

void heading_row(const platform::Theme& theme, const std::vector<Heading>& headings) {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(theme.small);
    for (const Heading& heading : headings) {
        if (heading.number)
            number_cell(theme, heading.title, &theme.muted);
        else {
            ImGui::TableNextColumn();
            ImGui::TextColored(theme.muted, "%s", heading.title.c_str());
        }
        // The heading font is small; tooltips have the regular one.
        ImGui::PushFont(theme.regular);
        tooltip(theme, heading.tip);
        ImGui::PopFont();
    }
    ImGui::PopFont();
}

}  // namespace myo::ui::panels
