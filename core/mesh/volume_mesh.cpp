#include "mesh/volume_mesh.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include <Eigen/Dense>

#include "mesh/cell_topology.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/face_table.hpp"

namespace myo::mesh {
namespace {

using Vector3 = Eigen::Vector3d;

// Trilinear hexahedron: det J is quadratic in each parameter, so two Gauss points per axis are exact.
double hexahedron_volume(const Eigen::Matrix3Xd& nodes, const Eigen::VectorXi& cell) {
    // Gauss points on [0, 1].
    static const double g = 0.5 / std::sqrt(3.0);
    double volume = 0.0;
    for (int point = 0; point < 8; ++point) {
        const Vector3 xi(0.5 + ((point & 1) ? g : -g), 0.5 + ((point & 2) ? g : -g), 0.5 + ((point & 4) ? g : -g));
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (int i = 0; i < 8; ++i) {
            const auto& corner = hexahedron_corners[static_cast<std::size_t>(i)];
            Vector3 factor, slope;
            for (int a = 0; a < 3; ++a) {
                const bool high = corner[static_cast<std::size_t>(a)] == 1;
                factor[a] = high ? xi[a] : 1.0 - xi[a];
                slope[a] = high ? 1.0 : -1.0;
            }
            const Vector3 gradient(slope[0] * factor[1] * factor[2], factor[0] * slope[1] * factor[2],
                                   factor[0] * factor[1] * slope[2]);
            J += nodes.col(cell[i]) * gradient.transpose();
        }
        volume += J.determinant() / 8.0;
    }
    return volume;
}

double tetrahedron_volume(const Eigen::Matrix3Xd& nodes, const Eigen::VectorXi& cell) {
    Eigen::Matrix3d J;
    for (int i = 0; i < 3; ++i) J.col(i) = nodes.col(cell[i + 1]) - nodes.col(cell[0]);
    return J.determinant() / 6.0;
}

// Quadratic tetrahedron: det J is cubic, integrated exactly by Keast's five points.
double quadratic_tetrahedron_volume(const Eigen::Matrix3Xd& nodes, const Eigen::VectorXi& cell) {
    double volume = 0.0;
    for (int point = 0; point < 5; ++point) {
        Eigen::Vector4d L = Eigen::Vector4d::Constant(point == 0 ? 0.25 : 1.0 / 6.0);
        if (point > 0) L[point - 1] = 0.5;
        // Columns: derivatives with respect to L1, L2, L3, with L0 = 1 - L1 - L2 - L3.
        Eigen::Matrix<double, 3, 4> by_L = Eigen::Matrix<double, 3, 4>::Zero();
        for (int i = 0; i < 4; ++i) by_L.col(i) += (4.0 * L[i] - 1.0) * nodes.col(cell[i]);
        for (int e = 0; e < 6; ++e) {
            const auto [a, b] = tetrahedron_edges[static_cast<std::size_t>(e)];
            by_L.col(a) += 4.0 * L[b] * nodes.col(cell[4 + e]);
            by_L.col(b) += 4.0 * L[a] * nodes.col(cell[4 + e]);
        }
        Eigen::Matrix3d J;
        for (int i = 0; i < 3; ++i) J.col(i) = by_L.col(i + 1) - by_L.col(0);
        // Weights of the five-point rule: -4/5 at the centroid, 9/20 at the others.
        volume += (point == 0 ? -0.8 : 0.45) * J.determinant() / 6.0;
    }
    return volume;
}

/// Face of a cell with its sorted corners as key.
struct FaceKey {
    std::array<int, 4> corners;  // ascending; -1 pads a triangle
    int number;                  // cell * faces per cell + face
};

/// All faces of all cells, sorted such that faces with equal corners are adjacent.
std::vector<FaceKey> sorted_faces(const VolumeMesh& mesh, const CellTraits& traits) {
    assert(mesh.cells.rows() == nodes_per_cell(mesh.type) || mesh.cell_count() == 0);
    const auto face_count = static_cast<int>(traits.faces.size());
    std::vector<FaceKey> keys;
    keys.reserve(static_cast<std::size_t>(mesh.cell_count() * face_count));
    for (int cell = 0; cell < mesh.cell_count(); ++cell) {
        for (int face = 0; face < face_count; ++face) {
            FaceKey key{{-1, -1, -1, -1}, cell * face_count + face};
            const std::vector<int>& nodes = traits.faces[static_cast<std::size_t>(face)];
            for (std::size_t i = 0; i < static_cast<std::size_t>(traits.face_corners); ++i)
                key.corners[i] = mesh.cells(nodes[i], cell);
            std::sort(key.corners.begin(), key.corners.end());
            keys.push_back(key);
        }
    }
    // The face number breaks ties, so that the order is deterministic.
    std::sort(keys.begin(), keys.end(), [](const FaceKey& a, const FaceKey& b) {
        return a.corners != b.corners ? a.corners < b.corners : a.number < b.number;
    });
    return keys;
}

/// Calls visit(first, end) for each run of equal faces.
template <class Visit>
void for_equal_faces(const std::vector<FaceKey>& keys, const Visit& visit) {
    for (std::size_t first = 0; first < keys.size();) {
        std::size_t end = first + 1;
        while (end < keys.size() && keys[end].corners == keys[first].corners) ++end;
        visit(first, end);
        first = end;
    }
}

}  // namespace

FaceTable face_table(const VolumeMesh& mesh) {
    const CellTraits& traits = cell_traits(mesh.type);
    const std::vector<FaceKey> keys = sorted_faces(mesh, traits);
    const auto face_count = static_cast<Eigen::Index>(traits.faces.size());
    FaceTable table;
    table.nodes.resize(traits.face_nodes(), face_count * mesh.cell_count());
    table.cell.resize(table.nodes.cols());
    table.beyond = Eigen::VectorXi::Constant(table.nodes.cols(), -1);
    for (Eigen::Index k = 0; k < table.cell.size(); ++k) {
        table.cell[k] = static_cast<int>(k / face_count);
        const std::vector<int>& nodes = traits.faces[static_cast<std::size_t>(k % face_count)];
        for (std::size_t i = 0; i < nodes.size(); ++i)
            table.nodes(static_cast<Eigen::Index>(i), k) = mesh.cells(nodes[i], table.cell[k]);
    }
    for_equal_faces(keys, [&](std::size_t first, std::size_t end) {
        // A face shared by more than two cells is not free either; any neighbour is recorded.
        for (std::size_t k = first; k < end; ++k)
            if (end > first + 1) table.beyond[keys[k].number] = table.cell[keys[k == first ? first + 1 : first].number];
    });
    return table;
}

BoundaryFaces boundary_of_part(const FaceTable& table, const std::vector<char>& kept) {
    const auto is_kept = [&](int cell) { return cell >= 0 && kept[static_cast<std::size_t>(cell)] != 0; };
    std::vector<Eigen::Index> exposed;
    for (Eigen::Index k = 0; k < table.cell.size(); ++k)
        // A face is on the boundary of the part if the other side is empty or not part of it.
        if (is_kept(table.cell[k]) && !is_kept(table.beyond[k])) exposed.push_back(k);
    return {table.nodes(Eigen::all, exposed), table.cell(exposed)};
}

BoundaryFaces boundary_faces(const VolumeMesh& mesh) {
    return boundary_of_part(face_table(mesh), std::vector<char>(static_cast<std::size_t>(mesh.cell_count()), 1));
}

Eigen::Matrix2Xi neighbouring_cells(const VolumeMesh& mesh) {
    const CellTraits& traits = cell_traits(mesh.type);
    const std::vector<FaceKey> keys = sorted_faces(mesh, traits);
    const auto face_count = static_cast<int>(traits.faces.size());
    std::vector<std::array<int, 2>> pairs;
    for_equal_faces(keys, [&](std::size_t first, std::size_t end) {
        // Faces of more than two cells are not counted: the mesh is not conforming there.
        if (end == first + 2) pairs.push_back({keys[first].number / face_count, keys[first + 1].number / face_count});
    });
    std::sort(pairs.begin(), pairs.end());
    Eigen::Matrix2Xi result(2, static_cast<Eigen::Index>(pairs.size()));
    for (Eigen::Index k = 0; k < result.cols(); ++k)
        result.col(k) << pairs[static_cast<std::size_t>(k)][0], pairs[static_cast<std::size_t>(k)][1];
    return result;
}

Eigen::VectorXd cell_volumes(const VolumeMesh& mesh) {
    assert(mesh.cells.rows() == nodes_per_cell(mesh.type) || mesh.cell_count() == 0);
    Eigen::VectorXd volumes(mesh.cell_count());
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const Eigen::VectorXi cell = mesh.cells.col(c);
        switch (mesh.type) {
            case CellType::hex8: volumes[c] = hexahedron_volume(mesh.nodes, cell); break;
            case CellType::tet4: volumes[c] = tetrahedron_volume(mesh.nodes, cell); break;
            case CellType::tet10: volumes[c] = quadratic_tetrahedron_volume(mesh.nodes, cell); break;
        }
    }
    return volumes;
}

}  // namespace myo::mesh
