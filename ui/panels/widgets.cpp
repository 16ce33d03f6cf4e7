#include "panels/widgets.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "help/field_links.hpp"
#include "panels/escape.hpp"
#include "panels/tables.hpp"
#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Width of the left column of the side panel [pixels].
float label_width() { return std::floor(0.47f * ImGui::GetWindowContentRegionMax().x); }

/// Right edge of the panel at the left of the window that the item belongs to, if a tooltip of this width [pixels] has
/// room next to it; else 0.
float side_of_panel(float width, float scale) {
    const float display = ImGui::GetIO().DisplaySize.x, margin = 48.0f * scale;
    const ImGuiWindow* const panel = ImGui::GetCurrentWindow()->RootWindow;
    const float right = panel->Pos.x + panel->Size.x;
    return right < 0.5f * display && right + width + margin < display ? right : 0.0f;
}

}  // namespace

void tooltip(const platform::Theme& theme, const std::string& text, float width) {
    // Disabled items show their tooltip, too: there the user needs the explanation most.
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    // Below what it explains, or above it where there is no room: it must not cover it. Tall items, such as plots, are
    // explained at the mouse.
    const ImVec2 lowest = ImGui::GetItemRectMin(), highest = ImGui::GetItemRectMax(),
                 display = ImGui::GetIO().DisplaySize;
    const float gap = 4.0f * theme.scale;
    // The rows around a field would be read next: in the side panel the tooltip stands over the view.
    const float beside = side_of_panel(width * theme.scale, theme.scale);
    if (highest.y - lowest.y < 3.0f * ImGui::GetFrameHeight() && beside > 0.0f) {
        const bool above = highest.y > 0.6f * display.y;
        ImGui::SetNextWindowPos({beside + gap, above ? highest.y : lowest.y}, ImGuiCond_Always,
                                {0.0f, above ? 1.0f : 0.0f});
    } else if (highest.y - lowest.y < 3.0f * ImGui::GetFrameHeight()) {
        const bool above = highest.y > 0.6f * display.y, left = lowest.x > 0.6f * display.x;
        ImGui::SetNextWindowPos({left ? std::min(highest.x, display.x) : std::max(lowest.x, 0.0f),
                                 above ? lowest.y - gap : highest.y + gap},
                                ImGuiCond_Always, {left ? 1.0f : 0.0f, above ? 1.0f : 0.0f});
    }
    ImGui::BeginTooltip();
    // In a small window with large text the tooltip would extend beyond the window.
    wrapped_text(text, std::min(width * theme.scale, ImGui::GetIO().DisplaySize.x - 24.0f * theme.scale));
    ImGui::EndTooltip();
}

bool tab(const platform::Theme& theme, const char* label, bool chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme.raised : theme.panel);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme.text : theme.muted);
    const bool pressed = ImGui::Button(label);
    ImGui::PopStyleColor(2);
    return pressed;
}

bool toggle_button(const platform::Theme& theme, const std::string& label, bool on) {
    if (on) return primary_button(theme, label, {-1.0f, 0.0f});
    return ImGui::Button(label.c_str(), {-1.0f, 0.0f});
}

void right_aligned(const std::string& text) {
    const float space = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (space > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + space);
    ImGui::TextUnformatted(text.c_str());
}

void heading(const platform::Theme& theme, const std::string& text) {
    ImGui::Spacing();
    ImGui::PushFont(theme.strong);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
}

std::string duration_label(double seconds) {
    const long whole = std::lround(std::max(0.0, seconds));
    // Tenths of a second matter for short times only; 9.95 would be rounded to "10.0".
    if (seconds < 9.95) return plot::value_label(std::max(0.0, seconds), 2) + " s";
    if (whole < 60) return std::to_string(whole) + " s";
    // Two units at most: seconds do not matter after an hour.
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

void row_label(const platform::Theme& theme, const std::string& label, const std::string& tip) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
    ImGui::TextUnformatted(label.c_str());
    ImGui::PopStyleColor();
    tooltip(theme, tip);
    ImGui::SameLine(label_width());
    ImGui::SetNextItemWidth(-1.0f);
}

