#include "panels/menu_bar.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/letter_case.hpp"
#include "panels/check_marks.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

// Titles in order. The tasks that the palette offers have no menu.
constexpr std::array<const char*, 5> menus{"File", "Edit", "View", "Run", "Help"};

/// Submenu of File with the files that were opened last.
void draw_recent(PanelContext& context) {
    const auto& recent = context.state.preferences.recent;
    if (recent.empty() || !ImGui::BeginMenu("Open recent")) return;
    for (const std::filesystem::path& path : recent)
        if (ImGui::MenuItem(path.string().c_str())) context.emit(commands::Open{path, std::nullopt});
    ImGui::EndMenu();
}

/// The examples that come with the program.
void draw_examples(PanelContext& context) {
    const std::vector<commands::Example>& examples = context.state.examples;
    const bool open = !examples.empty() && ImGui::BeginMenu("Examples");
    if (!examples.empty()) context.items.mark("menu/examples");
    if (!open) return;
    for (const commands::Example& example : examples) {
        if (ImGui::MenuItem(example.name.c_str())) context.emit(commands::Open{example.path, std::nullopt});
        context.items.mark("menu/example/" + example.path.filename().string());
        tooltip(context.theme, example.description);
    }
    ImGui::EndMenu();
}

/// One menu: the actions with its title, in the order of actions.cpp.
void draw_menu(PanelContext& context, viewport::ViewportState& viewport, const std::string& menu) {
    for (const Action& action : all_actions()) {
        if (action.menu != menu) continue;
        if (action.separated) ImGui::Separator();
        const bool enabled = !action.enabled || action.enabled(context.state),
                   checked = action.checked && action.checked(context.state);
        if (ImGui::MenuItem(action.label.c_str(), action.shortcut.label[0] ? action.shortcut.label : nullptr, checked,
                            enabled))
            action.perform(context, viewport);
        context.items.mark("menu/" + action.id);
        // Recent files and examples belong next to Open.
        if (action.id == "file.open") draw_recent(context), draw_examples(context);
    }
}

/// The row of menu buttons. Menus are popups below plain buttons, so that the same row can hold other buttons and the
/// message.
void draw_menus(PanelContext& context, viewport::ViewportState& viewport) {
    const platform::Theme& theme = context.theme;
    const auto id = [](const char* menu) { return std::string("menu ") + menu; };
    // Asked before the loop: opening another menu below closes the one that is open.
    const bool any_open = std::any_of(menus.begin(), menus.end(),
                                      [&](const char* menu) { return ImGui::IsPopupOpen(id(menu).c_str()); });
    ImGui::PushStyleColor(ImGuiCol_Button, theme.panel);
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0f);
    for (const char* menu : menus) {
        if (menu != menus.front()) ImGui::SameLine(0.0f, 2.0f * theme.scale);
        const bool pressed = ImGui::Button(menu);
        context.items.mark("menu/" + lower_first(menu));
        const ImVec2 below{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 2.0f * theme.scale};
        // With one menu open, moving the mouse over another title opens that one.
        const bool passes = any_open && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup) &&
                            !ImGui::IsPopupOpen(id(menu).c_str());
        if (pressed || passes) ImGui::OpenPopup(id(menu).c_str());
        ImGui::SetNextWindowPos(below);
        ImGui::SetNextWindowSize({300.0f * theme.scale, 0.0f});
        if (ImGui::BeginPopup(id(menu).c_str())) {
            draw_menu(context, viewport, menu);
            ImGui::EndPopup();
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

/// The newest message, shortened to the room that is left. A click shows the panel of messages. A preview replaces it
/// by its state.
void draw_message(PanelContext& context, float right) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    if (state.log.empty()) return;
    // A preview has no entry in the log, as it is no result.
    const commands::LogLine line = state.previewing() ? commands::LogLine{state.preview.run->problem.empty()
                                                                              ? commands::LogLevel::information
                                                                              : commands::LogLevel::warning,
                                                                          commands::preview_text(state)}
                                                      : state.log.back();
    // In the order of LogLevel.
    const ImVec4 colors[] = {theme.muted, theme.success, theme.warning, theme.failure};
    ImGui::AlignTextToFramePadding();
    const float room = right - 16.0f * theme.scale - ImGui::GetCursorPosX();
    constexpr float readable = 120.0f, icon = 40.0f;  // least widths of a beginning and of an icon [pixels at scale 1]
    if (room < icon * theme.scale) return;
    const std::string shown = room < readable * theme.scale ? level_icon(line.level) : elided(line.text, room);
    ImGui::TextColored(colors[static_cast<int>(line.level)], "%s", shown.c_str());
    context.items.mark("bar/message");
    tooltip(theme, line.text);
    if (ImGui::IsItemClicked()) context.window.panel = "messages";
    ImGui::SameLine();
}

/// Button with a sign only.
void sign_button(PanelContext& context, const char* sign, const char* item, const char* tip, bool enabled,
                 const commands::Command& asked) {
    ImGui::BeginDisabled(!enabled);
    if (ImGui::Button(sign)) context.emit(asked);
    context.items.mark(item);
    ImGui::EndDisabled();
    tooltip(context.theme, tip);
    ImGui::SameLine();
}

