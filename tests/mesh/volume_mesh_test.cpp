#include "mesh/volume_mesh.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mesh/boundary_surface.hpp"
#include "mesh/face_shape.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/test_meshes.hpp"

namespace myo::mesh {
namespace {

// Area vector and enclosed volume of a boundary by quadrature on its true (curved) faces.
struct BoundaryIntegrals {
    Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
    double volume = 0.0;
};

BoundaryIntegrals integrate(const VolumeMesh& mesh, const BoundaryFaces& faces) {
    BoundaryIntegrals sum;
    const int nodes = static_cast<int>(faces.nodes.rows());
    // Gauss-Legendre with 4 points per axis; the triangle is a collapsed square.
    const double g[4] = {0.069431844202974, 0.330009478207572, 0.669990521792428, 0.930568155797026};
    const double w[4] = {0.173927422568727, 0.326072577431273, 0.326072577431273, 0.173927422568727};
    for (Eigen::Index f = 0; f < faces.count(); ++f) {
        const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, faces.nodes.col(f));
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                const bool square = nodes == 4;
                const Eigen::Vector2d uv(g[i], square ? g[j] : g[j] * (1.0 - g[i]));
                const double weight = w[i] * w[j] * (square ? 1.0 : 1.0 - g[i]);
                const Eigen::Matrix<double, 3, 2> T = X * face_shape_gradient(nodes, uv);
                const Eigen::Vector3d normal = T.col(0).cross(T.col(1));
                sum.area_vector += weight * normal;
                sum.volume += weight * normal.dot(X * face_shape(nodes, uv)) / 3.0;
            }
        }
    }
    return sum;
}

TEST(BoundarySurface, EnclosesTheCellsOfAllTypes) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const SurfaceMesh surface = boundary_surface(mesh);
        const SurfaceReport report = check_surface(surface);
        EXPECT_TRUE(report.meshable()) << to_string(mesh.type);
        EXPECT_TRUE(report.outward) << to_string(mesh.type);
        EXPECT_NEAR(enclosed_volume(surface), cell_volumes(mesh).sum(), 1e-12) << to_string(mesh.type);
        EXPECT_LT(surface.vertices.cols(), mesh.node_count()) << "nodes inside are no part of it";
    }
}

TEST(BoundaryFaces, AreClosedAndOutwardOnAllTypes) {
    for (const VolumeMesh& straight : test::one_of_each()) {
        for (const VolumeMesh& mesh : {straight, test::rotated(straight), test::bent(straight, 8.0)}) {
            const BoundaryFaces faces = boundary_faces(mesh);
            const BoundaryIntegrals integrals = integrate(mesh, faces);
            const double volume = cell_volumes(mesh).sum();
            EXPECT_LT(integrals.area_vector.norm(), 1e-15) << to_string(mesh.type);
            EXPECT_NEAR(integrals.volume, volume, 1e-12 * volume) << to_string(mesh.type);
        }
    }
}

TEST(BoundaryFaces, CountAndOrder) {
    const BoundaryFaces hex = boundary_faces(box_hex_mesh(test::unequal_box(), {3, 2, 2}));
    EXPECT_EQ(hex.count(), 2 * (3 * 2 + 3 * 2 + 2 * 2));
    const BoundaryFaces tet = boundary_faces(tet_box_mesh(test::unequal_box(), {3, 2, 2}));
    EXPECT_EQ(tet.count(), 2 * hex.count());
    for (Eigen::Index f = 1; f < hex.count(); ++f) EXPECT_LE(hex.cell[f - 1], hex.cell[f]);
}

TEST(BoundaryFaces, MidNodesLieBetweenTheirCorners) {
    const VolumeMesh mesh = tet_box_mesh(test::unequal_box(), {2, 1, 2}, CellType::tet10);
    const BoundaryFaces faces = boundary_faces(mesh);
    ASSERT_EQ(faces.nodes.rows(), 6);
    for (Eigen::Index f = 0; f < faces.count(); ++f) {
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d middle = 0.5 * (mesh.nodes.col(faces.nodes(i, f)) +
                                                  mesh.nodes.col(faces.nodes((i + 1) % 3, f)));
            EXPECT_LT((mesh.nodes.col(faces.nodes(3 + i, f)) - middle).norm(), 1e-16);
        }
    }
}