void explained_label(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip) {
    const platform::Theme& theme = context.theme;
    const help::FieldLink* const link = help::link_of(name);
    const ImVec2 begin = ImGui::GetCursorPos();
    row_label(theme, label, tip);
    const float right = label_width(), sign = right - ImGui::CalcTextSize("?").x - 6.0f * theme.scale;
    // A long label leaves no room; then the tooltip alone explains.
    if (link == nullptr || begin.x + ImGui::CalcTextSize(label.c_str()).x + 4.0f * theme.scale > sign) return;
    ImGui::SetCursorPos({sign, begin.y});
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(theme.muted, "?");
    context.items.mark(name + "/help");
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip(theme, "Opens the paragraph of the manual that defines it");
    if (ImGui::IsItemClicked()) context.window.help = HelpRequest{HelpRequest::Part::manual, link->page, link->phrase};
    ImGui::SameLine(right);
    ImGui::SetNextItemWidth(-1.0f);
}

void text_row(const platform::Theme& theme, const std::string& label, const std::string& value, const ImVec4* color) {
    const float left = ImGui::GetCursorPosX();
    ImGui::BeginGroup();
    ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
    wrapped_text(label, label_width() - 4.0f);
    ImGui::PopStyleColor();
    ImGui::SameLine(label_width() - left);  // within a group it counts from the group
    ImGui::PushStyleColor(ImGuiCol_Text, color != nullptr ? *color : theme.text);
    wrapped_text(value);
    ImGui::PopStyleColor();
    ImGui::EndGroup();
}

void muted_text(const platform::Theme& theme, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
    wrapped_text(text);
    ImGui::PopStyleColor();
}

const char* level_icon(commands::LogLevel level) {
    const char* const icons[] = {platform::icon::information, platform::icon::done, platform::icon::warning,
                                 platform::icon::failure};
    return icons[static_cast<int>(level)];
}

void notice(const platform::Theme& theme, commands::LogLevel level, const std::string& text) {
    // In the order of LogLevel.
    const ImVec4 colors[] = {theme.muted, theme.success, theme.warning, theme.failure};
    ImGui::TextColored(colors[static_cast<int>(level)], "%s", level_icon(level));
    ImGui::SameLine(0.0f, 8.0f * theme.scale);
    wrapped_text(text);
}

void notice_in_place(const platform::Theme& theme, commands::LogLevel level, const std::string& text, int lines) {
    const ImVec2 at = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing();
    if (!text.empty()) {
        ImGui::BeginGroup();
        const float icon = ImGui::CalcTextSize(platform::icon::information).x + 12.0f * theme.scale;
        notice(theme, level, elided_lines(text, width - icon, lines));
        ImGui::EndGroup();
    }
    // The place itself, over the text: it takes the mouse and always has the same size.
    ImGui::SetCursorPos(at);
    ImGui::Dummy({width, height});
    tooltip(theme, text);
}

