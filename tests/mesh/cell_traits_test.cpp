#include "mesh/cell_traits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <Eigen/Dense>

#include "mesh/box_mesh.hpp"

namespace myo::mesh {
namespace {

using Eigen::Vector3d;

/// A few cells of a type, sheared so that no face is aligned.
VolumeMesh some_cells(CellType type) {
    const Box box{{0.0, 0.0, 0.0}, {1.0, 0.7, 0.4}};
    VolumeMesh mesh = cell_traits(type).shape == CellShape::hexahedron ? box_hex_mesh(box, {1, 1, 1})
                                                                       : tet_box_mesh(box, {1, 1, 1}, type);
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    shear(0, 1) = 0.3;
    shear(2, 0) = -0.2;
    mesh.nodes = shear * mesh.nodes;
    return mesh;
}

Vector3d node(const VolumeMesh& mesh, Eigen::Index cell, int i) { return mesh.nodes.col(mesh.cells(i, cell)); }

class CellTraitsOf : public testing::TestWithParam<CellType> {
protected:
    const CellTraits& traits = cell_traits(GetParam());
};

TEST_P(CellTraitsOf, AreFoundByTypeAndName) {
    EXPECT_EQ(traits.type, GetParam());
    EXPECT_EQ(find_cell_type(traits.name), GetParam());
    EXPECT_EQ(to_string(GetParam()), traits.name);
    EXPECT_EQ(nodes_per_cell(GetParam()), traits.nodes);
}

/// The triangles of all faces, outward, enclose the cell's volume, and their areas add up to nothing.
TEST_P(CellTraitsOf, FacesEncloseTheCell) {
    const VolumeMesh mesh = some_cells(GetParam());
    const Eigen::VectorXd volumes = cell_volumes(mesh);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        double volume = 0.0;
        Vector3d area = Vector3d::Zero();
        for (const std::vector<int>& face : traits.faces)
            for (const std::array<int, 3>& t : traits.face_triangles) {
                const auto corner = [&](int i) {
                    return node(mesh, c, face[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]);
                };
                volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
                area += (corner(1) - corner(0)).cross(corner(2) - corner(0));
            }
        EXPECT_NEAR(volume, volumes(c), 1e-14);
        EXPECT_LT(area.norm(), 1e-14);
    }
}

TEST_P(CellTraitsOf, EdgesAreThoseOfTwoFacesEach) {
    std::map<std::set<int>, int> found;
    const auto corners = static_cast<std::size_t>(traits.face_corners);
    for (const std::vector<int>& face : traits.faces)
        for (std::size_t i = 0; i < corners; ++i) ++found[{face[i], face[(i + 1) % corners]}];
    EXPECT_EQ(found.size(), traits.edges.size());
    for (const std::array<int, 2>& edge : traits.edges) EXPECT_EQ((found[{edge[0], edge[1]}]), 2);
    // Euler's formula for the surface of a cell.
    EXPECT_EQ(traits.corners - static_cast<int>(traits.edges.size()) + static_cast<int>(traits.faces.size()), 2);
}

/// Mid-side nodes follow the corners, one per edge, and stand behind the corners of a face in its order.
TEST_P(CellTraitsOf, MidSideNodesAreInTheMiddleOfEdges) {
    const VolumeMesh mesh = some_cells(GetParam());
    for (int i = traits.corners; i < traits.nodes; ++i) {
        const std::array<int, 2> edge = traits.edges[static_cast<std::size_t>(i - traits.corners)];
        EXPECT_LT((node(mesh, 0, i) - 0.5 * (node(mesh, 0, edge[0]) + node(mesh, 0, edge[1]))).norm(), 1e-15);
    }
    const auto corners = static_cast<std::size_t>(traits.face_corners);
    for (const std::vector<int>& face : traits.faces)
        for (std::size_t i = corners; i < face.size(); ++i) {
            const Vector3d middle = 0.5 * (node(mesh, 0, face[i - corners]) +
                                           node(mesh, 0, face[(i - corners + 1) % corners]));
            EXPECT_LT((node(mesh, 0, face[i]) - middle).norm(), 1e-15);
        }
}

TEST_P(CellTraitsOf, MirroredCellsAreInsideOut) {
    VolumeMesh mesh = some_cells(GetParam());
    const Eigen::VectorXd volumes = cell_volumes(mesh);
    const Eigen::MatrixXi own = mesh.cells;
    mesh.cells = own(traits.mirrored, Eigen::all).eval();
    EXPECT_LT((cell_volumes(mesh) + volumes).norm(), 1e-14);
    EXPECT_EQ(Eigen::MatrixXi(mesh.cells(traits.mirrored, Eigen::all)), own) << "twice is none";
}

TEST_P(CellTraitsOf, FileOrdersNameEveryNodeOnce) {
    std::vector<int> order = traits.gmsh_order, all(static_cast<std::size_t>(traits.nodes));
    std::iota(all.begin(), all.end(), 0);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
}

INSTANTIATE_TEST_SUITE_P(All, CellTraitsOf, testing::Values(CellType::hex8, CellType::tet4, CellType::tet10),
                         [](const testing::TestParamInfo<CellType>& cell) { return to_string(cell.param); });

TEST(CellTraits, CodesAreDistinct) {
    std::set<int> vtk, gmsh;
    for (const CellTraits& traits : all_cell_traits()) {
        EXPECT_TRUE(vtk.insert(traits.vtk_type).second);
        EXPECT_TRUE(gmsh.insert(traits.gmsh_type).second);
    }
    EXPECT_FALSE(find_cell_type("hex9"));
}

}  // namespace
}  // namespace myo::mesh
