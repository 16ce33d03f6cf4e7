#include "panels/marker_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "commands/marker_csv.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/draw_chart.hpp"
#include "plot/legend.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

constexpr const char* plot_help =  // tooltip of the help icon
    "Wheel: zoom in time about the mouse; with Shift in mm\n"
    "Drag with the right button: zoom to a box\n"
    "Drag with the left button: move the curves; double-click: show all\n"
    "Click: go to that time; the vertical line can be dragged\n"
    "Shift and drag: select a time range, for its rms error and for repairs; Shift and click: no range\n"
    "A name in the legend: hide or show the curve";

/// Whether there is no room for text on the buttons. The legend of several trials is then in their menu.
bool is_narrow(const platform::Theme& theme) { return ImGui::GetContentRegionAvail().x < 530.0f * theme.scale; }

/// Check boxes of the coordinates that are drawn.
void draw_axis_boxes(PanelContext& context, std::array<bool, 3>& shown, bool narrow, float gap) {
    const float s = context.theme.scale;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ImGui::SameLine(0.0f, axis == 0 ? 2.0f * gap : gap);
        if (narrow) ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, ImVec2(4.0f * s, 0.0f));
        ImGui::Checkbox(axis_names[axis], &shown[axis]);
        if (narrow) ImGui::PopStyleVar();
        context.items.mark(std::string("markers/show/") + axis_names[axis]);
    }
}

/// Icon whose tooltip explains the mouse in the plots.
void draw_plot_help(PanelContext& context) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(context.theme.muted, "%s", platform::icon::information);
    context.items.mark("markers/help");
    tooltip(context.theme, plot_help, 460.0f);
}

/// Error of the shown marker: that of the selected time range or, without one, that of the whole trial. Empty: there is
/// none.
std::string error_text(const commands::WorkbenchState& state, const std::optional<chart::Range>& chosen) {
    const commands::SimulatedTrial* simulated = state.simulated_trial();
    const auto m = static_cast<std::size_t>(state.marker);
    std::string text;
    if (chosen) {
        const double rms = commands::marker_rms_m(*state.scene_trial(), simulated, m, chosen->lowest, chosen->highest);
        const std::string range = " in " + plot::value_label(chosen->lowest, 3) + "\xe2\x80\x93" +
                                  plot::value_label(chosen->highest, 3) + " s";
        text = (std::isfinite(rms) ? "rms " + plot::value_label(1e3 * rms, 3) + " mm" : std::string("no comparison")) +
               range;
    } else if (simulated && m < simulated->marker_rms_m.size() && std::isfinite(simulated->marker_rms_m[m])) {
        text = "rms of this marker  " + plot::value_label(1e3 * simulated->marker_rms_m[m], 3) + " mm";
    }
    return text;
}

/// Whether two trials have the same name and as many samples.
bool same_samples(const commands::Scene& a, int trial_a, const commands::Scene& b, int trial_b) {
    const auto x = static_cast<std::size_t>(trial_a), y = static_cast<std::size_t>(trial_b);
    return x < a.trials.size() && y < b.trials.size() && a.trials[x].name == b.trials[y].name &&
           a.trials[x].time_s.size() == b.trials[y].time_s.size();
}

}  // namespace

std::string MarkerPanel::title() const { return std::string(platform::icon::chart) + "  Markers"; }

void MarkerPanel::follow(const commands::WorkbenchState& state) {
    if (scene_ == state.scene && trial_ == state.trial && marker_ == state.marker) return;
    const bool same_file = scene_ && scene_->path == state.scene->path;
    // A different curve: the old zoom has no meaning for it.
    const bool same_trial = same_file && same_samples(*scene_, trial_, *state.scene, state.trial);
    if (!same_trial) time_ = {};
    if (!same_file || scene_->trials.size() != state.scene->trials.size()) overlaid_.clear();
    if (!same_trial || marker_ != state.marker) main_ = residual_ = {};
    scene_ = state.scene;
    trial_ = state.trial;
    marker_ = state.marker;
}

