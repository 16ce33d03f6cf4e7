#include "commands/setup_drawing.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

#include "commands/obstacle_lines.hpp"
#include "plot/number_text.hpp"
#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {
namespace {

using Eigen::Vector3d;

// Lengths as shares of the diagonal of the rest shape.
constexpr double longest_load = 0.25;   // arrow of the largest force
constexpr double shortest_load = 0.08;  // so that the direction of small forces is visible
constexpr double gravity_arrow = 0.1;
constexpr double gravity_gap = 0.03;  // between the body and the arrow above it
constexpr double mass_thread = 0.06;  // by which a mass hangs
constexpr double mass_size = 0.03;    // half edge of the weight
constexpr double ended_alpha = 0.3;   // opacity of a force at times in which it does not act
constexpr double line_width = 1.5, edited_width = 2.5, load_width = 2.5;  // [pixels]

/// How parts are shown on the elements.
struct PartLookPolicy {
    double least_share = 0.5;  // of a cell, from which on it shows a part
    float tint = 0.45f;        // opacity of a part's colour
};
constexpr PartLookPolicy part_policy;

/// Three digits and the unit: "0.25 N".
std::string amount(double value, double per_unit, const std::string& unit) {
    return plot::plain_label(value / per_unit, 3) + " " + unit;
}

/// Lines of a thing: in the accent colour and wider while it is edited.
struct Pen {
    viewport::Color color;
    double width;
};
/// Pen of an item of a panel. `color` and `alpha` while it is not edited.
Pen pen_of(const WorkbenchState& state, const platform::Theme& theme, const std::string& item, const ImVec4& color,
           float alpha) {
    if (state.view.edited == item) return {viewport::color_of(theme.accent), edited_width};
    return {viewport::color_of(color, alpha), line_width};
}

/// Edges of a box.
void add_box(viewport::DrawnScene& drawn, const Box& box, const Pen& pen) {
    for (viewport::DrawnLine& line : viewport::box_lines(box, pen.color, pen.width))
        drawn.lines.push_back(std::move(line));
}

/// Lines of all obstacles. Planes are as large as the body.
void add_obstacles(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    for (std::size_t i = 0; i < state.scene->obstacles.size(); ++i) {
        const Pen pen = pen_of(state, theme, "obstacle/" + std::to_string(i), theme.text, 0.55f);
        for (viewport::DrawnLine& line : obstacle_lines(state.scene->obstacles[i], drawn.extent, pen.color, pen.width))
            drawn.lines.push_back(std::move(line));
    }
}

/// Part that a cell shows: during a stroke the painted part has what the brush left, and no more.
int shown_part(const WorkbenchState& state, const std::vector<int>& part_of_cell, const fibre::CellPaint* live,
               Eigen::Index cell) {
    const int part = part_of_cell.empty() ? -1 : part_of_cell[static_cast<std::size_t>(cell)];
    if (!live) return part;
    if (live->weights(cell) >= part_policy.least_share) return state.brush.part;
    return part == state.brush.part ? -1 : part;
}

/// Tints the elements of parts where no muscle and no chamber has a colour. An open or painted part is shown over them.
void tint_parts(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
                const std::vector<int>& part_of_cell, const fibre::CellPaint* live) {
    if (!drawn.body || !state.body) return;
    const Eigen::Index cells = state.body->mesh.cell_count();
    if (live && live->count() != cells) live = nullptr;
    if (!live && part_of_cell.size() != static_cast<std::size_t>(cells)) return;
    const mesh::BoundaryFaces& faces = drawn.body->faces;
    // Tints of another number of faces are not those of the drawn body.
    if (drawn.tints.cols() != 0 && drawn.tints.cols() != faces.count()) return;
    if (drawn.tints.cols() == 0) drawn.tints = Eigen::Matrix4Xf::Zero(4, faces.count());
    for (Eigen::Index f = 0; f < faces.count(); ++f) {
        const int part = shown_part(state, part_of_cell, live, faces.cell(f));
        const bool on_top = (live && part == state.brush.part) || state.view.edited == "part/" + std::to_string(part);
        if (part < 0 || (drawn.tints(3, f) > 0.0f && !on_top)) continue;
        const viewport::Color color = viewport::color_of(part_color(state, theme, static_cast<std::size_t>(part)));
        drawn.tints.col(f) << color.head<3>(), part_policy.tint;
    }
}

/// "2 MPa", "260 kPa".
std::string modulus_text(double modulus_Pa) {
    return modulus_Pa < 1e6 ? amount(modulus_Pa, 1e3, "kPa") : amount(modulus_Pa, 1e6, "MPa");
}

/// Materials of the body and its parts, by colour.
void add_part_legend(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    if (state.scene->parts.empty()) return;
    drawn.legend.push_back({"body " + modulus_text(state.settings.youngs_modulus_Pa), viewport::color_of(theme.body)});
    for (std::size_t i = 0; i < state.scene->parts.size(); ++i)
        drawn.legend.push_back(
            {state.scene->parts[i].name + " " + modulus_text(state.scene->parts[i].youngs_modulus_Pa),
             viewport::color_of(part_color(state, theme, i))});
}

/// Boxes of the parts with their names, the tint of their elements, and the legend.
void add_parts(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
               const MotionSummary& motion, const fibre::CellPaint* live) {
    for (std::size_t i = 0; i < state.scene->parts.size(); ++i) {
        const ScenePart& part = state.scene->parts[i];
        if (!part.box_m) continue;
        const ImVec4& color = part_color(state, theme, i);
        add_box(drawn, *part.box_m, pen_of(state, theme, "part/" + std::to_string(i), color, 0.9f));
        const Vector3d top(0.5 * (part.box_m->lowest.x() + part.box_m->highest.x()), part.box_m->highest.y(),
                           part.box_m->highest.z());
        drawn.labels.push_back({top, part.name, viewport::color_of(color)});
    }
    tint_parts(drawn, state, theme, motion.part_of_cell, live);
    add_part_legend(drawn, state, theme);
}

/// Place at which a load is drawn: the middle of the loaded points as drawn, moved along the load to the last of them,
/// so that the body does not hide it. The middle of the box if it holds no point.
Vector3d place_of_load(const viewport::DrawnScene& drawn, const SceneLoad& load, const std::vector<int>& points,
                       const Vector3d& along) {
    Vector3d sum = Vector3d::Zero();
    double last = -std::numeric_limits<double>::infinity();
    int count = 0;
    for (const int point : points) {
        if (point >= drawn.positions.cols()) continue;
        sum += drawn.positions.col(point), ++count;
        last = std::max(last, along.dot(drawn.positions.col(point)));
    }
    if (count == 0) return 0.5 * (load.box_m.lowest + load.box_m.highest);
    const Vector3d middle = sum / count;
    return middle + (last - along.dot(middle)) * along;
}

/// An arrow of this length and direction, by its end and its vector [m].
void add_arrow(viewport::DrawnScene& drawn, const Vector3d& from, const Vector3d& along, const viewport::Color& color,
               double width) {
    drawn.lines.push_back({viewport::arrow_points(from, along), color, width});
}

/// A force with its amount. `length`: of the arrow [m].
void add_force(viewport::DrawnScene& drawn, const SceneLoad& load, const Vector3d& place, double length,
               const viewport::Color& color) {
    const Vector3d along = length * load.force_N.normalized();
    add_arrow(drawn, place, along, color, load_width);
    drawn.labels.push_back({place + along, amount(load.force_N.norm(), 1.0, "N"), color});
}

/// A mass is a weight on a short thread.
void add_mass(viewport::DrawnScene& drawn, const SceneLoad& load, const Vector3d& place, const Vector3d& down,
              double diagonal, const viewport::Color& color) {
    const Vector3d top = place + mass_thread * diagonal * down;
    Eigen::Matrix3Xd thread(3, 2);
    thread << place, top;
    drawn.lines.push_back({thread, color, load_width});
    const double half = mass_size * diagonal;
    const Vector3d middle = top + half * down;
    add_box(drawn, {middle.array() - half, middle.array() + half}, {color, load_width});
    drawn.labels.push_back({middle + half * down, amount(load.mass_kg, 1e-3, "g"), color});
}

/// Loads of the shown trial where they act now.
void add_loads(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
               const MotionSummary& motion) {
    const SceneTrial* const trial = state.scene_trial();
    if (!trial) return;
    // One scale for all forces of the trial, so that their arrows can be compared.
    double largest_N = 0.0;
    for (const SceneLoad& load : trial->loads) largest_N = std::max(largest_N, load.force_N.norm());
    const double diagonal = drawn.extent.size().norm();
    const Vector3d& gravity = state.scene->gravity_m_s2;
    // Without gravity a mass still has inertia; it is drawn as hanging along -z.
    const Vector3d down = gravity.norm() > 0.0 ? Vector3d(gravity.normalized()) : Vector3d(-Vector3d::UnitZ());
    const std::vector<int> nothing;
    for (std::size_t l = 0; l < trial->loads.size(); ++l) {
        const SceneLoad& load = trial->loads[l];
        if (state.view.edited == "trial/load/" + std::to_string(l))
            add_box(drawn, load.box_m, {viewport::color_of(theme.accent), edited_width});
        const bool acts = load.is_mass || load.factor(state.time_s) != 0.0;
        const viewport::Color color = viewport::color_of(theme.force, acts ? 1.0f : static_cast<float>(ended_alpha));
        const Vector3d along = load.is_mass ? down : Vector3d(load.force_N.normalized());
        const Vector3d place = place_of_load(drawn, load, l < motion.loaded.size() ? motion.loaded[l] : nothing, along);
        if (load.is_mass)
            add_mass(drawn, load, place, down, diagonal, color);
        else if (load.force_N.norm() > 0.0)
            add_force(drawn, load, place,
                      std::max(shortest_load, longest_load * load.force_N.norm() / largest_N) * diagonal, color);
    }
}

/// Share of a cell that a part holds; 0 if it is not known for this mesh.
double share_of(const WorkbenchState& state, Eigen::Index cell, std::size_t part) {
    const auto column = static_cast<Eigen::Index>(part) + 1;
    return cell < state.part_shares.rows() && column < state.part_shares.cols() ? state.part_shares(cell, column) : 0.0;
}

/// A small arrow above the body, as seen along gravity.
void add_gravity(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const Vector3d& gravity = state.scene->gravity_m_s2;
    if (!(gravity.norm() > 0.0)) return;
    const Vector3d down = gravity.normalized(), half = 0.5 * drawn.extent.size();
    const double diagonal = drawn.extent.size().norm();
    const double above = down.cwiseAbs().dot(half) + (gravity_gap + gravity_arrow) * diagonal;
    const Vector3d from = 0.5 * (drawn.extent.lowest + drawn.extent.highest) - above * down;
    const viewport::Color color = viewport::color_of(theme.muted);
    add_arrow(drawn, from, gravity_arrow * diagonal * down, color, 2.0);
    drawn.labels.push_back({from, "g " + amount(gravity.norm(), 1.0, "m/s\xc2\xb2"), color});
}

}  // namespace

