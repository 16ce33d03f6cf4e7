#include "commands/muscle_drawing.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace myo::ui::commands {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr float strongest_tint = 0.8f;    // opacity of the muscle colour on a face with full weight
constexpr double fibre_length = 0.7;      // share of the distance between cells
constexpr double lift = 0.04;             // share of the same distance, above the face
constexpr std::size_t max_fibres = 4000;  // per muscle; with more, every n-th one is drawn
constexpr float dark_fibre = 0.35f;       // brightness of fibres that lie on their own colour

/// Positions of the nodes of one cell or face: one column of `nodes`.
Matrix3Xd nodes_of(const Matrix3Xd& positions, const Eigen::MatrixXi& nodes, Index column) {
    return positions(Eigen::all, nodes.col(column));
}

/// Deformation gradient of a cell, by least squares over its nodes. Sufficient for drawing a direction.
Matrix3d deformation(const Matrix3Xd& rest, const Matrix3Xd& now) {
    const Matrix3Xd X = rest.colwise() - rest.rowwise().mean(), x = now.colwise() - now.rowwise().mean();
    return x * X.transpose() * (X * X.transpose()).inverse();
}

/// Appends a line through `middle` with the half vector `half`, followed by a gap.
void append(std::vector<Vector3d>& points, const Vector3d& middle, const Vector3d& half) {
    points.push_back(middle - half);
    points.push_back(middle + half);
    points.push_back(Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

/// All fibres of one colour as a single polyline with gaps.
viewport::DrawnLine lines_of(const std::vector<Vector3d>& points, const Eigen::Vector3f& color, double width) {
    viewport::DrawnLine line;
    line.points = Eigen::Map<const Matrix3Xd>(points.empty() ? nullptr : points.front().data(), 3,
                                              static_cast<Index>(points.size()));
    line.color << color, 1.0f;
    line.width = width;
    return line;
}

/// Painted cells of the drawn body: faces at its surface, and cells inside it.
struct PaintedCells {
    std::vector<Index> faces, inside;
};

/// Sorts the cells that a muscle's paint gives a weight. Cells that the clip plane removes are left out.
PaintedCells painted_cells(const viewport::DrawnScene& drawn, const mesh::VolumeMesh& mesh,
                           const fibre::CellPaint& paint) {
    const mesh::BoundaryFaces& boundary = drawn.body->faces;
    std::vector<bool> at_surface(static_cast<std::size_t>(mesh.cell_count()), false);
    PaintedCells painted;
    for (Index f = 0; f < boundary.count(); ++f) {
        if (!(paint.weights(boundary.cell(f)) > 0.0)) continue;
        at_surface[static_cast<std::size_t>(boundary.cell(f))] = true;
        painted.faces.push_back(f);
    }
    for (Index c = 0; c < mesh.cell_count(); ++c)
        if (paint.weights(c) > 0.0 && drawn.body->has(c) && !at_surface[static_cast<std::size_t>(c)])
            painted.inside.push_back(c);
    return painted;
}

/// Adds the fibres of one muscle. Cells with a face on the surface show their fibre on it, all others inside.
void add_fibres(viewport::DrawnScene& drawn, const MeshedBody& body, const fibre::CellPaint& paint, double spacing_m,
                const Eigen::Vector3f& color, double width) {
    const mesh::BoundaryFaces& boundary = drawn.body->faces;
    const mesh::VolumeMesh& mesh = body.mesh;
    const auto [faces, inside] = painted_cells(drawn, mesh, paint);
    // Stride over both lists together, so that the density is the same on the surface and inside.
    const std::size_t stride = std::max<std::size_t>(1, (faces.size() + inside.size() + max_fibres - 1) / max_fibres);
    const double half = 0.5 * fibre_length * spacing_m;
    std::vector<Vector3d> on_surface, within;
    for (std::size_t i = 0; i < faces.size(); i += stride) {
        const Index cell = boundary.cell(faces[i]);
        const Matrix3Xd corners = nodes_of(drawn.positions, boundary.nodes, faces[i]);
        const Vector3d normal = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).normalized();
        // The direction at rest moves with the material: F d.
        Vector3d along = deformation(nodes_of(mesh.nodes, mesh.cells, cell),
                                     nodes_of(drawn.positions, mesh.cells, cell)) *
                         paint.directions.col(cell);
        // On the surface only the tangential part is drawn; a fibre that points inwards would vanish in the body.
        along -= along.dot(normal) * normal;
        append(on_surface, corners.rowwise().mean() + lift * spacing_m * normal, half * along);
    }
    for (std::size_t i = 0; i < inside.size(); i += stride) {
        const Matrix3Xd now = nodes_of(drawn.positions, mesh.cells, inside[i]);
        append(within, now.rowwise().mean(),
               half * deformation(nodes_of(mesh.nodes, mesh.cells, inside[i]), now) * paint.directions.col(inside[i]));
    }
    // Fibres inside have the muscle's colour. On a face that is tinted in the same colour they would vanish, so they
    // are darker.
    if (!within.empty()) drawn.lines.push_back(lines_of(within, color, width));
    if (!on_surface.empty()) drawn.lines.push_back(lines_of(on_surface, dark_fibre * color, width));
}

}  // namespace

void add_muscles(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
                 const fibre::CellPaint* live) {
    // Paint of another mesh, or for another list of muscles, cannot be drawn.
    if (!state.view.fibres || !state.body || !drawn.body || drawn.body->faces.count() == 0 || !state.ground ||
        state.paint.size() != state.settings.muscles.size())
        return;
    // Faces of the drawn body, which the clip plane may have cut: tints belong to them.
    const mesh::BoundaryFaces& boundary = drawn.body->faces;
    Eigen::Matrix4Xf sums = Eigen::Matrix4Xf::Zero(4, boundary.count());
    for (std::size_t m = 0; m < state.paint.size(); ++m) {
        const bool chosen = static_cast<int>(m) == state.muscle;
        const fibre::CellPaint& paint = chosen && live ? *live : *state.paint[m];
        if (paint.count() != state.body->mesh.cell_count() || !(paint.weights.maxCoeff() > 0.0)) continue;
        const Eigen::Vector3f color = viewport::color_of(theme.muscle(state.settings.muscles[m].color)).head<3>();
        for (Index f = 0; f < boundary.count(); ++f) {
            // Overlapping muscles mix their colours by weight; the fourth row collects the total weight.
            const auto weight = static_cast<float>(paint.weights(boundary.cell(f)));
            sums.col(f) += weight * color.homogeneous();
        }
        add_fibres(drawn, *state.body, paint, state.ground->places.edge_m, color, chosen ? 2.2 : 1.4);
    }
    if (!(sums.row(3).maxCoeff() > 0.0f)) return;
    // From weighted sums to a mean colour and an opacity.
    for (auto tint : sums.colwise()) {
        if (tint(3) > 0.0f) tint.head<3>() /= tint(3);
        tint(3) = strongest_tint * std::min(1.0f, tint(3));
    }
    drawn.tints = std::move(sums);
}

}  // namespace myo::ui::commands