bool primary_button(const platform::Theme& theme, const std::string& label, const ImVec2& size) {
    // Darker shades of the accent for hovered and pressed.
    const auto shade = [&](float f) {
        return ImVec4(theme.accent.x * f, theme.accent.y * f, theme.accent.z * f, 1.0f);
    };
    ImGui::PushStyleColor(ImGuiCol_Button, theme.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, shade(0.9f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, shade(0.8f));
    ImGui::PushStyleColor(ImGuiCol_Text, theme.on_accent);
    ImGui::PushFont(theme.strong);
    const bool pressed = ImGui::Button(label.c_str(), size);
    ImGui::PopFont();
    ImGui::PopStyleColor(4);
    return pressed;
}

bool OpenEdit::goes_on(const std::string& name, bool changed) {
    // A new activation starts a new edit, even of the same field.
    if (ImGui::IsItemActivated() && name_ == name) name_.clear();
    const bool continues = changed && name_ == name;
    if (changed) name_ = name;
    if (ImGui::IsItemDeactivated() && name_ == name) name_.clear();
    return continues;
}

bool slider_row(PanelContext& context, const std::string& name, commands::Limits shown_limits, bool logarithmic,
                OpenEdit& edit, double& shown, bool& goes_on) {
    row_label(context.theme, "");
    const bool changed = ImGui::SliderScalar(
        ("##" + name).c_str(), ImGuiDataType_Double, &shown, &shown_limits.lowest, &shown_limits.highest, "",
        ImGuiSliderFlags_NoInput | (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None));
    context.items.mark(name);
    goes_on = edit.goes_on(name, changed);
    if (!changed || !std::isfinite(shown)) return false;
    // A slider with sixteen digits would give unreadable values; three significant digits remain.
    const double digit = std::pow(10.0,
                                  std::floor(std::log10(std::max(std::abs(shown), 1e-3 * shown_limits.highest))) - 2.0);
    shown = std::clamp(std::round(shown / digit) * digit, shown_limits.lowest, shown_limits.highest);
    return true;
}

bool choice_row(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                const std::vector<commands::Choice>& choices, std::string& id) {
    explained_label(context, label, name, tip);
    // An unknown id is shown as it is.
    const auto current = std::find_if(choices.begin(), choices.end(),
                                      [&](const commands::Choice& c) { return c.id == id; });
    const bool open = ImGui::BeginCombo(("##" + name).c_str(),
                                        current != choices.end() ? current->label.c_str() : id.c_str());
    context.items.mark(name);
    if (!open) {
        // Closed, the list explains the present choice.
        tooltip(context.theme, current != choices.end() ? current->explanation : tip);
        return false;
    }
    bool changed = false;
    for (const commands::Choice& choice : choices) {
        if (ImGui::Selectable(choice.label.c_str(), choice.id == id) && choice.id != id) {
            id = choice.id;
            changed = true;
        }
        context.items.mark(name + "/" + choice.id);
        tooltip(context.theme, choice.explanation);
    }
    ImGui::EndCombo();
    return changed;
}

bool begin_dialog(const platform::Theme& theme, const char* title, float width) {
    // The caller draws the dialog while its question is open, so it opens itself.
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(width * theme.scale, display.x - 40.0f), 0.0f});
    return ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
}

bool begin_popup_above(const platform::Theme& theme, const char* name, float width) {
    // The popup must not extend beyond the right edge of the window.
    const float furthest = ImGui::GetMainViewport()->Pos.x + ImGui::GetMainViewport()->Size.x -
                           (width + 8.0f) * theme.scale;
    const ImVec2 above{std::max(0.0f, std::min(ImGui::GetItemRectMin().x, furthest)),
                       ImGui::GetItemRectMin().y - 4.0f * theme.scale};
    ImGui::SetNextWindowPos(above, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSize({width * theme.scale, 0.0f});
    if (!ImGui::BeginPopup(name)) return false;
    if (escape_closes()) ImGui::CloseCurrentPopup();
    return true;
}

std::string with_separators(double count) {
    std::string digits = std::to_string(static_cast<long long>(std::llround(count)));
    for (std::size_t i = digits.size(); i > 3 && digits[i - 4] != '-';) {
        i -= 3;
        // From the end, so that positions before the inserted separator stay valid.
        digits.insert(i, ",");
    }
    return digits;
}

void marker_list(PanelContext& context, const std::string& name) {
    const auto& markers = context.state.scene->markers;
    const std::size_t current = std::min(static_cast<std::size_t>(context.state.marker), markers.size() - 1);
    const bool open = ImGui::BeginCombo("##marker", markers[current].name.c_str());
    context.items.mark(name);
    if (!open) return;
    for (std::size_t m = 0; m < markers.size(); ++m) {
        if (ImGui::Selectable(markers[m].name.c_str(), m == current))
            context.emit(commands::ChooseMarker{static_cast<int>(m)});
        context.items.mark(name + "/" + markers[m].name);
    }
    ImGui::EndCombo();
}

}  // namespace myo::ui::panels
