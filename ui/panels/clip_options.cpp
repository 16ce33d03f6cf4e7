#include "panels/clip_options.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "panels/widgets.hpp"

namespace myo::ui::panels {
namespace {

/// Least and greatest position of the body at rest along the normal [m].
std::array<double, 2> extent_along(const commands::MeshedBody& body, const Eigen::Vector3d& normal) {
    const Eigen::RowVectorXd along = normal.transpose() * body.mesh.nodes;
    return {along.minCoeff(), along.maxCoeff()};
}

/// Changes the direction of the plane and moves it to the middle of the body. A position along another direction means
/// nothing.
void turn(const commands::MeshedBody& body, commands::ClipPlane& plane, const Eigen::Vector3d& normal) {
    plane.normal = normal;
    const auto [lowest, highest] = extent_along(body, normal);
    plane.position_m = 0.5 * (lowest + highest);
}

/// Buttons of the direction of the plane.
void draw_clip_directions(PanelContext& context, const viewport::Camera& camera, commands::ClipPlane& plane) {
    const commands::MeshedBody& body = *context.state.body;
    struct Direction {
        const char* label;
        const char* name;
        Eigen::Vector3d normal;
        const char* tip;
    };
    // "View" depends on the camera, so the table is built in each frame.
    const Direction directions[] = {{"X", "view/clip_x", Eigen::Vector3d::UnitX(), "Normal to the x axis"},
                                    {"Y", "view/clip_y", Eigen::Vector3d::UnitY(), "Normal to the y axis"},
                                    {"Z", "view/clip_z", Eigen::Vector3d::UnitZ(), "Normal to the z axis"},
                                    {"View", "view/clip_view", viewport::camera_axes(camera).back,
                                     // The direction is copied: the cut must not move when the user looks at it from
                                     // the side.
                                     "Normal to the present view direction; stays when the view turns"}};
    bool first = true;
    for (const Direction& direction : directions) {
        if (!first) ImGui::SameLine();
        first = false;
        if (tab(context.theme, (std::string(direction.label) + "##clip").c_str(), plane.normal == direction.normal))
            turn(body, plane, direction.normal);
        context.items.mark(direction.name);
        tooltip(context.theme, direction.tip);
    }
}

}  // namespace

void draw_clip_options(PanelContext& context, const viewport::Camera& camera, NumberEdits& edits,
                       commands::ViewOptions& view) {
    if (!context.state.body) return;
    const commands::MeshedBody& body = *context.state.body;
    commands::ClipPlane& plane = view.clip;
    ImGui::Separator();
    // Switching on puts the plane into the middle, where it always cuts the body.
    if (ImGui::Checkbox("Cut the body open", &plane.on) && plane.on) turn(body, plane, plane.normal);
    context.items.mark("view/clip");
    tooltip(context.theme,
            "Hides the elements whose centre at rest, X, lies beyond a plane: n \xc2\xb7 X > d. The selection does "
            "not change while the body moves.");
    if (!plane.on) return;
    draw_clip_directions(context, camera, plane);
    const auto [lowest, highest] = extent_along(body, plane.normal);
    // The slider covers exactly the extent of the body along the present direction.
    float position = static_cast<float>(1e3 * plane.position_m);
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    if (ImGui::SliderFloat("##clip", &position, static_cast<float>(1e3 * lowest), static_cast<float>(1e3 * highest), "",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
        plane.position_m = 1e-3 * static_cast<double>(position);
    context.items.mark("view/clip_position");
    const std::string tip = "Position d of the plane along its normal, in coordinates of the body at rest.";
    tooltip(context.theme, tip);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(90.0f * context.theme.scale);
    const NumberField field{"Plane", "view/clip_place",      commands::Dimension::length, "mm", tip, {lowest, highest},
                            0.1,     "position of the plane"};
    bool goes_on = false;
    number_field(context, field, edits, plane.position_m, goes_on);
    ImGui::Checkbox("Show the other part", &plane.flip);
    context.items.mark("view/clip_flip");
}

}  // namespace myo::ui::panels
