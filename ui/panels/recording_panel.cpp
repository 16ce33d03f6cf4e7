#include "panels/recording_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// Intervals in which a marker was seen [s]. Each sample covers half a sample interval on both sides.
std::vector<std::pair<double, double>> seen_spans(const Eigen::VectorXd& time_s, const Eigen::Matrix3Xd& track) {
    std::vector<std::pair<double, double>> spans;
    const double half = time_s.size() > 1 ? 0.5 * (time_s[1] - time_s[0]) : 0.0;
    bool open = false;
    for (Eigen::Index i = 0; i < track.cols(); ++i) {
        const bool seen = track.col(i).allFinite();
        if (seen && !open) spans.push_back({time_s[i] - half, 0.0});
        if (seen) spans.back().second = time_s[i] + half;
        open = seen;
    }
    return spans;
}

/// A coordinate of the selected label's track [mm].
plot::Plot component_plot(const PanelContext& context, int axis, const Eigen::Matrix3Xd& track, float width) {
    const commands::RecordingImport& import = *context.state.import;
    const measurement::Recording& recording = *import.file.recording;
    const auto label = static_cast<std::size_t>(import.label);
    plot::Plot plot;
    plot.id = std::string("recording/") + "xyz"[axis];
    plot.panel.y = {.label = std::string(1, "xyz"[axis]) + " of " + elided(recording.labels[label], 0.4f * width),
                    .unit = "mm"};
    // The line in the plot is the start of the trial, not the shown time.
    plot.cursor = import.choices.start_s;
    plot.panel.series.push_back(
        plot::plot_series("recorded", recording.time_s, track.row(axis).transpose(), context.theme.measured, true));
    return plot;
}

/// Track of the selected label [mm] in the body's frame, as placed by the import choices.
Eigen::Matrix3Xd placed_track_mm(const commands::RecordingImport& import) {
    const Eigen::Matrix3Xd& track = import.file.recording->tracks[static_cast<std::size_t>(import.label)];
    return 1e3 * ((import.view.rotation * track).colwise() + import.view.translation_m);
}

/// Dragging the cursor line changes the start of the trial.
void change_start(PanelContext& context, double time_s) {
    const commands::RecordingImport& import = *context.state.import;
    const measurement::Recording& recording = *import.file.recording;
    commands::ImportChoices choices = import.choices;
    // A trial begins within its recording.
    choices.start_s = std::clamp(time_s, recording.time_s[0], recording.time_s[recording.time_s.size() - 1]);
    context.emit(commands::ChangeImport{choices});
}

/// Name of a label at the left of its row.
void draw_label(const platform::Theme& theme, const std::string& label, const ImVec2& corner, const ImVec2& size,
                bool chosen) {
    const float letters = theme.small->FontSize;
    ImGui::GetWindowDrawList()->AddText(theme.small, letters, {corner.x, corner.y + 0.5f * (size.y - letters)},
                                        platform::packed(chosen ? theme.text : theme.muted),
                                        elided(label, size.x - 8.0f * theme.scale).c_str());
}

/// The whole row in the failure colour, covered by bars where the label was seen: gaps stand out.
void draw_seen(const platform::Theme& theme, const ImVec2& corner, const ImVec2& size,
               const std::vector<std::array<float, 2>>& seen, bool chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto bar = [&](float from, float to, ImU32 color) {
        list.AddRectFilled({from, corner.y + 0.15f * size.y}, {to, corner.y + 0.85f * size.y}, color);
    };
    bar(corner.x, corner.x + size.x, platform::packed(theme.failure, 0.35f));
    for (const auto& [from, to] : seen) bar(from, to, platform::packed(chosen ? theme.accent : theme.measured));
}

/// Invisible button over the row of label i. Moves the cursor below it.
void seen_row_item(PanelContext& context, std::size_t i, const ImVec2& corner, const ImVec2& size) {
    const commands::RecordingImport& import = *context.state.import;
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("row", size)) context.emit(commands::ChooseLabel{static_cast<int>(i), import.placing});
    ImGui::SetCursorScreenPos({corner.x, corner.y + size.y});
    const std::string& label = import.file.recording->labels[i];
    context.items.mark("recording/seen/" + label);
    tooltip(context.theme, label + ": seen in " +
                               std::to_string(static_cast<int>(std::lround(100.0 * import.file.seen[i]))) +
                               " % of the samples");
    ImGui::PopID();
}

}  // namespace

