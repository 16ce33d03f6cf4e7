#include "panels/start_page.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/file_dialogs.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// A large button with an icon, a title and some lines of text below the icon; next to it if the button is low.
///
/// @param picture_width  room that the text leaves at the right [pixels]
bool card(PanelContext& context, const std::string& item, const char* sign, const std::string& title,
          const std::string& text, const ImVec2& size, float picture_width = 0.0f) {
    const platform::Theme& theme = context.theme;
    const float s = theme.scale, pad = 14.0f * s;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(item.c_str(), size);
    context.items.mark(item);
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    list.AddRectFilled(at, end, platform::packed(hovered ? theme.hovered : theme.raised), 6.0f * s);
    list.AddRect(at, end, platform::packed(hovered ? theme.accent : theme.border), 6.0f * s);
    list.AddText(theme.large, theme.large->FontSize, {at.x + pad, at.y + pad}, platform::packed(theme.accent), sign);
    // A low card has no room for text below its icon.
    const bool low = size.y < 4.0f * theme.large->FontSize;
    const float left = at.x + pad + (low ? 2.0f * theme.large->FontSize : 0.0f),
                wrap = end.x - pad - picture_width - left;
    const float text_top = at.y + pad + (low ? 0.0f : 1.35f * theme.large->FontSize),
                body_top = text_top + 1.5f * theme.strong->FontSize;
    list.AddText(theme.strong, theme.strong->FontSize, {left, text_top}, platform::packed(theme.text),
                 elided(title, wrap).c_str());
    const int lines = std::max(1, static_cast<int>((end.y - pad - body_top) / theme.small->FontSize));
    ImGui::PushFont(theme.small);
    const std::string words = elided_lines(text, wrap, lines);
    ImGui::PopFont();
    list.AddText(theme.small, theme.small->FontSize, {left, body_top}, platform::packed(theme.muted), words.c_str(),
                 nullptr, wrap);
    // The complete text, if it was shortened.
    tooltip(theme, words != text ? text : "");
    return pressed;
}

/// The body of an example at the right of its card.
void draw_picture(PanelContext& context, const commands::ExamplePicture& picture, const ImVec2& at, const ImVec2& size,
                  float picture_width) {
    const float pad = 12.0f * context.theme.scale;
    // Above the title, or at the right of a low card.
    const bool low = picture_width > 0.0f;
    const float room_x = low ? picture_width : size.x - 2.0f * pad,
                room_y = low ? size.y - 2.0f * pad : 1.9f * context.theme.large->FontSize;
    if (picture.triangles.empty() || !(room_x > 0.0f)) return;
    const float scale = std::min(room_x / std::max(picture.width, 1e-3f), room_y / std::max(picture.height, 1e-3f));
    const ImVec2 corner{at.x + size.x - pad - scale * picture.width,
                        at.y + (low ? 1.0f : 0.5f) * pad + 0.5f * (room_y - scale * picture.height)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4& body = context.theme.body;
    // Smoothed edges of single triangles would show as seams.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (const commands::ExamplePicture::Triangle& triangle : picture.triangles) {
        const auto place = [&](std::size_t k) {
            return ImVec2(corner.x + scale * triangle.corners[2 * k], corner.y + scale * triangle.corners[2 * k + 1]);
        };
        const float l = triangle.light;
        list.AddTriangleFilled(place(0), place(1), place(2),
                               platform::packed({body.x * l, body.y * l, body.z * l, 1.0f}));
    }
    list.Flags = flags;
}

