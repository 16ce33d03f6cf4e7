#include "panels/region_tool.hpp"

#include <imgui.h>

#include "commands/region_drawing.hpp"
#include "panels/actuator_edits.hpp"
#include "panels/declared_rows.hpp"
#include "panels/view_points.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// The cavity that a triangle of the body's surface bounds; null: it is no inner wall.
const commands::SceneCavity* cavity_at(const commands::Scene& scene, int triangle) {
    const Eigen::Vector3i corners = scene.surface.triangles.col(triangle);
    for (const commands::SceneCavity& cavity : scene.declared.cavities)
        for (const auto& wall : cavity.wall.triangles.colwise())
            if (wall == corners) return &cavity;
    return nullptr;
}

/// Box around the wall of a cavity [m], for the tint.
Box box_of(const commands::SceneCavity& cavity) {
    Box box{cavity.inside_m, cavity.inside_m};
    for (const auto& wall : cavity.wall.triangles.colwise())
        for (const int corner : wall) {
            box.lowest = box.lowest.cwiseMin(cavity.wall.vertices.col(corner));
            box.highest = box.highest.cwiseMax(cavity.wall.vertices.col(corner));
        }
    return box;
}

}  // namespace

void RegionTool::update(const ToolView& tool, Placing& placing) {
    if (placing.sets(Placing::Kind::box)) return update_box(tool, placing);
    update_cavity(tool, placing);
}

void RegionTool::update_box(const ToolView& tool, Placing& placing) {
    const auto under = tool.view.hovered ? surface_under_mouse(tool) : std::nullopt;
    // The face is sought only when the mouse reaches another triangle.
    if (!under)
        hover(std::nullopt, -1);
    else if (under->triangle != triangle_)
        hover(tool.surface.box_around(tool.surface.around(under->triangle)), under->triangle);
    draw_hint(tool.context, tool.view, "Click " + placing.what + ". Esc ends.", "view/placing_hint");
    if (!tool.clicked() || !hovered_m_) return;
    const std::string text = box_text(*hovered_m_);
    const commands::DeclarationEdit edit = placing.adds
                                               ? commands::DeclarationEdit(
                                                     commands::AppendDeclared{placing.box, "box_m = " + text + "\n"})
                                               : commands::DeclarationEdit(commands::SetDeclared{placing.box, text});
    tool.context.emit(commands::EditDeclaration{{edit}, placing.item + "/pick"});
    // One pick, one box: the tool ends with the click.
    placing = {};
    clear();
}

void RegionTool::update_cavity(const ToolView& tool, Placing& placing) {
    const commands::Scene& scene = *tool.context.state.scene;
    const auto under = tool.view.hovered ? surface_under_mouse(tool) : std::nullopt;
    const commands::SceneCavity* const cavity = under ? cavity_at(scene, under->triangle) : nullptr;
    // A cavity that is a chamber already cannot be taken; the hint says so.
    if (!cavity || !cavity->chamber.empty())
        hover(std::nullopt, -1);
    else if (under->triangle != triangle_)
        hover(box_of(*cavity), under->triangle);
    const std::string hint = !cavity ? "Click the wall of a cavity. Esc ends."
                             : !cavity->chamber.empty()
                                 ? "This cavity is the chamber " + cavity->chamber + "."
                                 : "Click for a chamber of " + plot::value_label(1e6 * cavity->volume_m3, 3) +
                                       " cm\xc2\xb3.";
    draw_hint(tool.context, tool.view, hint, "view/placing_hint");
    if (!tool.clicked() || !hovered_m_ || !cavity) return;
    add_chamber(tool.context, *cavity);
    placing = {};
    clear();
}

void RegionTool::hover(const std::optional<Box>& box, int triangle) {
    if (box || hovered_m_) ++revision_;
    hovered_m_ = box;
    triangle_ = triangle;
}

void RegionTool::clear() { hover(std::nullopt, -1); }

void RegionTool::show(const platform::Theme& theme, viewport::DrawnScene& drawn) const {
    if (hovered_m_) commands::add_region(drawn, *hovered_m_, viewport::color_of(theme.accent));
}

}  // namespace myo::ui::panels