/// Controls in one line; below it the plots of the selected coordinates next to each other, with equal widths.
void MarkerPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (!state.scene_trial() || state.scene->markers.empty()) {
        muted_text(context.theme,
                   !state.scene_trial() || !state.scene->is_experiment
                       ? "Measured and simulated markers are drawn here. Open an experiment folder to "
                         "begin."
                       : "Simulated motion is drawn here. Add a probe under Measure, Markers and probes.");
        return;
    }
    follow(state);
    draw_choice(context);
    if (!state.simulated_trial() && !commands::is_seen(*state.scene_trial(), static_cast<std::size_t>(state.marker))) {
        muted_text(context.theme,
                   "Run to see how " + state.scene->markers[static_cast<std::size_t>(state.marker)].name + " moves.");
        context.items.mark("markers/not_run");
        return;
    }
    if (!is_narrow(context.theme) && !commands::overlaid_markers(state, overlaid_).empty()) draw_legend(context);
    // Collected while drawing, for export as SVG.
    seen_.clear();
    const ImVec2 space = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
    // The whole area, for the picture of the plots; the single plots record their own items.
    plots_ = {corner, {corner.x + space.x, corner.y + space.y}};
    context.items.add("markers/plots", plots_);
    // All plots may be switched off.
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

void MarkerPanel::show_all() {
    // A default value of the plot state means "all data".
    time_.range.reset();
    main_ = {};
    residual_ = {};
}

/// In a narrow panel the buttons are icons, and the error moves to a line of its own or into the table of errors.
void MarkerPanel::draw_choice(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const float s = context.theme.scale;
    const auto& markers = state.scene->markers;
    const std::size_t current = std::min(static_cast<std::size_t>(state.marker), markers.size() - 1);
    // Decided once per frame, so that all controls use the same layout.
    const bool narrow = is_narrow(context.theme);  // buttons then show icons
    const float gap = narrow ? 4.0f * s : 8.0f * s;
    ImGui::SetNextItemWidth(narrow ? 80.0f * s : std::min(200.0f * s, 0.34f * ImGui::GetContentRegionAvail().x));
    marker_list(context, "markers/marker");
    draw_axis_boxes(context, shown_, narrow, gap);
    ImGui::SameLine(0.0f, 2.0f * gap);
    draw_trials(context, narrow);
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button(narrow ? platform::icon::expand : "Zoom to data")) show_all();
    context.items.mark("markers/fit");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show all data (double-click in a plot does the same)");
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button(narrow ? platform::icon::save : "Export\xe2\x80\xa6")) ImGui::OpenPopup("markers export");
    context.items.mark("markers/export");
    tooltip(context.theme, "Saves the visible curves of this marker as a table, a drawing or a picture");
    draw_export(context, state.scene_trial()->name + "_" + markers[current].name);
    ImGui::SameLine(0.0f, gap);
    repair_.draw(context, narrow ? platform::icon::eraser : "Repair\xe2\x80\xa6", time_.chosen);
    ImGui::SameLine(0.0f, gap);
    draw_plot_help(context);
    draw_error(context);
}

/// Without a selected range: the error of the marker over the whole trial. With one: its error within the range.
void MarkerPanel::draw_error(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const std::string text = error_text(state, time_.chosen);
    if (text.empty()) return;
    ImGui::SameLine(0.0f, 16.0f * context.theme.scale);
    // Without room in the line of the controls, the text goes below it.
    if (ImGui::CalcTextSize(text.c_str()).x > ImGui::GetContentRegionAvail().x) {
        ImGui::NewLine();
        if (!time_.chosen) return;  // the table of errors has it; the error of a range is shown only here
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(time_.chosen ? context.theme.text : context.theme.muted, "%s", text.c_str());
    context.items.mark(time_.chosen ? "markers/chosen_rms" : "markers/rms");
    if (time_.chosen)
        tooltip(context.theme,
                "Root mean square of simulated \xe2\x88\x92 measured over x, y and z of this marker in the shown "
                "trial, within the selected range. Shift and click in a plot: no range.");
}

void MarkerPanel::draw_trial_row(PanelContext& context, std::size_t t) {
    const commands::WorkbenchState& state = context.state;
    const commands::SceneTrial& trial = state.scene->trials[t];
    const int index = static_cast<int>(t);
    // The list contains the shown trial, too, so that its position among the others is clear.
    bool drawn = index == state.trial || overlaid_.count(index) > 0;
    // The shown trial is always drawn.
    ImGui::BeginDisabled(index == state.trial);
    ImGui::PushID(index);
    if (ImGui::Checkbox("##drawn", &drawn)) {
        if (drawn)
            overlaid_.insert(index);
        else
            overlaid_.erase(index);
    }
    ImGui::PopID();
    context.items.mark("markers/trial/" + trial.name);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0.0f);
    if (index == state.trial)
        ImGui::TextColored(context.theme.muted, "%s (shown)", trial.name.c_str());
    else
        ImGui::TextColored(overlay_color(context.theme, t), "%s", trial.name.c_str());
    ImGui::PopTextWrapPos();
}