/// Mirrored cells match, and the mesh is its own mirror image in the three planes through the middle of the box.
TEST(TetBoxMesh, OfMirroredCellsIsAsSymmetricAsTheBox) {
    const Box box = test::unequal_box();
    const VolumeMesh mesh = tet_box_mesh(box, {4, 2, 2}, CellType::tet4, Diagonals::mirrored);
    EXPECT_EQ(2 * neighbouring_cells(mesh).cols() + boundary_faces(mesh).count(), 4 * mesh.cell_count());
    const Eigen::Vector3d middle = 0.5 * (box.lowest + box.highest);
    const auto cells_as_places = [&](const Eigen::MatrixXd& nodes) {
        std::set<std::set<int>> cells;
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
            std::set<int> corners;
            for (const int n : mesh.cells.col(c)) {
                Eigen::Index place = 0;
                (mesh.nodes.colwise() - nodes.col(n)).colwise().norm().minCoeff(&place);
                corners.insert(static_cast<int>(place));
            }
            cells.insert(corners);
        }
        return cells;
    };
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::MatrixXd mirrored = mesh.nodes;
        mirrored.row(axis) = 2.0 * middle(axis) - mirrored.row(axis).array();
        EXPECT_EQ(cells_as_places(mirrored), cells_as_places(mesh.nodes)) << axis;
    }
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        Eigen::Matrix3d edges;
        for (int e = 0; e < 3; ++e)
            edges.col(e) = mesh.nodes.col(mesh.cells(e + 1, c)) - mesh.nodes.col(mesh.cells(0, c));
        EXPECT_GT(edges.determinant(), 0.0);
    }
}

/// Every face is either on the boundary or between two cells.
TEST(NeighbouringCells, ShareTheFacesThatAreNotOnTheBoundary) {
    for (const CellType type : {CellType::hex8, CellType::tet4, CellType::tet10}) {
        const VolumeMesh mesh = type == CellType::hex8 ? box_hex_mesh(test::unequal_box(), {4, 3, 2})
                                                       : tet_box_mesh(test::unequal_box(), {4, 3, 2}, type);
        const Eigen::Matrix2Xi pairs = neighbouring_cells(mesh);
        const Eigen::Index faces = type == CellType::hex8 ? 6 : 4;
        EXPECT_EQ(2 * pairs.cols() + boundary_faces(mesh).count(), faces * mesh.cell_count());
        for (Eigen::Index k = 0; k < pairs.cols(); ++k) {
            ASSERT_LT(pairs(0, k), pairs(1, k));
            int shared = 0;
            for (const int n : mesh.cells.col(pairs(0, k)))
                shared += static_cast<int>((mesh.cells.col(pairs(1, k)).array() == n).count());
            ASSERT_EQ(shared, type == CellType::hex8 ? 4 : type == CellType::tet4 ? 3 : 6);
        }
    }
}

TEST(CellVolumes, FillTheBoxAndArePositive) {
    const double volume = test::unequal_box().size().prod();
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const Eigen::VectorXd volumes = cell_volumes(mesh);
        EXPECT_GT(volumes.minCoeff(), 0.0);
        EXPECT_NEAR(volumes.sum(), volume, 1e-13 * volume);
    }
}

TEST(CellVolumes, TrilinearCellAgreesWithTheClosedForm) {
    // x = xi, y = eta, z = zeta (1 + xi eta): volume = integral of 1 + xi eta = 1.25
    VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {1, 1, 1}}, {1, 1, 1});
    for (Eigen::Index i = 0; i < 8; ++i) mesh.nodes(2, i) *= 1.0 + mesh.nodes(0, i) * mesh.nodes(1, i);
    EXPECT_NEAR(cell_volumes(mesh)[0], 1.25, 1e-14);
}

