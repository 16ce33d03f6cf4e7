#include "mesh/volume_mesh.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "mesh/cells.hpp"
#include "mesh/face_table.hpp"

namespace myo::mesh {
namespace {

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
    // Faces in the order of the cells first; what lies beyond follows from the sorted faces.
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
    return with_cell(mesh.type, [&](auto cell) { return volumes_of<decltype(cell)>(mesh); });
}

}  // namespace myo::mesh