void MarkerPanel::draw_trials(PanelContext& context, bool narrow) {
    const commands::WorkbenchState& state = context.state;
    if (ImGui::Button(narrow ? platform::icon::list : "Trials\xe2\x80\xa6")) ImGui::OpenPopup("trials");
    context.items.mark("markers/trials");
    tooltip(context.theme, "Draws this marker in other trials, too, in time since each trial's start");
    if (!begin_popup_above(context.theme, "trials", 320.0f)) return;
    for (std::size_t t = 0; t < state.scene->trials.size(); ++t) {
        draw_trial_row(context, t);
    }
    if (narrow && !commands::overlaid_markers(state, overlaid_).empty()) {
        ImGui::Separator();
        draw_legend(context);
    }
    ImGui::EndPopup();
}

/// One legend for all coordinates: above a single plot there is no room for the names of several trials.
void MarkerPanel::draw_legend(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    std::vector<chart::LegendEntry> entries;
    const auto add = [&](const std::string& name, const ImVec4& color, chart::SeriesStyle style) {
        entries.push_back({.name = name, .colour = plot::chart_colour(color), .style = style});
    };
    add("measured", theme.measured, chart::SeriesStyle::dots);
    // Only curves that exist have an entry.
    if (context.state.simulated_trial()) add("simulated", theme.simulated, chart::SeriesStyle::line);
    for (const commands::ComparedMarker& other : commands::compared_markers(context.state))
        add(other.name, theme.muscle(static_cast<int>(other.record)), chart::SeriesStyle::line);
    for (const commands::OverlaidMarker& other : commands::overlaid_markers(context.state, overlaid_)) {
        const ImVec4& color = overlay_color(theme, other.trial);
        add(other.measured->name + ", measured", color, chart::SeriesStyle::dots);
        if (other.simulated_m) add(other.measured->name + ", simulated", color, chart::SeriesStyle::line);
    }
    ImGui::PushFont(theme.small);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float gap = 12.0f * theme.scale, right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    for (const chart::LegendEntry& entry : entries) {
        const float width = plot::legend_width(entry, theme);
        if (&entry != &entries.front()) {
            ImGui::SameLine(0.0f, gap);
            // Entries without room in the line continue in the next.
            if (ImGui::GetCursorPosX() + width > right) ImGui::NewLine();
        }
        const bool pressed = ImGui::InvisibleButton(entry.name.c_str(), {width, ImGui::GetTextLineHeight()});
        context.items.mark("markers/legend/" + entry.name);
        plot::draw_legend_entry(list, entry, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}, ImGui::IsItemHovered(),
                                pressed, theme, hidden_);
    }
    ImGui::PopFont();
}

/// Three ways to save: the data as CSV, the plots as vectors (SVG), or as pixels (PNG).
void MarkerPanel::draw_export(PanelContext& context, const std::string& name) {
    if (!ImGui::BeginPopup("markers export")) return;
    if (ImGui::MenuItem("Table (CSV)\xe2\x80\xa6")) {
        // Without a zoom the whole trial is exported.
        constexpr double infinite = std::numeric_limits<double>::infinity();
        const chart::Range range = time_.range.value_or(chart::Range{-infinite, infinite});
        context.window.file = table_dialog(
            "Save the marker's curves", name,
            commands::marker_curves_csv(context.state, range.lowest, range.highest, overlaid_));
    }
    context.items.mark("markers/csv");
    tooltip(context.theme,
            "The visible time range of this marker [s, m]: measured, simulated, simulated \xe2\x88\x92 measured, every "
            "compared run and the other trials that are drawn, each in x, y and z");
    if (ImGui::MenuItem("Drawing (SVG)\xe2\x80\xa6", nullptr, false, !seen_.empty()))
        context.window.file = table_dialog("Save the marker's plots", name, plot::plots_svg(seen_, context.theme),
                                           ".svg");
    context.items.mark("markers/svg");
    tooltip(context.theme,
            "The visible range of the shown plots [s, mm] below each other, as vectors for a paper or a slide");
    // Taken from the framebuffer once this popup has disappeared.
    if (ImGui::MenuItem("Picture (PNG)\xe2\x80\xa6"))
        context.window.file = part_dialog("Save a picture of the plots", name, plots_);
    context.items.mark("markers/png");
    tooltip(context.theme, "The plots as shown, pixel by pixel");
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
