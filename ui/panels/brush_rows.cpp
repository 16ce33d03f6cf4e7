#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "panels/brush_rows.hpp"
#include "platform/fonts.hpp"

// The brush: its radius, strength, direction and mirror.

namespace myo::ui::panels {
namespace {

/// Directions of the fibres, in the order of the enumeration in BrushSettings, as choose() requires.
const std::vector<commands::Choice>& direction_choices() {
    static const std::vector<commands::Choice> choices{
        {"stroke", "Along the stroke",
         "Fibres follow the stroke, smoothed over the brush, in the plane of the surface."},
        {"x", "Along x", "All fibres along the x axis."},
        {"y", "Along y", "All fibres along the y axis."},
        {"z", "Along z", "All fibres along the z axis."},
        {"longest", "Along the longest axis", "All fibres along the body's longest axis."}};
    return choices;
}

/// Planes of the mirror, in the order of the enumeration in BrushSettings, as choose() requires.
const std::vector<commands::Choice>& mirror_choices() {
    static const std::vector<commands::Choice> choices{
        {"none", "Off", "Paint where the mouse is."},
        {"x", "Left and right in x", "Paint on one side of the body's middle is mirrored to the other."},
        {"y", "Left and right in y", "Paint on one side of the body's middle is mirrored to the other."},
        {"z", "Above and below in z", "Paint on one side of the body's middle is mirrored to the other."}};
    return choices;
}

/// Draws a list for an enumeration whose values have the order of `choices`. Returns true if it changed.
template <class Kind>
bool choose(PanelContext& context, const char* label, const std::string& name, const char* tip,
            const std::vector<commands::Choice>& choices, Kind& kind) {
    std::string id = choices[static_cast<std::size_t>(kind)].id;
    if (!choice_row(context, label, name, tip, choices, id)) return false;
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const commands::Choice& choice) { return choice.id == id; });
    kind = static_cast<Kind>(found - choices.begin());
    return true;
}

/// A tool of the brush and its button.
struct Tool {
    commands::BrushTool tool;
    const char* icon;
    const char* label;
    const char* name;
    const char* tip;
};
constexpr std::array<Tool, 4> tools{{{commands::BrushTool::none, platform::icon::hand, "View", "/tool/view",
                                      "The mouse turns the view (Esc ends a stroke)"},
                                     {commands::BrushTool::add, platform::icon::brush, "Paint", "/tool/paint",
                                      "Drag over the body to paint (B). Ctrl erases."},
                                     {commands::BrushTool::erase, platform::icon::eraser, "Erase", "/tool/erase",
                                      "Drag over the body to remove paint (E). Ctrl paints."},
                                     {commands::BrushTool::fill, platform::icon::drop, "Fill", "/tool/fill",
                                      "Click on the body: fills the elements up to existing paint"}}};

/// Number of the brush. Brush settings are not part of undo, so it does not matter whether a drag continues.
void brush_row(PanelContext& context, const NumberField& field, NumberEdits& edit, double& value) {
    bool ignored = false;
    number_row(context, field, edit, value, ignored);
}

/// The four tools; they need a mesh that is prepared for painting. A tool that is pressed paints this part.
void draw_tools(PanelContext& context, const BrushUse& use, commands::BrushSettings& brush) {
    const platform::Theme& theme = context.theme;
    const float gap = 2.0f * theme.scale, width = std::floor((ImGui::GetContentRegionAvail().x - 3.0f * gap) / 4.0f);
    ImGui::BeginDisabled(!context.state.ground);
    for (const Tool& tool : tools) {
        // The first tool, which gives the mouse back to the view, begins the line.
        if (tool.tool != commands::BrushTool::none) ImGui::SameLine(0.0f, gap);
        const bool mine = brush.part == use.part;
        const bool chosen = mine ? brush.tool == tool.tool : tool.tool == commands::BrushTool::none;
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme.accent : theme.raised);
        ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme.on_accent : theme.text);
        if (ImGui::Button((std::string(tool.icon) + " " + tool.label).c_str(), {width, 0.0f}))
            brush.tool = tool.tool, brush.part = use.part;
        ImGui::PopStyleColor(2);
        context.items.mark(use.name + tool.name);
        tooltip(theme, tool.tip);
    }
    ImGui::EndDisabled();
}

