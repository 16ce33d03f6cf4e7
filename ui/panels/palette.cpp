#include "panels/palette.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <sstream>

#include "base/letter_case.hpp"
#include "panels/escape.hpp"
#include "panels/offered_actions.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/input_queue.hpp"

namespace myo::ui::panels {

std::vector<const Action*> matching_actions(const std::string& text, const std::vector<Action>& actions) {
    std::vector<std::string> words;
    std::istringstream stream(lower_case(text));
    // Each word must occur somewhere, so that "theme light" finds the same as "light theme".
    for (std::string word; stream >> word;) words.push_back(word);
    std::vector<const Action*> found;
    for (const Action& action : actions) {
        const std::string name = lower_case(action.menu + " " + action.label);
        const bool all = std::all_of(words.begin(), words.end(),
                                     [&](const std::string& word) { return name.find(word) != std::string::npos; });
        if (all) found.push_back(&action);
    }
    return found;
}

void Palette::open() {
    wanted_ = focus_ = true;
    text_.clear();
    chosen_ = 0;
}

void Palette::move_highlight(std::size_t entries) {
    // The text field keeps the keyboard, so the arrow keys are read here.
    if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ++chosen_;
    if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) --chosen_;
    // Typing shortens the list, so the highlight may lie beyond its end.
    chosen_ = std::clamp(chosen_, 0, std::max(0, static_cast<int>(entries) - 1));
}

const Action* Palette::draw_found(PanelContext& context, const std::vector<const Action*>& found) {
    const platform::Theme& theme = context.theme;
    const Action* wanted = nullptr;
    ImGui::BeginChild("found");
    if (found.empty()) muted_text(theme, "No match.");
    for (int i = 0; i < static_cast<int>(found.size()); ++i) {
        const Action& action = *found[static_cast<std::size_t>(i)];
        const bool enabled = !action.enabled || action.enabled(context.state);
        ImGui::PushID(action.id.c_str());
        ImGui::BeginDisabled(!enabled);
        // The shortcut stands at the right; the name is shortened to the room before it.
        const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(action.shortcut.label).x;
        if (ImGui::Selectable(elided(action.menu + ": " + action.label, room).c_str(), i == chosen_)) wanted = &action;
        ImGui::EndDisabled();
        context.items.mark("palette/" + action.id);
        // Scroll only for the keys: the mouse wheel must be able to move the list.
        if (i == chosen_ && (ImGui::IsKeyPressed(ImGuiKey_DownArrow) || ImGui::IsKeyPressed(ImGuiKey_UpArrow)))
            ImGui::SetScrollHereY();
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(action.shortcut.label).x);
        ImGui::TextColored(theme.muted, "%s", action.shortcut.label);
        ImGui::PopID();
        if (i == chosen_ && enabled &&
            (ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeyPadEnter, false)))
            wanted = &action;
    }
    ImGui::EndChild();
    return wanted;
}

/// The list is filtered in each frame; arrow keys move the highlight, Enter or a click executes the entry.
void Palette::draw(PanelContext& context, viewport::ViewportState& viewport,
                   const std::vector<std::unique_ptr<Panel>>& panels) {
    const float s = context.theme.scale;
    if (wanted_) ImGui::OpenPopup("palette");
    wanted_ = false;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 72.0f * s}, ImGuiCond_Always, {0.5f, 0.0f});
    // In a popup: a click elsewhere closes the palette.
    ImGui::SetNextWindowSize({std::min(560.0f * s, display.x - 40.0f), std::min(420.0f * s, display.y - 120.0f * s)});
    if (!ImGui::BeginPopup("palette", ImGuiWindowFlags_NoNav)) return;
    if (focus_) ImGui::SetKeyboardFocusHere();
    focus_ = false;
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputTextWithHint("##command", "Find a command, tool, panel, trial, quantity or page", &text_))
        chosen_ = 0;
    context.items.mark("palette/text");
    // Commands first, then files, trials, panels and fields.
    const std::vector<Action> offered = offered_actions(context.state, context.backend, panels);
    std::vector<const Action*> found = matching_actions(text_, all_actions());
    for (const Action* action : matching_actions(text_, offered)) found.push_back(action);
    move_highlight(found.size());
    const Action* const wanted = draw_found(context, found);
    // After the loop, as an action may change what the loop reads.
    if (wanted) wanted->perform(context, viewport);
    if (wanted || escape_closes()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
