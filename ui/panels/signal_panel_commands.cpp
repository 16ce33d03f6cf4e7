#include <imgui.h>

#include <algorithm>
#include <map>

#include "commands/actuator_drawing.hpp"
#include "commands/command_knots.hpp"
#include "panels/actuator_edits.hpp"
#include "panels/command_field.hpp"
#include "panels/signal_panel.hpp"
#include "panels/signal_series.hpp"
#include "plot/draw_chart.hpp"

namespace myo::ui::panels {
namespace {

/// Time axis of a trial without duration.
struct HeldPlotPolicy {
    double around_s = 0.5;  // time that is drawn before and behind a held pose
};
constexpr HeldPlotPolicy held_plot_policy;

/// Plots of the commands of a trial by their unit: pressures, tensions, shortenings.
std::map<std::string, plot::Plot> plots_of(const PanelContext& context, const commands::SceneTrial& trial) {
    const std::array<double, 2> shown = commands::time_span(context.state);
    std::map<std::string, plot::Plot> plots;
    std::size_t actuator = 0;
    const auto add = [&](const std::string& name, const char* what) {
        // Counted also where the trial has no command, as the colour belongs to the actuator.
        const viewport::Color color = commands::actuator_color(context.state, context.theme, actuator++);
        const auto found = trial.commands.find(name);
        if (found == trial.commands.end()) return;
        const commands::ShownCommand& command = found->second;
        plot::Plot& plot = plots[command.unit];
        plot.id = "plot/command/" + command.unit;
        plot.panel.y = {.label = what, .unit = command.unit};
        plot.panel.y.include = {0.0};
        plot.cursor = context.state.time_s;
        chart::Range span{std::min(shown[0], command.signal.times_s.front()),
                          std::max(shown[1], command.signal.times_s.back())};
        // A pose that is held has no duration; its commands are drawn as the lines that they are.
        if (!(span.highest > span.lowest))
            span = {span.lowest - held_plot_policy.around_s, span.highest + held_plot_policy.around_s};
        plot.panel.series.push_back(
            signal_series(name, command.signal, span, ImVec4(color.x(), color.y(), color.z(), 1.0f), command.per_unit));
        plot.legend = plot.panel.series.size() > 1;
    };
    for (const commands::ShownChamber& chamber : context.state.actuators.chambers) add(chamber.name, "pressure");
    for (const commands::ShownTendon& tendon : context.state.actuators.tendons)
        add(tendon.name,
            trial.commands.count(tendon.name) && trial.commands.at(tendon.name).unit == "N" ? "tension" : "shortening");
    return plots;
}

/// Knots of the commands in a plot, except for those of hidden curves and of actuation files.
std::vector<KnotCurve> curves_of(const PanelContext& context, const plot::Plot& plot,
                                 const plot::HiddenSeries& hidden) {
    const commands::Scene& scene = *context.state.scene;
    const auto trial = static_cast<std::size_t>(context.state.trial);
    std::vector<KnotCurve> curves;
    if (trial >= scene.declared.commands.size()) return curves;
    for (const chart::Series& series : plot.panel.series) {
        const auto actuator = declared_actuator(scene, series.name);
        if (!actuator || hidden.count(series.name) > 0) continue;
        const auto& declared = scene.declared.commands[trial];
        const auto command = declared.find(series.name);
        const bool any = command != declared.end();
        if (any && command->second.kind == commands::DeclaredCommand::Kind::file) continue;
        const CommandField& field = command_field(*actuator);
        const commands::ShownCommand& shown = scene.trials[trial].commands.at(series.name);
        curves.push_back({series.name, "signals/knot/" + series.name,
                          commands::knots_of(any ? &command->second : nullptr), field.quantity, field.dimension,
                          shown.unit, shown.per_unit, field.limits, plot::window_colour(*series.own_colour)});
        // A pose that is held has constants only.
        curves.back().constant = scene.trials[trial].time_s.size() < 2;
    }
    return curves;
}

}  // namespace

bool SignalPanel::has_commands(const commands::WorkbenchState& state) {
    const commands::SceneTrial* const trial = state.scene_trial();
    return state.body && !state.actuators.empty() && trial && !trial->commands.empty();
}

void SignalPanel::draw_commands(PanelContext& context) {
    std::map<std::string, plot::Plot> plots = plots_of(context, *context.state.scene_trial());
    draw_zoom(context);
    ImGui::SameLine();
    knots_.snap_button(context);
    const auto count = static_cast<float>(plots.size());
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    // The plots share the height, whatever their number.
    const float height = (ImGui::GetContentRegionAvail().y - (count - 1.0f) * gap) / count;
    for (auto& [unit, plot] : plots)
        draw_command_plot(context, unit, std::move(plot), {ImGui::GetContentRegionAvail().x, height});
}

void SignalPanel::draw_command_plot(PanelContext& context, const std::string& unit, plot::Plot plot,
                                    const ImVec2& size) {
    const std::vector<KnotCurve> curves = curves_of(context, plot, hidden_);
    plot.editable = !curves.empty();
    // While a knot is dragged, the plot must not pan.
    plot.held = knots_.held();
    plot::PlotState& state = command_plots_[unit];
    const plot::PlotResult drawn = plot::draw_plot(plot, size, context.theme, context.items, time_, state, hidden_);
    if (drawn.cursor) context.emit(commands::SetTime{*drawn.cursor});
    const auto edit = knots_.edit(context, {drawn, time_, state}, curves);
    if (!edit) return;
    const auto actuator = declared_actuator(*context.state.scene, curves[edit->curve].name);
    set_command(context, *actuator, static_cast<std::size_t>(context.state.trial), commands::command_of(edit->signal),
                edit->goes_on);
}

}  // namespace myo::ui::panels
