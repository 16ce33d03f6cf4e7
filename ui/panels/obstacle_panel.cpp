#include "panels/obstacle_panel.hpp"

#include <imgui.h>

#include <array>
#include <utility>

#include "commands/place_text.hpp"
#include "mesh/surface_mesh.hpp"
#include "panels/declared_list.hpp"
#include "panels/declared_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Where new obstacles are, as shares of the body's diagonal.
struct NewObstaclePolicy {
    double gap = 0.02;   // below the body, so that nothing touches at first
    double size = 0.15;  // radius, and half the edge of a box
};
constexpr NewObstaclePolicy new_obstacle_policy;

/// Side of the body on which gravity puts it down: the axis closest to gravity; -z without gravity.
struct Downward {
    int axis = 2;
    double sign = -1.0;  // of the direction along the axis
};
/// @param gravity  [m/s²], in the frame of the mesh
Downward downward(const Eigen::Vector3d& gravity) {
    Downward down;
    if (gravity.isZero()) return down;
    gravity.cwiseAbs().maxCoeff(&down.axis);
    down.sign = gravity(down.axis) < 0.0 ? -1.0 : 1.0;
    return down;
}

/// Shapes of obstacles that can be added.
enum class Shape { plane, sphere, box };

/// Lines of a new obstacle just below the body.
std::string new_obstacle(const commands::Scene& scene, Shape shape) {
    const Box body = mesh::bounding_box(scene.surface.vertices);
    const Downward down = downward(scene.gravity_m_s2);
    const double diagonal = body.size().norm(), half = new_obstacle_policy.size * diagonal;
    const Eigen::Vector3d along = down.sign * Eigen::Vector3d::Unit(down.axis);
    // Middle of the side that faces down, moved off the body.
    Eigen::Vector3d point = 0.5 * (body.lowest + body.highest);
    point(down.axis) = (down.sign < 0.0 ? body.lowest : body.highest)(down.axis);
    point += new_obstacle_policy.gap * diagonal * along;
    if (shape == Shape::plane)
        // Adding zero turns the negative zeros of -along into zeros, so that the text has none.
        return "kind = \"plane\"\npoint_m = " + commands::place_text(point) +
               "\nnormal = " + toml::toml_vector(-along + Eigen::Vector3d::Zero()) + "\n";
    const Eigen::Vector3d centre = point + half * along;
    if (shape == Shape::sphere)
        return "kind = \"sphere\"\ncentre_m = " + commands::place_text(centre) +
               "\nradius_m = " + toml::toml_number(half) + "\n";
    return "kind = \"box\"\nbox_m = " + box_text({centre.array() - half, centre.array() + half}) + "\n";
}

/// Name of the shape in headings.
const char* title_of(const commands::SceneObstacle& obstacle) {
    if (std::holds_alternative<commands::ScenePlane>(obstacle.shape)) return "Plane";
    return std::holds_alternative<commands::SceneSphere>(obstacle.shape) ? "Sphere" : "Box";
}

/// Field of a coordinate; vector_rows() adds label and name.
NumberField place_field(const char* tip) {
    return {"", "", commands::Dimension::length, "mm", tip, {-10.0, 10.0}, 0.05};
}

/// Rows of the numbers of a shape. `path`: of the obstacle in the declaration.
void draw_shape(PanelContext& context, const commands::SceneObstacle& obstacle, const toml::TomlPath& path,
                const std::string& item, NumberEdits& edits) {
    const auto inside = [&](const char* key) {
        toml::TomlPath place = path;
        place.emplace_back(key);
        return place;
    };
    // The rows are those of the keys that the kind of obstacle has in the declaration.
    if (const auto* plane = std::get_if<commands::ScenePlane>(&obstacle.shape)) {
        vector_rows(context, {inside("point_m"), item + "/point"}, "Point",
                    place_field("A point of the plane [m], in the frame of the mesh."), edits, plane->point_m);
        // The normal has no unit, and its length does not count.
        const NumberField normal{
            "",          "",   commands::Dimension::number, "", "Normal, towards the body; its length does not count.",
            {-1.0, 1.0}, 0.005};
        vector_rows(context, {inside("normal"), item + "/normal"}, "Normal", normal, edits, plane->normal);
    } else if (const auto* sphere = std::get_if<commands::SceneSphere>(&obstacle.shape)) {
        vector_rows(context, {inside("centre_m"), item + "/centre"}, "Centre",
                    place_field("Centre of the sphere [m], in the frame of the mesh."), edits, sphere->centre_m);
        double radius_m = sphere->radius_m;
        bool goes_on = false;
        const NumberField field{
            "Radius", item + "/radius", commands::Dimension::length, "mm", "Radius of the sphere [m].", {1e-6, 10.0},
            0.05};
        if (number_row(context, field, edits, radius_m, goes_on))
            context.emit(commands::EditDeclaration{
                {commands::SetDeclared{inside("radius_m"), toml::toml_number(radius_m)}}, field.name, goes_on});
    } else {
        box_rows(context, {inside("box_m"), item + "/box"}, edits, std::get<Box>(obstacle.shape));
    }
}

}  // namespace

void ObstaclePanel::draw(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    if (scene.obstacles.empty()) muted_text(context.theme, "Nothing is in the way of the body.");
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) draw_obstacle(context, i);
    // Buttons in one line, "Add a plane", "a sphere", "a box".
    struct New {
        const char* label;
        const char* item;
        Shape shape;
    };
    constexpr std::array<New, 3> all{{{"Add a plane", "obstacle/add_plane", Shape::plane},
                                      {"a sphere", "obstacle/add_sphere", Shape::sphere},
                                      {"a box", "obstacle/add_box", Shape::box}}};
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    for (const New& added : all) {
        if (ImGui::Button(added.label, {third, 0.0f})) {
            context.emit(commands::EditDeclaration{
                {commands::AppendDeclared{{"obstacle"}, new_obstacle(scene, added.shape)}}, added.item});
            // Open at once, so that the view highlights it and its numbers can be set.
            open_item(context, "obstacle/" + std::to_string(scene.obstacles.size()));
        }
        context.items.mark(added.item);
        tooltip(context.theme, "A rigid obstacle that stands still, at first just below the body.");
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void ObstaclePanel::draw_obstacle(PanelContext& context, std::size_t index) {
    const commands::SceneObstacle& obstacle = context.state.scene->obstacles[index];
    const std::string item = "obstacle/" + std::to_string(index);
    const toml::TomlPath path{"obstacle", index};
    const ItemPress press = item_heading(
        context,
        {item, std::string(title_of(obstacle)) + " " + std::to_string(index + 1),
         "A rigid obstacle. It pushes the body's surface back where that reaches into it.", "Remove the obstacle"});
    if (press == ItemPress::removed)
        context.emit(commands::EditDeclaration{{commands::RemoveDeclared{path}}, item + "/remove"});
    if (!is_open(context, item)) return;
    draw_shape(context, obstacle, path, item, edits_);
    // Every shape has a coefficient of friction.
    double friction = obstacle.friction;
    bool goes_on = false;
    const NumberField field{"Friction \xce\xbc",
                            item + "/friction",
                            commands::Dimension::ratio,
                            "",
                            "Coulomb's coefficient of friction, dimensionless.",
                            {0.0, 10.0},
                            0.005,
                            "coefficient of friction"};
    if (number_row(context, field, edits_, friction, goes_on))
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{{"obstacle", index, "friction"}, toml::toml_number(friction)}},
            field.name,
            goes_on});
}

}  // namespace myo::ui::panels
