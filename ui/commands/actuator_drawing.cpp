#include "commands/actuator_drawing.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace myo::ui::commands {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr float wall_tint = 0.7f;       // opacity of a chamber's colour on its walls
constexpr double sharp_cosine = 0.87;   // an edge is drawn if the walls turn by more than 30 degrees there
constexpr double outline_width = 3.0;   // [pixels]; thinner lines get lost behind an opaque body
constexpr double guide_length = 0.012;  // of the cross at a guide, share of the body's diagonal

/// Normal of a face at rest, by its first three nodes.
Vector3d normal_at_rest(const MeshedBody& body, int face) {
    const auto nodes = body.boundary.nodes.col(face);
    const Vector3d a = body.mesh.nodes.col(nodes[0]), b = body.mesh.nodes.col(nodes[1]),
                   c = body.mesh.nodes.col(nodes[2]);
    return (b - a).cross(c - a).normalized();
}

/// Corners of a face: three of tetrahedra, four of hexahedra.
int corners(const MeshedBody& body) { return body.mesh.type == mesh::CellType::hex8 ? 4 : 3; }

/// Edges at which the walls of a chamber turn, as a polyline with gaps.
Matrix3Xd outline(const MeshedBody& body, const std::vector<int>& walls, const Matrix3Xd& positions) {
    std::map<std::pair<int, int>, std::vector<int>> faces_at;  // both corners of an edge -> faces
    for (const int face : walls)
        for (int k = 0; k < corners(body); ++k) {
            const int a = body.boundary.nodes(k, face), b = body.boundary.nodes((k + 1) % corners(body), face);
            faces_at[std::minmax(a, b)].push_back(face);
        }
    std::vector<Vector3d> points;
    for (const auto& [edge, faces] : faces_at) {
        // Flat parts of a wall have no lines.
        if (faces.size() == 2 && normal_at_rest(body, faces[0]).dot(normal_at_rest(body, faces[1])) > sharp_cosine)
            continue;
        points.push_back(positions.col(edge.first));
        points.push_back(positions.col(edge.second));
        points.push_back(Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
    Matrix3Xd line(3, static_cast<Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) line.col(static_cast<Index>(i)) = points[i];
    return line;
}

/// Number of each face of the whole boundary among the drawn faces; -1: it is cut away.
///
/// The order of both is that of the cells and of the faces in a cell; faces of the cut may lie between the drawn ones.
std::vector<Index> drawn_numbers(const mesh::BoundaryFaces& whole, const viewport::DrawnBody& drawn) {
    std::vector<Index> numbers(static_cast<std::size_t>(whole.count()), -1);
    Index next = 0;
    for (Index f = 0; f < drawn.faces.count(); ++f) {
        while (next < whole.count() && !drawn.has(whole.cell(next))) ++next;
        if (next == whole.count()) break;
        if (drawn.faces.nodes.col(f) == whole.nodes.col(next)) numbers[static_cast<std::size_t>(next++)] = f;
    }
    return numbers;
}

/// Tints the drawn walls of a chamber, over the colours of muscles.
void tint_walls(viewport::DrawnScene& drawn, const std::vector<int>& walls, const std::vector<Index>& numbers,
                const viewport::Color& color) {
    if (drawn.tints.cols() == 0) drawn.tints = Eigen::Matrix4Xf::Zero(4, drawn.body->faces.count());
    for (const int wall : walls)
        if (const Index face = numbers[static_cast<std::size_t>(wall)]; face >= 0)
            drawn.tints.col(face) << color.head<3>(), wall_tint;
}

/// Place of a guide now [m]: the weighted mean of its nodes, or where it stands still.
Vector3d place_of(const ThreadGuide& guide, const Matrix3Xd& positions) {
    if (guide.nodes.empty()) return guide.rest_m;
    Vector3d place = Vector3d::Zero();
    for (std::size_t k = 0; k < guide.nodes.size(); ++k)
        place += guide.weights[static_cast<Index>(k)] * positions.col(guide.nodes[k]);
    return place;
}

/// Adds the thread, and a small cross at each declared guide.
void add_tendon(viewport::DrawnScene& drawn, const ShownTendon& tendon, const viewport::Color& color) {
    viewport::DrawnLine thread{Matrix3Xd(3, static_cast<Index>(tendon.guides.size())), color, 2.5}, marks = thread;
    const auto declared = std::count_if(tendon.guides.begin(), tendon.guides.end(),
                                        [](const ThreadGuide& guide) { return guide.declared; });
    // Three bars along the axes, each of two points and a gap.
    marks.points.resize(3, 9 * declared);
    const double half = 0.5 * guide_length * drawn.extent.size().norm();
    Index mark = 0;
    for (Index i = 0; i < thread.points.cols(); ++i) {
        const ThreadGuide& guide = tendon.guides[static_cast<std::size_t>(i)];
        thread.points.col(i) = place_of(guide, drawn.positions);
        if (!guide.declared) continue;
        for (Index axis = 0; axis < 3; ++axis) {
            marks.points.col(mark++) = thread.points.col(i) - half * Vector3d::Unit(axis);
            marks.points.col(mark++) = thread.points.col(i) + half * Vector3d::Unit(axis);
            marks.points.col(mark++).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
    }
    drawn.lines.push_back(std::move(thread));
    drawn.lines.push_back(std::move(marks));
}

}  // namespace

viewport::Color actuator_color(const WorkbenchState& state, const platform::Theme& theme, std::size_t actuator) {
    return viewport::color_of(theme.muscle(static_cast<int>(state.settings.muscles.size() + actuator)));
}

void add_actuators(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    if (!state.view.actuators || !state.body || state.actuators.empty() || !drawn.body ||
        drawn.positions.cols() != state.body->mesh.node_count())
        return;
    const MeshedBody& body = *state.body;
    const std::vector<Index> numbers = state.actuators.chambers.empty() ? std::vector<Index>()
                                                                        : drawn_numbers(body.boundary, *drawn.body);
    std::size_t actuator = 0;
    for (const ShownChamber& chamber : state.actuators.chambers) {
        const viewport::Color color = actuator_color(state, theme, actuator++);
        tint_walls(drawn, chamber.walls, numbers, color);
        drawn.lines.push_back({outline(body, chamber.walls, drawn.positions), color, outline_width});
    }
    for (const ShownTendon& tendon : state.actuators.tendons)
        add_tendon(drawn, tendon, actuator_color(state, theme, actuator++));
}

}  // namespace myo::ui::commands