/// Radius and depth of the brush. `reach`: size of the body [m], for the limits of the numbers.
void draw_brush_extent(PanelContext& context, const BrushUse& use, NumberEdits& edit, commands::BrushSettings& brush,
                       double reach) {
    // Limits relative to the body: the radius goes up to half of its diagonal, the depth up to all of it.
    brush_row(context,
              {"Radius",
               use.name + "/radius",
               commands::Dimension::length,
               "mm",
               "Radius r of the brush [mm]: it paints the elements whose centre is at most r from the stroke, "
               "measured along the surface.",
               {1e-3 * reach, 0.5 * reach},
               0.05},
              edit, brush.radius_m);
    // A brush through the body has no depth; the number is kept for later.
    ImGui::BeginDisabled(brush.through);
    brush_row(context,
              {"Depth",
               use.name + "/depth",
               commands::Dimension::length,
               "mm",
               "Depth of the brush below the surface [mm], along the surface's normal.",
               {1e-3 * reach, reach},
               0.05},
              edit, brush.depth_m);
    ImGui::EndDisabled();
    row_label(context.theme, "", "");
    ImGui::Checkbox("through the body", &brush.through);
    context.items.mark(use.name + "/through");
}

/// Weight that the brush paints, in its centre and towards its edge.
void draw_brush_weight(PanelContext& context, NumberEdits& edit, commands::BrushSettings& brush) {
    brush_row(context,
              // s² (3 - 2 s) is the cubic smoothstep: its slope is zero at both ends, so that the edge has no visible
              // line.
              {"Soft edge",
               "fibres/falloff",
               commands::Dimension::ratio,
               "%",
               "Share q of the radius over which the weight falls to zero: at the distance d from the stroke it is "
               "the strength times s² (3 − 2 s), s = (r − d) / (q r), at most 1.",
               {0.0, 1.0},
               0.5},
              edit, brush.falloff);
    brush_row(context,
              {"Strength",
               "fibres/strength",
               commands::Dimension::ratio,
               "%",
               "Weight in the centre: the share of an element that becomes muscle. The fibres' energy w/2 (|F m| − "
               "a)² is scaled by it.",
               {0.01, 1.0},
               0.5},
              edit, brush.strength);
}

}  // namespace

void brush_rows(PanelContext& context, const BrushUse& use, NumberEdits& edit) {
    const commands::WorkbenchState& state = context.state;
    const bool fibres = use.part < 0;
    ImGui::Spacing();
    // Edited as a copy; one command at the end if anything changed.
    commands::BrushSettings brush = state.brush;
    // One button per tool; the tooltips name the shortcuts.
    draw_tools(context, use, brush);
    // Limits of the numbers follow the size of the body; a metre before it is meshed.
    const double reach = state.body ? mesh::bounding_box(state.body->mesh.nodes).size().norm() : 1.0;
    const bool mine = brush.part == use.part;
    const bool strokes = mine && (brush.tool == commands::BrushTool::add || brush.tool == commands::BrushTool::erase);
    if (strokes) draw_brush_extent(context, use, edit, brush, reach);
    if (strokes && fibres) draw_brush_weight(context, edit, brush);
    if (mine && fibres && (brush.tool == commands::BrushTool::add || brush.tool == commands::BrushTool::fill))
        choose(context, "Direction", use.name + "/direction", "Direction of the fibres.", direction_choices(),
               brush.direction);
    if (strokes)
        choose(context, "Mirror", use.name + "/mirror", "Paints both halves of the body.", mirror_choices(),
               brush.mirror);
    if (!(brush == state.brush)) context.emit(commands::ChangeBrush{brush});
}

}  // namespace myo::ui::panels
