#include "panels/start_page.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/file_dialogs.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

/// A large button with a title and some lines of text.
bool card(PanelContext& context, const std::string& item, const char* sign, const std::string& title, const std::string& text, const ImVec2& size) {
    const Theme& theme = context.theme;
    const float s = theme.scale, pad = 14.0f * s;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(item.c_str(), size);
    context.items.mark(item);
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    list.AddRectFilled(at, end, packed(hovered ? theme.hovered : theme.raised), 6.0f * s);
    list.AddRect(at, end, packed(hovered ? theme.accent : theme.border), 6.0f * s);
    list.AddText(theme.large, theme.large->FontSize, {at.x + pad, at.y + pad}, packed(theme.accent), sign);
    const float text_top = at.y + pad + 1.35f * theme.large->FontSize;
    list.AddText(theme.strong, theme.strong->FontSize, {at.x + pad, text_top}, packed(theme.text), elided(title, size.x - 2.0f * pad).c_str());
    const float wrap = size.x - 2.0f * pad, body_top = text_top + 1.5f * theme.strong->FontSize;
    const int lines = std::max(1, static_cast<int>((end.y - pad - body_top) / theme.small->FontSize));
    ImGui::PushFont(theme.small);
    const std::string words = elided_lines(text, wrap, lines);
    ImGui::PopFont();
    list.AddText(theme.small, theme.small->FontSize, {at.x + pad, body_top}, packed(theme.muted), words.c_str(), nullptr, wrap);
    tooltip(theme, words != text ? text : "");
    return pressed;
}

}  // namespace

void draw_start_page(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    const float s = theme.scale;
    const float width = std::min(900.0f * s, ImGui::GetWindowWidth() - 48.0f * s);
    ImGui::SetCursorPos({0.5f * (ImGui::GetWindowWidth() - width), std::max(16.0f * s, 0.08f * ImGui::GetWindowHeight())});
    ImGui::BeginChild("start page", {width, 0.0f}, false, ImGuiWindowFlags_NoBackground);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(theme.large, theme.large->FontSize, ImGui::GetCursorScreenPos(), packed(theme.text), "Myoloop");
    ImGui::Dummy({0.0f, 1.2f * theme.large->FontSize});
    muted_text(theme, "Design, run and measure soft robots, and find out what the model lacks.");
    if (state.busy()) {
        ImGui::Dummy({0.0f, 12.0f * s});
        ImGui::TextUnformatted(("Opening\xe2\x80\xa6 " + state.job->progress.message).c_str());
    }
    ImGui::Dummy({0.0f, 8.0f * s});
    heading(theme, "Examples");
    // Its own scroll bar is kept clear of the cards.
    const float room = width - ImGui::GetStyle().ScrollbarSize - ImGui::GetStyle().ItemSpacing.x;
    const int columns = std::max(1, std::min(4, static_cast<int>(room / (200.0f * s))));
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const ImVec2 size{std::floor((room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns)), 150.0f * s};
    int column = 0;
    const auto next = [&] {
        if (column++ % columns != 0) ImGui::SameLine();
    };
    for (const Example& example : state.examples) {
        next();
        if (card(context, "start/example/" + example.path.filename().string(), icon::cube, example.name, example.description, size)) context.emit(command::Open{example.path, std::nullopt});
    }
    next();
    if (card(context, "start/open", icon::folder, "Open a file", "An experiment folder, a surface or volume mesh, or a project. A file or folder can also be dropped on this window.", size))
        context.window.file = open_dialog({});
    if (!state.preferences.recent.empty()) heading(theme, "Lately");
    for (std::size_t i = 0; i < state.preferences.recent.size(); ++i) {
        const std::filesystem::path& path = state.preferences.recent[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::TextColored(theme.muted, "%s", is_project(path) ? icon::save : icon::cube);
        ImGui::SameLine(28.0f * s);
        if (ImGui::Selectable(path.filename().string().c_str(), false, 0, {0.32f * width, 0.0f})) context.emit(command::Open{path, std::nullopt});
        context.items.mark("start/recent/" + std::to_string(i));
        ImGui::SameLine();
        ImGui::TextColored(theme.muted, "%s", elided(path.parent_path().string(), ImGui::GetContentRegionAvail().x).c_str());
        ImGui::PopID();
    }
    ImGui::EndChild();
}

}  // namespace myo
