#include "panels/actuator_rows.hpp"

#include <imgui.h>

#include "commands/actuator_drawing.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// The command of an actuator at the shown time: "25 kPa"; empty without a trial.
std::string command_now(const commands::WorkbenchState& state, const std::string& name) {
    const commands::SceneTrial* const trial = state.scene_trial();
    if (!trial) return {};
    const auto command = trial->commands.find(name);
    if (command == trial->commands.end()) return {};
    const commands::ShownCommand& shown = command->second;
    return plot::value_label(shown.signal.value(state.time_s) / shown.per_unit, 3) + " " + shown.unit;
}

/// Row of an actuator: square in its colour, name, kind, and at the right its command at the shown time.
///
/// @param actuator  index of its colour: chambers first, then tendons
void draw_row(PanelContext& context, std::size_t actuator, const std::string& name, const std::string& kind,
              const std::string& tip) {
    const platform::Theme& theme = context.theme;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float box = ImGui::GetTextLineHeight();
    const viewport::Color color = commands::actuator_color(context.state, theme, actuator);
    // As wide as the square and its gap in the list of muscles, so that the names of both align.
    ImGui::TextUnformatted(("        " + name).c_str());
    context.items.mark("fibres/actuator/" + name);
    tooltip(theme, tip.c_str());
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x + 2.0f * theme.scale, at.y + 1.0f}, {at.x + 2.0f * theme.scale + box, at.y + box - 1.0f},
        platform::packed(ImVec4(color.x(), color.y(), color.z(), 1.0f)), 3.0f * theme.scale);
    ImGui::SameLine();
    ImGui::TextColored(theme.muted, "%s", kind.c_str());
    const std::string command = command_now(context.state, name);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(command.c_str()).x);
    ImGui::TextUnformatted(command.c_str());
}

}  // namespace

void draw_actuators(PanelContext& context) {
    if (!context.state.body || context.state.actuators.empty()) return;
    const commands::BodyActuators& actuators = context.state.actuators;
    heading(context.theme, actuators.tendons.empty()    ? "Chambers"
                           : actuators.chambers.empty() ? "Tendons"
                                                        : "Chambers and tendons");
    // Colours are numbered over chambers and tendons together, as in the view.
    std::size_t actuator = 0;
    for (const commands::ShownChamber& chamber : actuators.chambers)
        draw_row(context, actuator++, chamber.name, "chamber",
                 "Air chamber of " + plot::value_label(1e6 * chamber.volume_m3, 3) + " cm\xc2\xb3 with walls of " +
                     plot::value_label(1e4 * chamber.wall_area_m2, 3) +
                     " cm\xc2\xb2 at rest. Its pressure at the shown time, above that outside.");
    for (const commands::ShownTendon& tendon : actuators.tendons)
        draw_row(context, actuator++, tendon.name, "tendon",
                 "Thread through " + std::to_string(tendon.guides.size()) +
                     " guides, the motor's end first. Its tension at the motor, or the length that the motor has "
                     "taken in, at the shown time.");
    ImGui::Spacing();
}

}  // namespace myo::ui::panels
