#include "fem/cell_sides.hpp"

#include <Eigen/Geometry>

#include <algorithm>

#include "mesh/face_table.hpp"

namespace myo::fem {
namespace {

struct CellSidesPolicy {
    double most = -0.5;  // cosine: opposite sides of a wall, not the faces at an edge of a box
};
constexpr CellSidesPolicy cell_sides_policy;

/// A side counts as held if all its nodes are clamped, otherwise as open if no cell is behind it.
CellSurroundings around_hexahedra(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped) {
    const mesh::FaceTable faces = mesh::face_table(mesh);
    CellSurroundings result(static_cast<std::size_t>(mesh.cell_count()));
    for (std::size_t c = 0; c < result.size(); ++c) {
        std::array<int, 3> held{}, open{};  // sides
        for (std::size_t k = 0; k < 3; ++k)
            for (const std::size_t side : {0u, 1u}) {  // faces of a cell are listed x-, x+, y-, ...
                const auto face = static_cast<Eigen::Index>(6 * c + 2 * k + side);
                const auto nodes = faces.nodes.col(face);
                if (std::all_of(nodes.begin(), nodes.end(),
                                [&](int node) { return clamped[static_cast<std::size_t>(node)]; }))
                    ++held[k];
                else if (faces.beyond(face) < 0)
                    ++open[k];
            }
        const bool at_clamp = held[0] + held[1] + held[2] > 0;
        for (std::size_t k = 0; k < 3; ++k)
            result[c][k] = held[k] > 0                                  ? CellSides::clamped
                           : open[k] == 0 || (at_clamp && open[k] == 1) ? CellSides::inner
                                                                        : CellSides::free;
    }
    return result;
}

/// Unit normals of free surface faces, collected per node.
using Normals = std::vector<Eigen::Vector3d>;

bool opposite(const Normals& normals) {
    for (std::size_t i = 0; i < normals.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (normals[i].dot(normals[j]) < cell_sides_policy.most) return true;
    return false;
}

/// True for nodes that see two opposite sides of the body. Surface nodes see the sides they lie on; interior nodes see
/// those of their neighbours. Cells with such corners are one or two across the thickness.
std::vector<bool> see_both_sides(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped,
                                 const std::vector<Normals>& on) {
    std::vector<Normals> seen = on;
    std::vector<bool> outside(on.size());
    const mesh::BoundaryFaces faces = mesh::boundary_faces(mesh);
    for (const int node : faces.nodes.reshaped()) outside[static_cast<std::size_t>(node)] = true;
    for (const auto& cell : mesh.cells.colwise())
        for (int a = 0; a < 4; ++a) {
            const auto node = static_cast<std::size_t>(cell(a));
            if (outside[node] || clamped[node]) continue;
            for (int b = 0; b < 4; ++b)
                for (const Eigen::Vector3d& n : on[static_cast<std::size_t>(cell(b))]) {
                    // One entry per direction instead of one per face.
                    const bool known = std::any_of(seen[node].begin(), seen[node].end(),
                                                   [&](const Eigen::Vector3d& m) { return m.dot(n) > 0.9; });
                    if (!known) seen[node].push_back(n);
                }
        }
    std::vector<bool> result;
    for (const Normals& normals : seen) result.push_back(opposite(normals));
    return result;
}

/// Distinct normals of the free faces at each node; clamped faces are skipped.
std::vector<Normals> normals_at_nodes(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped) {
    std::vector<Normals> normals(clamped.size());
    const mesh::BoundaryFaces faces = mesh::boundary_faces(mesh);
    for (const auto& face : faces.nodes.colwise()) {
        const auto corners = face.head<3>();
        if (std::all_of(corners.begin(), corners.end(),
                        [&](int node) { return clamped[static_cast<std::size_t>(node)]; }))
            continue;
        const auto X = [&](int k) { return Eigen::Vector3d(mesh.nodes.col(corners(k))); };
        const Eigen::Vector3d n = (X(1) - X(0)).cross(X(2) - X(0)).normalized();
        for (const int node : corners) {
            Normals& list = normals[static_cast<std::size_t>(node)];
            if (std::none_of(list.begin(), list.end(), [&](const Eigen::Vector3d& m) { return m.dot(n) > 0.9; }))
                list.push_back(n);
        }
    }
    return normals;
}

/// Classification of tetrahedra: thin ones are free, others clamped or inner.
CellSurroundings around_tetrahedra(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped) {
    const std::vector<Normals> on = normals_at_nodes(mesh, clamped);
    const std::vector<bool> both = see_both_sides(mesh, clamped, on);
    CellSurroundings result;
    for (const auto& cell : mesh.cells.colwise()) {
        Normals of_cell;
        bool thin = false, held = false;
        for (const int node : cell.head<4>()) {
            const auto n = static_cast<std::size_t>(node);
            of_cell.insert(of_cell.end(), on[n].begin(), on[n].end());
            thin = thin || both[n];
            held = held || clamped[n];
        }
        const CellSides sides = thin || opposite(of_cell) ? CellSides::free
                                : held                    ? CellSides::clamped
                                                          : CellSides::inner;
        result.push_back({sides, sides, sides});
    }
    return result;
}

}  // namespace

CellSurroundings cell_surroundings(const mesh::VolumeMesh& mesh, const std::vector<bool>& clamped) {
    return mesh.type == mesh::CellType::hex8 ? around_hexahedra(mesh, clamped) : around_tetrahedra(mesh, clamped);
}

}  // namespace myo::fem