/// Cards of the examples, up to four in a row.
void draw_examples(PanelContext& context, float room) {
    const std::vector<commands::Example>& examples = context.state.examples;
    const float s = context.theme.scale, gap = ImGui::GetStyle().ItemSpacing.x;
    const int columns = card_columns(static_cast<int>(examples.size()),
                                     std::max(1, std::min(4, static_cast<int>(room / (200.0f * s)))));
    const ImVec2 size{std::floor((room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns)),
                      (columns > 1 ? 150.0f : 92.0f) * s};
    // With one column the cards are low, and the picture stands at the right of the text.
    const float picture_width = columns > 1 ? 0.0f : 0.25f * size.x;
    // Rows are filled from the left.
    int column = 0;
    for (const commands::Example& example : examples) {
        if (column++ % columns != 0) ImGui::SameLine();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (card(context, "start/example/" + example.path.filename().string(), platform::icon::cube, example.name,
                 example.description, size, picture_width))
            context.emit(commands::Open{example.path, std::nullopt});
        draw_picture(context, example.picture, at, size, picture_width);
    }
}

/// List of the recent files: icon of their kind, name, and folder.
void draw_recent_files(PanelContext& context, float width) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float s = theme.scale;
    if (!state.preferences.recent.empty()) heading(theme, "Recent");
    for (std::size_t i = 0; i < state.preferences.recent.size(); ++i) {
        const std::filesystem::path& path = state.preferences.recent[i];
        ImGui::PushID(static_cast<int>(i));
        // Projects and experiments have different icons.
        ImGui::TextColored(theme.muted, "%s", commands::is_project(path) ? platform::icon::save : platform::icon::cube);
        ImGui::SameLine(28.0f * s);
        if (ImGui::Selectable(path.filename().string().c_str(), false, 0, {0.32f * width, 0.0f}))
            context.emit(commands::Open{path, std::nullopt});
        context.items.mark("start/recent/" + std::to_string(i));
        ImGui::SameLine();
        ImGui::TextColored(theme.muted, "%s",
                           elided(path.parent_path().string(), ImGui::GetContentRegionAvail().x).c_str());
        ImGui::PopID();
    }
}

/// Name of the program and what it is for.
void draw_title(const platform::Theme& theme) {
    ImGui::GetWindowDrawList()->AddText(theme.large, theme.large->FontSize, ImGui::GetCursorScreenPos(),
                                        platform::packed(theme.text), "Myoloop");
    ImGui::Dummy({0.0f, 1.2f * theme.large->FontSize});
    muted_text(theme, "Design, run and measure soft robots, and diagnose missing effects of the model.");
}

}  // namespace

int card_columns(int cards, int most) {
    // Distribute the cards over as few rows as possible; then avoid a last row with a single card.
    if (cards <= most) return std::max(1, cards);
    // The number of rows is fixed first; then the cards are distributed evenly.
    const int rows = (cards + most - 1) / most;
    int columns = (cards + rows - 1) / rows;
    while (columns > 1 && cards % columns == 1) --columns;
    return columns;
}

/// Examples first, as a new user starts with them; then a file of the user's own, and the recent files.
void draw_start_page(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float s = theme.scale;
    const float width = std::min(900.0f * s, ImGui::GetWindowWidth() - 48.0f * s);
    ImGui::SetCursorPos(
        {0.5f * (ImGui::GetWindowWidth() - width), std::max(16.0f * s, 0.08f * ImGui::GetWindowHeight())});
    ImGui::BeginChild("start page", {width, 0.0f}, false, ImGuiWindowFlags_NoBackground);
    draw_title(theme);
    // Opening takes a while; the page stays until the scene is there.
    if (state.busy()) {
        ImGui::Dummy({0.0f, 12.0f * s});
        ImGui::TextUnformatted(("Opening\xe2\x80\xa6 " + state.job->progress.message).c_str());
    }
    ImGui::Dummy({0.0f, 8.0f * s});
    heading(theme, "Examples");
    // The child window has a scroll bar, which must not cover the cards.
    const float room = width - ImGui::GetStyle().ScrollbarSize - ImGui::GetStyle().ItemSpacing.x;
    draw_examples(context, room);
    heading(theme, "Your files");
    if (card(context, "start/open", platform::icon::folder, "Open a file",
             "An experiment folder, a surface or volume mesh, or a project. A file or folder can also be dropped on "
             "this window.",
             {room, 80.0f * s}))
        context.window.file = open_dialog({});
    draw_recent_files(context, width);
    ImGui::EndChild();
}

}  // namespace myo::ui::panels
