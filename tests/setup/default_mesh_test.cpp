#include "setup/default_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mesh/surface_check.hpp"
#include "mesh/test_surfaces.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {
namespace {

mesh::SurfaceMesh box_in_mm(double x, double y, double z) {
    return mesh::box_surface({{0, 0, 0}, {1e-3 * x, 1e-3 * y, 1e-3 * z}});
}

/// An open tube of square section along z, wall 2 mm, 20 x 20 x 100 mm.
mesh::SurfaceMesh square_tube() {
    mesh::SurfaceMesh s;
    s.vertices.resize(3, 16);
    s.triangles.resize(3, 32);
    Eigen::Index v = 0, t = 0;
    for (const double z : {0.0, 0.1})
        for (const double a : {0.0, 0.002})
            for (const auto& [x, y] : {std::pair{a, a}, {0.02 - a, a}, {0.02 - a, 0.02 - a}, {a, 0.02 - a}})
                s.vertices.col(v++) << x, y, z;
    const auto side = [&](int a, int b, int c, int d) {
        s.triangles.col(t++) << a, b, c;
        s.triangles.col(t++) << a, c, d;
    };
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        side(i, j, 8 + j, 8 + i);
        side(4 + j, 4 + i, 12 + i, 12 + j);
        side(j, i, 4 + i, 4 + j);
        side(8 + i, 8 + j, 12 + j, 12 + i);
    }
    return s;
}

BodyMesh meshed(const mesh::SurfaceMesh& surface, const MeshRequest& request = {}) {
    const Result<BodyMesh> mesh = mesh_body(surface, request, {});
    EXPECT_TRUE(mesh) << mesh.error().text();
    return mesh ? *mesh : BodyMesh{};
}

/// Cubes of the old rule, the body's size over six: what labelled experiments were measured with.
mesh::VolumeMesh cubes_of(const mesh::SurfaceMesh& surface) {
    const Box box = mesh::bounding_box(surface.vertices);
    return mesh::hex_mesh(mesh::grid_lines(box, std::cbrt(mesh::enclosed_volume(surface)) / 6.0));
}

TEST(DefaultMesh, OfCompactBodiesIsThatOfOneEdgeLength) {
    for (const mesh::SurfaceMesh& body :
         {box_in_mm(100, 30, 30), box_in_mm(120, 20, 20), box_in_mm(100, 20, 20), box_in_mm(120, 30, 20),
          box_in_mm(120, 26, 26), box_in_mm(30, 100, 30), box_in_mm(40, 40, 10)}) {
        const mesh::VolumeMesh mesh = meshed(body).mesh, cubes = cubes_of(body);
        EXPECT_EQ(mesh.cells, cubes.cells);
        EXPECT_EQ(mesh.nodes, cubes.nodes);
    }
}

/// Unknowns before and after thin parts got their layers; the numbers are what they cost, fixed loosely.
TEST(DefaultMesh, OfThinBodiesGrowsLittle) {
    struct Case {
        std::string name;
        mesh::SurfaceMesh body;
        double before, after;
    };
    for (const Case& one : {Case{"strip 100 x 20 x 4", box_in_mm(100, 20, 4), 1302, 1953},
                            {"strip 100 x 20 x 5", box_in_mm(100, 20, 5), 1218, 1827},
                            {"plate 100 x 50 x 5", box_in_mm(100, 50, 5), 1452, 2178},
                            {"sheet 100 x 100 x 1", box_in_mm(100, 100, 1), 5046, 15129},
                            {"column 5 x 5 x 100", box_in_mm(5, 5, 100), 1215, 1575},
                            {"column 15 x 10 x 120", box_in_mm(15, 10, 120), 1008, 975},
                            {"L-shape", test::l_shape(), 975, 975},
                            {"square tube", square_tube(), 3120, 5616}}) {
        const double edge = std::cbrt(mesh::enclosed_volume(one.body)) / 6.0;
        EXPECT_NEAR(
            3.0 *
                static_cast<double>(meshed(one.body, {fem::ElementKind::hex8, edge * (1.0 + 1e-8)}).mesh.node_count()) /
                one.before,
            1.0, 0.1)
            << one.name;
        EXPECT_NEAR(3.0 * static_cast<double>(meshed(one.body).mesh.node_count()) / one.after, 1.0, 0.1) << one.name;
    }
}

/// Every line across the body meets at least two cells.
TEST(DefaultMesh, HasTwoLayersAcrossEveryWall) {
    for (const mesh::SurfaceMesh& body :
         {box_in_mm(100, 20, 4), box_in_mm(100, 50, 5), box_in_mm(5, 5, 100), test::l_shape(), square_tube()}) {
        const mesh::VolumeMesh mesh = meshed(body).mesh;
        EXPECT_NEAR(mesh::cell_volumes(mesh).sum() / mesh::enclosed_volume(body), 1.0, 1e-12);
        // A cell with both its lowest and its highest face on the boundary would be a single layer.
        const mesh::BoundaryFaces faces = mesh::boundary_faces(mesh);
        Eigen::MatrixXi bare = Eigen::MatrixXi::Zero(3, mesh.cell_count());
        for (Eigen::Index f = 0; f < faces.count(); ++f) {
            const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, faces.nodes.col(f));
            Eigen::Index axis = 0;
            (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).minCoeff(&axis);
            ++bare(axis, faces.cell(f));
        }
        EXPECT_LT(bare.maxCoeff(), 2);
    }
}

TEST(DefaultMesh, IsRefinedInAllDirections) {
    MeshRequest finer;
    finer.refinement = 0.7;
    const mesh::VolumeMesh mesh = meshed(box_in_mm(100, 50, 5), finer).mesh;
    const double edge = 0.7 * automatic_resolution(box_in_mm(100, 50, 5), mesh::CellType::hex8);
    EXPECT_EQ(mesh.cell_count(), static_cast<Eigen::Index>(std::round(0.1 / edge) * std::round(0.05 / edge) * 3.0));
}

/// A number that a person or a file repeats is not taken for a wish of cubes; another one is.
TEST(DefaultMesh, IsMeantByItsOwnEdgeLength) {
    const mesh::SurfaceMesh plate = box_in_mm(100, 50, 5);
    const double edge = automatic_resolution(plate, mesh::CellType::hex8);
    EXPECT_EQ(meshed(plate, {fem::ElementKind::hex8, edge}).mesh.nodes, meshed(plate).mesh.nodes);
    EXPECT_EQ(meshed(plate, {fem::ElementKind::hex8, 1.01 * edge}).mesh.node_count(), 21 * 11 * 2);
}

TEST(LocalThickness, IsThatOfTheWall) {
    EXPECT_NEAR(local_thickness(box_in_mm(100, 50, 5)), 5e-3, 1e-9);
    EXPECT_NEAR(local_thickness(square_tube()), 2e-3, 1e-9);
    EXPECT_NEAR(local_thickness(mesh::weld(test::sphere(3, 0.02))), 0.04, 1e-3);
    EXPECT_LT(automatic_resolution(box_in_mm(100, 50, 5), mesh::CellType::tet10), 8e-3);
    EXPECT_NEAR(automatic_resolution(box_in_mm(100, 30, 30), mesh::CellType::tet10), std::cbrt(9e-5) / 3.0, 1e-12);
    EXPECT_NEAR(automatic_resolution(box_in_mm(100, 5, 5), mesh::CellType::tet10), 0.7 * 5e-3, 1e-12);  // a rod
}

}  // namespace
}  // namespace myo::setup