const ImVec4& part_color(const WorkbenchState& state, const platform::Theme& theme, std::size_t part) {
    const std::size_t before = state.settings.muscles.size() + state.actuators.count();
    return theme.muscle(static_cast<int>(before + part));
}

void add_setup(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
               const MotionSummary& motion, const fibre::CellPaint* live) {
    if (state.view.obstacles) {
        add_obstacles(drawn, state, theme);
        add_parts(drawn, state, theme, motion, live);
    }
    if (state.view.loads) {
        add_gravity(drawn, state, theme);
        add_loads(drawn, state, theme, motion);
    }
}

std::vector<std::vector<int>> loaded_points(const WorkbenchState& state) {
    std::vector<std::vector<int>> loaded;
    const SceneTrial* const trial = state.scene_trial();
    if (!trial) return loaded;
    const Eigen::Matrix3Xd& points = state.body ? state.body->mesh.nodes : state.scene->surface.vertices;
    for (const SceneLoad& load : trial->loads) {
        std::vector<int>& inside = loaded.emplace_back();
        for (Eigen::Index i = 0; i < points.cols(); ++i)
            if (load.box_m.contains(points.col(i))) inside.push_back(static_cast<int>(i));
    }
    return loaded;
}

std::vector<int> part_of_cell(const WorkbenchState& state) {
    if (!state.scene || !state.body || state.scene->parts.empty()) return {};
    const mesh::VolumeMesh& mesh = state.body->mesh;
    std::vector<int> parts(static_cast<std::size_t>(mesh.cell_count()), -1);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        Vector3d middle = Vector3d::Zero();
        for (const int node : mesh.cells.col(c)) middle += mesh.nodes.col(node);
        middle /= static_cast<double>(mesh.cells.rows());
        // No early end: the later of overlapping parts holds.
        for (std::size_t p = 0; p < state.scene->parts.size(); ++p) {
            const auto& box = state.scene->parts[p].box_m;
            if (box ? box->contains(middle) : share_of(state, c, p) >= part_policy.least_share)
                parts[static_cast<std::size_t>(c)] = static_cast<int>(p);
        }
    }
    return parts;
}

}  // namespace myo::ui::commands