TEST(BoxMesh, MeetsTheBoxExactlyAndRoundsTheCounts) {
    const Box box{{0, 0, 0}, {0.1, 0.03, 0.03}};
    EXPECT_EQ(box_cells(box, 0.004), Eigen::Vector3i(25, 8, 8));
    EXPECT_EQ(box_cells(box, 1.0), Eigen::Vector3i(1, 1, 1));
    const VolumeMesh mesh = box_hex_mesh(box, {23, 7, 7});
    EXPECT_EQ(bounding_box(mesh.nodes).highest, box.highest);
    EXPECT_EQ(mesh.node_count(), 24 * 8 * 8);
}

TEST(BoxMesh, GridPlanesAreMet) {
    const Box box{{0, 0, 0}, {0.1, 0.03, 0.03}};
    const GridLines grid = grid_lines(box, 0.01, {{{5e-4, -1.0, 0.1}, {0.015}, {}}});
    EXPECT_EQ(grid.axis[0][1], 5e-4);
    EXPECT_EQ(grid.axis[0].back(), 0.1);
    EXPECT_EQ(grid.axis[0].size(), 12u);
    EXPECT_EQ(std::count(grid.axis[1].begin(), grid.axis[1].end(), 0.015), 1);
    EXPECT_NEAR(cell_volumes(hex_mesh(grid)).sum(), 9e-5, 1e-18);
}

TEST(BoxMesh, RefusesGridsThatWouldFillTheMemory) {
    const Box box{{0, 0, 0}, {0.1, 0.03, 0.03}};
    EXPECT_TRUE(limited_grid_lines(box, 1e-3));
    for (const double edge : {1e-4, 1e-9, 1e-300}) {
        const auto grid = limited_grid_lines(box, edge);
        ASSERT_FALSE(grid) << edge;
        EXPECT_NE(grid.error().what.find("over the limit of"), std::string::npos);
    }
    // The planes alone make 6 x 5 x 4 cells.
    EXPECT_TRUE(limited_grid_lines(
        box, 1.0, {{{0.01, 0.02, 0.03, 0.04, 0.05}, {0.01, 0.015, 0.02, 0.025}, {0.01, 0.015, 0.02}}}, 120.0));
    EXPECT_FALSE(limited_grid_lines(
        box, 1.0, {{{0.01, 0.02, 0.03, 0.04, 0.05}, {0.01, 0.015, 0.02, 0.025}, {0.01, 0.015, 0.02}}}, 119.0));
}

TEST(BoxMesh, RecognisesBoxesOnly) {
    const Box box = test::unequal_box();
    const auto found = is_box(box_surface(box));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->lowest, box.lowest);
    EXPECT_NEAR(enclosed_volume(box_surface(box)), box.size().prod(), 1e-18);

    SurfaceMesh inward = box_surface(box);
    inward.triangles.row(1).swap(inward.triangles.row(2));
    EXPECT_FALSE(is_box(inward));
    SurfaceMesh wedge = box_surface(box);
    wedge.vertices.col(6) = wedge.vertices.col(5);  // an edge pulled in: still on the faces, less volume
    EXPECT_FALSE(is_box(wedge));
}

TEST(ToTet10, IsDeterministicAndConforming) {
    const VolumeMesh linear = tet_box_mesh(test::unequal_box(), {2, 2, 2});
    const VolumeMesh quadratic = to_tet10(linear);
    // Euler's formula for a ball cut into tetrahedra gives the number of edges.
    const Eigen::Index boundary = boundary_faces(linear).count();
    const Eigen::Index faces = (4 * linear.cell_count() + boundary) / 2;
    const Eigen::Index edges = linear.node_count() + faces - linear.cell_count() - 1;
    EXPECT_EQ(quadratic.node_count(), linear.node_count() + edges);
    EXPECT_EQ(to_tet10(linear).cells, quadratic.cells);
    EXPECT_EQ(to_tet10(quadratic).cells, quadratic.cells);
}

}  // namespace
}  // namespace myo::mesh