/// Save, undo and redo.
void draw_sign_buttons(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    sign_button(context, platform::icon::save, "bar/save",
                state.unsaved() ? "Save the project (Ctrl+S); unsaved changes" : "Save the project (Ctrl+S)",
                state.scene != nullptr, commands::Save{});
    sign_button(context, platform::icon::undo, "bar/undo", "Undo the last change (Ctrl+Z)", state.can_undo,
                commands::Undo{});
    sign_button(context, platform::icon::redo, "bar/redo", "Redo (Ctrl+Y)", state.can_redo, commands::Redo{});
}

/// Size of text and controls.
void draw_scale_list(PanelContext& context, float width) {
    const commands::WorkbenchState& state = context.state;
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##scale", (std::to_string(std::lround(100.0f * state.scale())) + " %").c_str())) {
        // The values cover the range of the preferences.
        for (const int percent : {75, 100, 125, 150, 200, 250}) {
            const bool chosen = std::lround(100.0f * state.scale()) == percent;
            if (ImGui::Selectable((std::to_string(percent) + " %").c_str(), chosen))
                context.emit(commands::SetTheme{state.preferences.theme, 0.01f * static_cast<float>(percent)});
            context.items.mark("bar/scale/" + std::to_string(percent));
        }
        ImGui::EndCombo();
    }
    context.items.mark("bar/scale");
    tooltip(context.theme, "Size of text and controls");
}

/// Button that switches to the other theme.
void draw_theme_button(PanelContext& context, float width) {
    const commands::WorkbenchState& state = context.state;
    const bool dark = state.preferences.theme == platform::ThemeName::dark;
    if (ImGui::Button(dark ? "Light" : "Dark", {width, 0.0f}))
        context.emit(commands::SetTheme{dark ? platform::ThemeName::light : platform::ThemeName::dark, state.scale()});
    context.items.mark("bar/theme");
    tooltip(context.theme, "Light or dark colours");
}

constexpr float theme_button_width = 72.0f, scale_list_width = 84.0f, bar_gap = 12.0f;  // [pixels at scale 1]

/// What the bar has room for in addition to its menus, which are always there.
struct BarParts {
    bool name = true, theme = true, signs = true, scale = true;
};

/// With large letters in a small window not everything fits. What has a menu entry or a key goes first.
BarParts parts_that_fit(const platform::Theme& theme, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto button = [&](const char* label) {
        return ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
    };
    // Padding and menus are always there.
    float left = 2.0f * style.WindowPadding.x + bar_gap * theme.scale;
    for (const char* menu : menus) left += button(menu);
    BarParts parts;
    const auto needed = [&] {
        float all = left;
        if (parts.name) all += ImGui::CalcTextSize("Myoloop").x + 2.0f * bar_gap * theme.scale;
        if (parts.signs)
            for (const char* sign : {platform::icon::save, platform::icon::undo, platform::icon::redo})
                all += button(sign);
        if (parts.theme) all += theme_button_width * theme.scale + style.ItemSpacing.x;
        if (parts.scale) all += scale_list_width * theme.scale + style.ItemSpacing.x;
        return all;
    };
    // In this order parts are left out until the rest fits.
    for (bool BarParts::*part : {&BarParts::name, &BarParts::theme, &BarParts::signs, &BarParts::scale})
        if (needed() > width) parts.*part = false;
    return parts;
}

}  // namespace

/// Menus and buttons on the left, checks, scale and theme on the right, the newest message in the room between them.
void draw_menu_bar(PanelContext& context, viewport::ViewportState& viewport) {
    const platform::Theme& theme = context.theme;
    ImGui::SetCursorPosY(0.5f * (ImGui::GetWindowHeight() - ImGui::GetFrameHeight()));
    const BarParts parts = parts_that_fit(theme, ImGui::GetWindowWidth());
    if (parts.name) {
        ImGui::AlignTextToFramePadding();
        ImGui::PushFont(theme.strong);
        ImGui::TextColored(theme.accent, "Myoloop");
        ImGui::PopFont();
        ImGui::SameLine(0.0f, bar_gap * theme.scale);
    }
    draw_menus(context, viewport);
    ImGui::SameLine(0.0f, bar_gap * theme.scale);
    if (parts.signs) draw_sign_buttons(context);
    // The checks and the message take the room between the buttons on the left and on the right.
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
    if (parts.theme) right -= theme_button_width * theme.scale;
    if (parts.scale) right -= scale_list_width * theme.scale + (parts.theme ? spacing : 0.0f);
    const float left = ImGui::GetCursorPosX();
    // Without room for its icon, the checks are found in their tab.
    const float line = ImGui::GetFrameHeight(), room = right - left - 16.0f * theme.scale;
    if (room > line) {
        const float message_right = checks_mark(context, left, right - 16.0f * theme.scale);
        ImGui::SameLine();
        ImGui::SetCursorPosX(left);
        draw_message(context, message_right);
    }
    ImGui::SetCursorPosX(right);
    if (parts.scale) draw_scale_list(context, scale_list_width * theme.scale);
    if (parts.scale && parts.theme) ImGui::SameLine();
    if (parts.theme) draw_theme_button(context, theme_button_width * theme.scale);
}

}  // namespace myo::ui::panels
