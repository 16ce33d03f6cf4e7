#include <imgui.h>

#include <algorithm>
#include <map>

#include "commands/actuator_drawing.hpp"
#include "panels/signal_panel.hpp"
#include "panels/signal_series.hpp"

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

}  // namespace

bool SignalPanel::draw_commands(PanelContext& context) {
    const commands::SceneTrial* const trial = context.state.scene_trial();
    if (!context.state.body || context.state.actuators.empty() || !trial || trial->commands.empty()) return false;
    std::map<std::string, plot::Plot> plots = plots_of(context, *trial);
    const auto count = static_cast<float>(plots.size());
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    // The plots share the height, whatever their number.
    const float height = (ImGui::GetContentRegionAvail().y - (count - 1.0f) * gap) / count;
    for (auto& [unit, plot] : plots) {
        const plot::PlotResult drawn = plot::draw_plot(plot, {ImGui::GetContentRegionAvail().x, height}, context.theme,
                                                       context.items, time_, command_plots_[unit], hidden_);
        if (drawn.cursor) context.emit(commands::SetTime{*drawn.cursor});
    }
    return true;
}

}  // namespace myo::ui::panels
