#include "panels/palette.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "panels/widgets.hpp"
#include "platform/input_queue.hpp"

namespace myo {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return text;
}

}  // namespace

std::vector<const Action*> matching_actions(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(lower(text));
    for (std::string word; stream >> word;) words.push_back(word);
    std::vector<const Action*> found;
    for (const Action& action : all_actions()) {
        const std::string name = lower(action.menu + " " + action.label);
        const bool all = std::all_of(words.begin(), words.end(), [&](const std::string& word) { return name.find(word) != std::string::npos; });
        if (all) found.push_back(&action);
    }
    return found;
}

void Palette::open() {
    wanted_ = focus_ = true;
    text_.clear();
    chosen_ = 0;
}

void Palette::draw(PanelContext& context, ViewportState& viewport) {
    const Theme& theme = context.theme;
    const float s = theme.scale;
    if (wanted_) ImGui::OpenPopup("palette");
    wanted_ = false;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 72.0f * s}, ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowSize({std::min(560.0f * s, display.x - 40.0f), std::min(420.0f * s, display.y - 120.0f * s)});
    if (!ImGui::BeginPopup("palette")) return;
    if (focus_) ImGui::SetKeyboardFocusHere();
    focus_ = false;
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputTextWithHint("##command", "Find a command", &text_)) chosen_ = 0;
    context.items.mark("palette/text");
    const std::vector<const Action*> found = matching_actions(text_);
    if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ++chosen_;
    if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) --chosen_;
    chosen_ = std::clamp(chosen_, 0, std::max(0, static_cast<int>(found.size()) - 1));
    const Action* wanted = nullptr;
    ImGui::BeginChild("found");
    if (found.empty()) muted_text(theme, "No command of this name.");
    for (int i = 0; i < static_cast<int>(found.size()); ++i) {
        const Action& action = *found[static_cast<std::size_t>(i)];
        const bool enabled = !action.enabled || action.enabled(context.state);
        ImGui::PushID(action.id.c_str());
        ImGui::BeginDisabled(!enabled);
        if (ImGui::Selectable((action.menu + ": " + action.label).c_str(), i == chosen_)) wanted = &action;
        ImGui::EndDisabled();
        context.items.mark("palette/" + action.id);
        if (i == chosen_ && (ImGui::IsKeyPressed(ImGuiKey_DownArrow) || ImGui::IsKeyPressed(ImGuiKey_UpArrow))) ImGui::SetScrollHereY();
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(action.shortcut.label).x);
        ImGui::TextColored(theme.muted, "%s", action.shortcut.label);
        ImGui::PopID();
        if (i == chosen_ && enabled && (ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeyPadEnter, false))) wanted = &action;
    }
    ImGui::EndChild();
    if (wanted) wanted->perform(context, viewport);
    if (wanted || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void draw_about(PanelContext& context, bool& open) {
    if (!open) return;
    const Theme& theme = context.theme;
    if (!begin_dialog(theme, "About Myoloop", 480.0f)) return;
    heading(theme, "Myoloop " + context.backend.version());
    muted_text(theme, "A workbench for soft robots. MIT licence. It stands on these libraries:");
    if (ImGui::BeginTable("libraries", 3, ImGuiTableFlags_RowBg)) {
        for (const Library& library : context.backend.libraries()) {
            ImGui::TableNextRow();
            for (const std::string* text : {&library.name, &library.version, &library.licence}) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(text->c_str());
            }
        }
        ImGui::EndTable();
    }
    ImGui::Spacing();
    if (primary_button(theme, "Close", {-1.0f, 0.0f}) || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
        open = false;
        ImGui::CloseCurrentPopup();
    }
    context.items.mark("about/close");
    ImGui::EndPopup();
}

}  // namespace myo
