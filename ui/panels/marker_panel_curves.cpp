#include <imgui.h>

#include <algorithm>
#include <limits>

#include "commands/marker_csv.hpp"
#include "panels/marker_panel.hpp"
#include "panels/widgets.hpp"

namespace myo::ui::panels {
namespace {

/// The curves of one trial for one coordinate.
struct TrialCurves {
    chart::Series measured, simulated, residual;  // simulated and residual are NaN without a run
};

/// The curves of another trial [mm], in its own colour.
TrialCurves overlaid_curves(const commands::OverlaidMarker& other, std::size_t marker, int axis, const ImVec4& color) {
    const commands::SceneTrial& trial = *other.measured;
    ImVec4 faint = color;
    const Eigen::VectorXd measured = 1e3 * trial.measured[marker].row(axis).transpose();
    Eigen::VectorXd simulated = Eigen::VectorXd::Constant(measured.size(), std::numeric_limits<double>::quiet_NaN());
    if (other.simulated_m) simulated = 1e3 * other.simulated_m->row(axis).transpose();
    faint.w = 0.7f;  // keeps the line visible where dots cover it
    return {plot::plot_series(trial.name + ", measured", trial.time_s, measured, faint, true),
            plot::plot_series(trial.name + ", simulated", trial.time_s, simulated, color),
            plot::plot_series(trial.name, trial.time_s, simulated - measured, color)};
}

/// A run of another version of the experiment may lack the marker or have other samples.
bool can_be_compared(const commands::WorkbenchState& state) {
    const auto m = static_cast<std::size_t>(state.marker);
    const commands::SimulatedTrial* simulated = state.simulated_trial();
    return simulated && m < simulated->markers.size() &&
           simulated->markers[m].cols() == state.scene_trial()->time_s.size();
}

/// Plot of a coordinate over time, still without curves.
plot::Plot motion_plot(const std::string& axis_name, double time_s) {
    plot::Plot plot;
    plot.id = "plot/" + axis_name;
    plot.panel.y = {.label = axis_name, .unit = "mm"};
    plot.cursor = time_s;
    plot.panel.vertical = {{0.0, ""}};
    plot.selectable = true;
    return plot;
}

/// Curves of another trial, in the plot of the motion and in that of the residual.
void add_overlaid(plot::Plot& plot, plot::Plot& strip, const commands::OverlaidMarker& other, TrialCurves curves,
                  const plot::HiddenSeries& hidden) {
    // The residual has no legend of its own; hiding the simulated curve hides its residual, too.
    if (hidden.count(curves.simulated.name) > 0)
        std::fill(curves.residual.y.begin(), curves.residual.y.end(), std::numeric_limits<double>::quiet_NaN());
    plot.panel.series.push_back(std::move(curves.measured));
    if (other.simulated_m) plot.panel.series.push_back(std::move(curves.simulated));
    strip.panel.series.push_back(
        std::move(curves.residual));  // also without values, so that both plots get the same time range
}

/// Curves of the shown trial and of the compared runs.
void add_shown(plot::Plot& plot, plot::Plot& strip, const PanelContext& context, int axis, bool compare) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const auto m = static_cast<std::size_t>(state.marker);
    const commands::SceneTrial& trial = *state.scene_trial();
    const commands::SimulatedTrial* simulated = state.simulated_trial();
    const Eigen::VectorXd measured = 1e3 * trial.measured[m].row(axis).transpose();
    const bool seen = commands::is_seen(trial, m);
    // A marker that was never seen has no measured curve, not one of gaps.
    if (seen) plot.panel.series.push_back(plot::plot_series("measured", trial.time_s, measured, theme.measured, true));
    if (compare) {
        const Eigen::VectorXd predicted = 1e3 * simulated->markers[m].row(axis).transpose();
        plot.panel.series.push_back(plot::plot_series("simulated", trial.time_s, predicted, theme.simulated));
        if (seen)
            strip.panel.series.push_back(plot::plot_series("simulated \xe2\x88\x92 measured", trial.time_s,
                                                           predicted - measured, theme.failure));
    }
    // Compared runs have the colours of their rings in the view.
    for (const commands::ComparedMarker& other : commands::compared_markers(state))
        plot.panel.series.push_back(plot::plot_series(other.name, trial.time_s,
                                                      1e3 * other.position_m->row(axis).transpose(),
                                                      theme.muscle(static_cast<int>(other.record))));
}

}  // namespace

const ImVec4& MarkerPanel::overlay_color(const platform::Theme& theme, std::size_t trial) {
    // Indices in Theme::muscles.
    constexpr std::array<int, 4> colors{3, 2, 7, 6};
    return theme.muscle(colors[trial % colors.size()]);
}

void MarkerPanel::draw_residual(PanelContext& context, int axis, plot::Plot strip, const ImVec2& size) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const auto a = static_cast<std::size_t>(axis);
    // Both plots share the time axis, so they are drawn without a gap.
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    strip.id = std::string("residual/") + axis_names[a];
    strip.panel.y = {.label = size.x > 240.0f * theme.scale ? "simulated \xe2\x88\x92 measured" : "difference",
                     .unit = "mm",
                     .include_zero = true};
    strip.cursor = state.time_s;
    strip.panel.vertical = {{0.0, ""}};
    strip.selectable = true;
    plot::HiddenSeries none;
    const plot::PlotResult below = plot::draw_plot(strip, size, theme, context.items, time_, residual_[a], none);
    seen_.push_back(plot::seen_chart(strip, below.area, none));
    if (below.cursor) context.emit(commands::SetTime{*below.cursor});
}

/// The plot of one coordinate and, if there is a run and enough height, its residual below with the same time axis.
/// Measured samples are dots, simulations lines.
void MarkerPanel::draw_component(PanelContext& context, int axis, const ImVec2& size) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const auto a = static_cast<std::size_t>(axis);
    const auto m = static_cast<std::size_t>(state.marker);
    const bool compare = can_be_compared(state);
    plot::Plot plot = motion_plot(axis_names[a], state.time_s);
    // With other trials, one legend above all plots replaces the legend of each.
    const std::vector<commands::OverlaidMarker> others = commands::overlaid_markers(state, overlaid_);
    plot.legend = others.empty();
    // The residual plot is filled along with the main one.
    plot::Plot strip;
    // First the others, so that the shown trial is drawn over them.
    for (const commands::OverlaidMarker& other : others)
        add_overlaid(plot, strip, other, overlaid_curves(other, m, axis, overlay_color(theme, other.trial)), hidden_);
    add_shown(plot, strip, context, axis, compare);
    // In a low strip the motion keeps all the room.
    // A probe, or a trial that is only simulated, has nothing to compare with.
    const bool residual = compare && commands::is_seen(*state.scene_trial(), m) && size.y > 110.0f * theme.scale;
    plot.x_labels = !residual;
    // At least high enough for its axis labels.
    const float residual_height = residual ? std::max(76.0f * theme.scale, 0.42f * size.y) : 0.0f;
    const plot::PlotResult main = plot::draw_plot(plot, {size.x, size.y - residual_height}, theme, context.items, time_,
                                                  main_[a], hidden_);
    seen_.push_back(plot::seen_chart(plot, main.area, hidden_));
    // A click in any plot moves the shown time of the whole window.
    if (main.cursor) context.emit(commands::SetTime{*main.cursor});
    if (!residual) return;
    draw_residual(context, axis, std::move(strip), {size.x, residual_height});
}

}  // namespace myo::ui::panels