std::string RecordingPanel::title() const { return std::string(platform::icon::camera) + "  Recording"; }

void RecordingPanel::follow(const commands::RecordingImport& import) {
    const measurement::Recording& recording = *import.file.recording;
    if (recording_ != import.file.recording) {
        recording_ = import.file.recording;
        seen_.clear();
        for (const Eigen::Matrix3Xd& track : recording.tracks) seen_.push_back(seen_spans(recording.time_s, track));
        time_.range.reset();
        plots_ = {};
    }
}

/// Three plots in the upper part, the gaps of all labels below. A click on a row of the gaps selects its label.
void RecordingPanel::draw(PanelContext& context) {
    if (!context.state.import) return muted_text(context.theme, "A recording that is being imported is shown here.");
    const commands::RecordingImport& import = *context.state.import;
    const platform::Theme& theme = context.theme;
    follow(import);
    const Eigen::Matrix3Xd track = placed_track_mm(import);
    const ImVec2 space = ImGui::GetContentRegionAvail();
    // In a low strip the curves keep most of the room.
    const float heading = theme.small->FontSize + 8.0f * theme.scale, rows = static_cast<float>(seen_.size());
    const float gaps = std::floor(std::min(14.0f * theme.scale * rows + heading, 0.45f * space.y)),
                row = std::max(2.0f, (gaps - heading) / rows), third = std::floor(space.x / 3.0f);
    plot::PlotArea area;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) ImGui::SameLine(0.0f, 0.0f);
        const plot::Plot plot = component_plot(context, axis, track, third);
        const plot::PlotResult drawn = plot::draw_plot(plot, {third, space.y - gaps - ImGui::GetStyle().ItemSpacing.y},
                                                       theme, context.items, time_,
                                                       plots_[static_cast<std::size_t>(axis)], hidden_);
        if (axis == 0) area = drawn.area;
        if (drawn.cursor) change_start(context, *drawn.cursor);
    }
    // A child window clips rows for which there is no room.
    ImGui::BeginChild("gaps", {space.x, gaps}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    draw_gaps(context, area, row);
    ImGui::EndChild();
}

/// Draws one row per label with the intervals in which it was seen, aligned with the first plot's time axis.
void RecordingPanel::draw_gaps(PanelContext& context, const plot::PlotArea& area, float height) {
    const commands::RecordingImport& import = *context.state.import;
    const platform::Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float names = std::min(0.25f * ImGui::GetContentRegionAvail().x, 180.0f * theme.scale),
                width = ImGui::GetContentRegionAvail().x - names - 12.0f * theme.scale;
    const double first = area.x.lowest, span = std::max(1e-9, area.x.highest - area.x.lowest);
    const auto pixel = [&](double t) {
        return corner.x + names + width * static_cast<float>(std::clamp((t - first) / span, 0.0, 1.0));
    };
    list.AddText(theme.small, theme.small->FontSize, corner, platform::packed(theme.muted), "Seen by the cameras");
    float y = corner.y + theme.small->FontSize + 4.0f * theme.scale;
    ImGui::SetCursorScreenPos({corner.x, y});
    const float begin = y;
    for (std::size_t i = 0; i < seen_.size(); ++i, y += height) {
        seen_row_item(context, i, {corner.x, y}, {names + width, height});
        const bool chosen = static_cast<int>(i) == import.label;
        // If rows are lower than letters, only the selected one has its name.
        if (height >= 0.95f * theme.small->FontSize || chosen)
            draw_label(theme, import.file.recording->labels[i], {corner.x, y}, {names, height}, chosen);
        std::vector<std::array<float, 2>> seen;
        for (const auto& [from, to] : seen_[i])
            if (to > first && from < first + span) seen.push_back({pixel(from), pixel(to)});
        draw_seen(theme, {corner.x + names, y}, {width, height}, seen, chosen);
    }
    // The start of the trial crosses all rows.
    if (const double start_s = import.choices.start_s; start_s >= first && start_s <= first + span)
        list.AddLine({pixel(start_s), begin}, {pixel(start_s), y}, platform::packed(theme.text),
                     std::max(1.0f, theme.scale));
}

}  // namespace myo::ui::panels
