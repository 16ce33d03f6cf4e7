#include "panels/marker_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "commands/marker_csv.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

}  // namespace

std::string MarkerPanel::title() const { return std::string(icon::chart) + "  Markers"; }

void MarkerPanel::draw(PanelContext& context) {
    const WorkbenchState& state = context.state;
    if (!state.scene_trial() || state.scene->markers.empty()) {
        muted_text(context.theme, "Measured and simulated markers are drawn here. Open an experiment folder to begin.");
        return;
    }
    if (scene_ != state.scene || trial_ != state.trial || marker_ != state.marker) {
        // Another curve: the old zoom means nothing.
        if (scene_ != state.scene || trial_ != state.trial) time_.range.reset();
        main_ = {};
        residual_ = {};
        scene_ = state.scene;
        trial_ = state.trial;
        marker_ = state.marker;
    }
    draw_choice(context);
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const int count = static_cast<int>(std::count(shown_.begin(), shown_.end(), true));
    if (count == 0) return;
    const ImVec2 size{std::floor(space.x / static_cast<float>(count)), space.y};
    bool first = true;
    for (int axis = 0; axis < 3; ++axis) {
        if (!shown_[static_cast<std::size_t>(axis)]) continue;
        if (!first) ImGui::SameLine(0.0f, 0.0f);
        ImGui::BeginGroup();
        draw_component(context, axis, size);
        ImGui::EndGroup();
        first = false;
    }
}

void MarkerPanel::draw_choice(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const float s = context.theme.scale;
    const auto& markers = state.scene->markers;
    const std::size_t current = std::min(static_cast<std::size_t>(state.marker), markers.size() - 1);
    ImGui::SetNextItemWidth(std::min(200.0f * s, 0.34f * ImGui::GetContentRegionAvail().x));
    const bool open = ImGui::BeginCombo("##marker", markers[current].name.c_str());
    context.items.mark("markers/marker");
    if (open) {
        for (std::size_t m = 0; m < markers.size(); ++m) {
            if (ImGui::Selectable(markers[m].name.c_str(), m == current)) context.emit(command::ChooseMarker{static_cast<int>(m)});
            context.items.mark("markers/marker/" + markers[m].name);
        }
        ImGui::EndCombo();
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ImGui::SameLine(0.0f, axis == 0 ? 16.0f * s : 8.0f * s);
        ImGui::Checkbox(axis_names[axis], &shown_[axis]);
        context.items.mark(std::string("markers/show/") + axis_names[axis]);
    }
    ImGui::SameLine(0.0f, 16.0f * s);
    if (ImGui::Button("Fit")) {
        time_.range.reset();
        main_ = {};
        residual_ = {};
    }
    context.items.mark("markers/fit");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show all of the data (double-click in a plot does the same)");
    ImGui::SameLine(0.0f, 8.0f * s);
    if (ImGui::Button("CSV\xe2\x80\xa6")) {
        const std::array<double, 2> all = time_span(state);
        const Range range = time_.range.value_or(Range{all[0], all[1]});
        const std::string name = state.scene_trial()->name + "_" + markers[current].name;
        context.window.file = table_dialog("Save the marker's curves", name, marker_curves_csv(state, range.lowest, range.highest));
    }
    context.items.mark("markers/csv");
    tooltip(context.theme, "Saves the visible time range of this marker as a table [s, m]: measured, simulated, simulated \xe2\x88\x92 measured, and every compared run, each in x, y and z");
    const SimulatedTrial* simulated = state.simulated_trial();
    if (simulated && current < simulated->marker_rms_m.size() && std::isfinite(simulated->marker_rms_m[current])) {
        const std::string text = "rms of this marker  " + value_label(1e3 * simulated->marker_rms_m[current], 3) + " mm";
        ImGui::SameLine(0.0f, 16.0f * s);
        if (ImGui::CalcTextSize(text.c_str()).x > ImGui::GetContentRegionAvail().x) return ImGui::NewLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(context.theme.muted, "%s", text.c_str());
    }
}

void MarkerPanel::draw_component(PanelContext& context, int axis, const ImVec2& size) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    const auto a = static_cast<std::size_t>(axis);
    const auto m = static_cast<std::size_t>(state.marker);
    const SceneTrial& trial = *state.scene_trial();
    const SimulatedTrial* simulated = state.simulated_trial();
    const std::string axis_name = axis_names[a];
    const bool compare = simulated && m < simulated->markers.size() && simulated->markers[m].cols() == trial.time_s.size();

    Plot plot;
    plot.id = "plot/" + axis_name;
    plot.title = axis_name + " [mm]";
    plot.cursor = state.time_s;
    plot.mark = 0.0;
    plot.legend = true;
    const Eigen::VectorXd measured = 1e3 * trial.measured[m].row(axis).transpose();
    plot.series.push_back({"measured", trial.time_s, measured, theme.measured, true});
    Plot strip;
    if (compare) {
        const Eigen::VectorXd predicted = 1e3 * simulated->markers[m].row(axis).transpose();
        plot.series.push_back({"simulated", trial.time_s, predicted, theme.simulated, false});
        strip.series.push_back({"simulated \xe2\x88\x92 measured", trial.time_s, predicted - measured, theme.failure, false});
    }
    for (const ComparedMarker& other : compared_markers(state))
        plot.series.push_back({other.name, trial.time_s, 1e3 * other.position_m->row(axis).transpose(), theme.muscle(static_cast<int>(other.record)), false});
    // In a low strip the motion itself keeps the room.
    const bool residual = compare && size.y > 110.0f * theme.scale;
    plot.x_axis = !residual;
    const float residual_height = residual ? std::max(76.0f * theme.scale, 0.42f * size.y) : 0.0f;
    const PlotResult main = draw_plot(plot, {size.x, size.y - residual_height}, theme, context.items, time_, main_[a], hidden_);
    if (main.cursor) context.emit(command::SetTime{*main.cursor});
    if (!residual) return;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    strip.id = "residual/" + axis_name;
    strip.title = size.x > 240.0f * theme.scale ? "simulated \xe2\x88\x92 measured [mm]" : "difference [mm]";
    strip.cursor = state.time_s;
    strip.mark = 0.0;
    strip.zero_line = true;
    HiddenSeries none;
    const PlotResult below = draw_plot(strip, {size.x, residual_height}, theme, context.items, time_, residual_[a], none);
    if (below.cursor) context.emit(command::SetTime{*below.cursor});
}

}  // namespace myo
