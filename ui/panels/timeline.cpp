#include "panels/timeline.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/markup.hpp"
#include "chart/scale.hpp"
#include "panels/tables.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// List of the trials with their roles.
void draw_trial_choice(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const commands::SceneTrial* trial = state.scene_trial();
    // In a narrow window the track needs the room more than the name does.
    const float width = std::min(200.0f * context.theme.scale, 0.24f * ImGui::GetContentRegionAvail().x);
    // without the arrow of the list
    const float room = width - ImGui::GetFrameHeight() - 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##trial", elided(trial ? trial->name : "no trial", room).c_str());
    context.items.mark("timeline/trial");
    if (!open) return;
    for (std::size_t t = 0; state.scene && t < state.scene->trials.size(); ++t) {
        const commands::SceneTrial& each = state.scene->trials[t];
        if (ImGui::Selectable((each.name + "  (" + each.role + ")").c_str(), static_cast<int>(t) == state.trial)) {
            context.emit(commands::ChooseTrial{static_cast<int>(t)});
        }
        context.items.mark("timeline/trial/" + each.name);
    }
    ImGui::EndCombo();
}

/// Line where the motion starts, if the recording begins before it.
void draw_motion_start(const platform::Theme& theme, float x0, float middle) {
    const float s = theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({x0, middle - 9.0f * s}, {x0, middle + 9.0f * s}, platform::packed(theme.measured), 2.0f * s);
    if (ImGui::IsItemHovered() && std::abs(ImGui::GetIO().MousePos.x - x0) < 5.0f * s)
        ImGui::SetTooltip("Start of motion, t = 0");
}

/// A thin bar below the track marks the part that the preview covers.
void draw_preview_range(PanelContext& context, const ImVec2& from, const ImVec2& to) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, platform::packed(context.theme.simulated));
    context.items.add("timeline/preview", {from, to});
    if (ImGui::IsItemHovered() && ImGui::GetIO().MousePos.x >= from.x && ImGui::GetIO().MousePos.x <= to.x)
        ImGui::SetTooltip("%s", commands::preview_text(context.state).c_str());
}

/// Dragging stops playing, as both would set the time. `scale`: of the track.
void drag_time(PanelContext& context, const chart::Scale& scale) {
    context.emit(commands::Play{false});
    context.emit(commands::SetTime{scale.value(static_cast<double>(ImGui::GetIO().MousePos.x))});
}

/// The track with the play position, the start of motion, and the part covered by a preview. `width` in pixels.
void draw_track(PanelContext& context, const std::array<double, 2>& span, float width) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float s = theme.scale;
    const float height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("track", {width, height});
    context.items.mark("timeline/track");
    // A margin for the round handle, so that it stays inside at both ends.
    const float left = at.x + 8.0f * s;
    const float right = at.x + width - 8.0f * s;
    const float middle = at.y + 0.5f * height;
    const chart::Scale scale{span[0], span[1], static_cast<double>(left), static_cast<double>(right)};
    const auto x_of = [&](double t) { return static_cast<float>(scale(t)); };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, middle - 2.0f * s}, {right, middle + 2.0f * s}, platform::packed(theme.raised), 2.0f * s);
    // A trial with one sample has nothing to move through.
    if (!(scale.range().span() > 0.0)) return;
    if (ImGui::IsItemActive()) drag_time(context, scale);
    const float x = x_of(std::clamp(state.time_s, span[0], span[1]));
    list.AddRectFilled({left, middle - 2.0f * s}, {x, middle + 2.0f * s}, platform::packed(theme.accent), 2.0f * s);
    if (span[0] < 0.0 && span[1] > 0.0) draw_motion_start(theme, x_of(0.0), middle);
    if (state.previewing() && state.preview.end_s > 0.0)
        draw_preview_range(context, {x_of(0.0), middle + 5.0f * s}, {x_of(state.preview.end_s), middle + 8.0f * s});
    list.AddCircleFilled({x, middle}, 7.0f * s, platform::packed(theme.accent), 24);
}

/// Buttons that go to the start and play. `start_s`: first time that can be shown.
void draw_play_buttons(PanelContext& context, double start_s) {
    const commands::WorkbenchState& state = context.state;
    const float s = context.theme.scale;
    const ImVec2 square{ImGui::GetFrameHeight() + 8.0f * s, 0.0f};
    if (ImGui::Button(platform::icon::to_start, square)) context.emit(commands::SetTime{start_s});
    context.items.mark("timeline/start");
    ImGui::SameLine();
    if (ImGui::Button(state.playing ? platform::icon::pause : platform::icon::play, square))
        context.emit(commands::Play{!state.playing});
    context.items.mark("timeline/play");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Play or pause (space bar)");
}

/// Slow motion for vibrations, faster for long trials.
void draw_speeds(PanelContext& context, float width) {
    const commands::WorkbenchState& state = context.state;
    static constexpr std::array<double, 5> speeds{0.1, 0.25, 0.5, 1.0, 2.0};
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##speed", (plot::value_label(state.speed, 2) + "\xc3\x97").c_str())) {
        for (const double speed : speeds) {
            if (ImGui::Selectable((plot::value_label(speed, 2) + "\xc3\x97").c_str(), speed == state.speed))
                context.emit(commands::SetSpeed{speed});
        }
        ImGui::EndCombo();
    }
    context.items.mark("timeline/speed");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Playback speed relative to real time");
}

}  // namespace

/// The track takes the width that the other controls leave.
void draw_timeline(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const float s = context.theme.scale;
    const auto span = commands::time_span(state);
    // A held pose has one time only: nothing can be played.
    const bool movable = span[1] > span[0];
    draw_trial_choice(context);
    ImGui::SameLine();
    ImGui::BeginDisabled(!movable);
    draw_play_buttons(context, span[0]);
    ImGui::SameLine();
    // The time has a fixed width, so that the track does not change while playing.
    const std::string time = fixed_decimals(state.time_s, 3) + " s";
    const float speed_width = 72.0f * s;
    const float time_width = ImGui::CalcTextSize(
                                 "\xe2\x88\x92"
                                 "00.000 s")
                                 .x;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = ImGui::GetContentRegionAvail().x - speed_width - time_width - 2.0f * spacing;
    draw_track(context, span, std::max(40.0f, width));
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const float shift = time_width - ImGui::CalcTextSize(time.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, shift));
    ImGui::TextUnformatted(time.c_str());
    ImGui::SameLine();
    draw_speeds(context, speed_width);
    ImGui::EndDisabled();
}

}  // namespace myo::ui::panels
