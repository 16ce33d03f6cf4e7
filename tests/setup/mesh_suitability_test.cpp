#include "setup/mesh_suitability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/quality.hpp"
#include "mesh/test_surfaces.hpp"

namespace myo::setup {
namespace {

using testing::HasSubstr;

struct Checked {
    mesh::SurfaceMesh surface;
    BodyMesh mesh;
    std::vector<effect::EffectDeclaration> effects;

    MeshFacts facts() const { return {surface, mesh, effects}; }
};

Checked checked(const mesh::SurfaceMesh& surface, const MeshRequest& request, const std::vector<Box>& regions = {}) {
    Result<BodyMesh> mesh = mesh_body(surface, request, regions);
    EXPECT_TRUE(mesh);
    return {surface, mesh ? *mesh : BodyMesh{}, {}};
}

const mesh::SurfaceMesh thin_plate = mesh::box_surface({{0, 0, 0}, {0.1, 0.05, 0.005}}),
                        square_bar = mesh::box_surface({{0, 0, 0}, {0.1, 0.02, 0.02}});

TEST(Suitability, SaysNothingOfDefaultMeshes) {
    const mesh::SurfaceMesh column = mesh::box_surface({{0, 0, 0}, {0.005, 0.005, 0.1}});
    for (const mesh::SurfaceMesh& body : {thin_plate, square_bar, column, test::l_shape()})
        for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10})
            EXPECT_THAT(unsuitable(checked(body, {element, {}}).facts()), testing::IsEmpty()) << to_string(element);
}

TEST(Suitability, TellsOfOneLayer) {
    const Checked one = checked(thin_plate, {fem::ElementKind::hex8, 0.005});
    ASSERT_TRUE(too_few_layers(one.facts()));
    EXPECT_THAT(*too_few_layers(one.facts()), HasSubstr("1 layer of hexahedra across 5 mm along z, fewer than 2"));
    EXPECT_THAT(*too_few_layers(one.facts()),
                HasSubstr("choose edges of 0.0025 m or less (--resolution, or Edge length of Mesh in the window)"));
    EXPECT_FALSE(too_few_layers(checked(thin_plate, {fem::ElementKind::hex8, 0.0025}).facts()));
    // Voxels of a slanted plate have no layers to count: the edge is compared with the thickness.
    mesh::SurfaceMesh slanted = thin_plate;
    slanted.vertices.row(0) += 0.2 * slanted.vertices.row(2);
    EXPECT_TRUE(too_few_layers(checked(slanted, {fem::ElementKind::hex8, 0.005}).facts()));
    EXPECT_FALSE(too_few_layers(checked(slanted, {fem::ElementKind::hex8, 0.00245}).facts()));
}

TEST(WallLayers, AreCountedInHexahedraAndEstimatedElsewhere) {
    const WallLayers plate = wall_layers(checked(thin_plate, {fem::ElementKind::hex8, 0.0025}).facts());
    EXPECT_EQ(plate.count, 2.0);
    EXPECT_DOUBLE_EQ(plate.thickness_m, 0.005);
    const Checked cube = checked(mesh::box_surface({{0, 0, 0}, {0.03, 0.03, 0.03}}), {fem::ElementKind::hex8, 0.01});
    EXPECT_NEAR(wall_layers(cube.facts()).count, 3.0, 1e-6);
    const Checked tetrahedra = checked(thin_plate, {fem::ElementKind::tet10, 0.005});
    const WallLayers about = wall_layers(tetrahedra.facts());
    EXPECT_NEAR(about.thickness_m, 0.005, 1e-6);
    EXPECT_NEAR(about.count, 0.005 / mesh::mean_edge_length(tetrahedra.mesh.mesh), 1e-6);
}

TEST(Suitability, TellsOfRodsThatTwistTooLittle) {
    const Checked coarse = checked(square_bar, {fem::ElementKind::hex8, 0.01});
    ASSERT_TRUE(too_few_cells_to_twist(coarse.facts()));
    EXPECT_THAT(*too_few_cells_to_twist(coarse.facts()), HasSubstr("2 layers of hexahedra across 20 mm"));
    EXPECT_THAT(*too_few_cells_to_twist(coarse.facts()), HasSubstr("torsion may be off by 15 %"));
    EXPECT_FALSE(too_few_cells_to_twist(checked(square_bar, {fem::ElementKind::hex8, 0.0066}).facts()));
    EXPECT_FALSE(too_few_cells_to_twist(checked(thin_plate, {fem::ElementKind::hex8, 0.0025}).facts()));
    const Checked tetrahedra = checked(square_bar, {fem::ElementKind::tet10, 0.03});
    ASSERT_TRUE(too_few_cells_to_twist(tetrahedra.facts()));
    EXPECT_THAT(*too_few_cells_to_twist(tetrahedra.facts()),
                HasSubstr("one layer of tetrahedra across a rod of 20 mm"));
    EXPECT_FALSE(too_few_cells_to_twist(checked(thin_plate, {fem::ElementKind::tet10, 0.01}).facts()));
}

TEST(Suitability, TellsOfFlatCells) {
    const mesh::SurfaceMesh sheet = mesh::box_surface({{0, 0, 0}, {0.1, 0.1, 0.0005}});
    ASSERT_TRUE(cells_too_flat(checked(sheet, {fem::ElementKind::hex8, 0.006}).facts()));
    EXPECT_THAT(*cells_too_flat(checked(sheet, {fem::ElementKind::hex8, 0.006}).facts()),
                HasSubstr("longer than 10 times their height, up to 11.8 times"));
    EXPECT_FALSE(cells_too_flat(checked(thin_plate, {fem::ElementKind::hex8, 0.005}).facts()));
}

TEST(Suitability, TellsOfAPatchBelowTheEdgeLength) {
    Checked body = checked(square_bar, {});
    body.effects = {{"soft_patch",
                     {{"relative_change", -0.3},
                      {"centre_m", Eigen::VectorXd(Eigen::Vector3d(0.05, 0.01, 0.01))},
                      {"radius_m", 0.002}}}};
    ASSERT_TRUE(effect_too_small(body.facts()));
    EXPECT_THAT(*effect_too_small(body.facts()),
                HasSubstr("effect soft_patch: its radius of 2 mm is below the mesh's edge length of "));
    body.effects[0].parameters["radius_m"] = 0.01;
    EXPECT_FALSE(effect_too_small(body.facts()));
}

TEST(Suitability, TellsOfVolumeThatVoxelsMiss) {
    const Checked ball = checked(test::cylinder(24, 0.015, 0.06), {fem::ElementKind::hex8, 0.005});
    EXPECT_THAT(testing::PrintToString(ball.mesh.warnings),
                HasSubstr("more than 1 %: choose shorter edges or tetrahedra"));
}

}  // namespace
}  // namespace myo::setup
