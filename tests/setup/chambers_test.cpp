#include "setup/chambers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/statics.hpp"
#include "material/catalogue.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/test_surfaces.hpp"
#include "model/cavity_pressure.hpp"
#include "model/elastic_bed.hpp"
#include "model/loaded_face.hpp"
#include "setup/mesh_suitability.hpp"
#include "support/figures.hpp"

namespace myo::setup {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using testing::HasSubstr;

mesh::SurfaceMesh inward(mesh::SurfaceMesh surface) {
    surface.triangles.row(1).swap(surface.triangles.row(2));
    return surface;
}

mesh::SurfaceMesh placed(mesh::SurfaceMesh surface, const Vector3d& by) {
    surface.vertices.colwise() += by;
    return surface;
}

/// A block of 60 x 30 x 20 mm with a chamber of 40 x 8 x 8 mm and one of 40 x 4 x 8 mm.
mesh::SurfaceMesh block_with_chambers() {
    const mesh::SurfaceMesh wide = inward(mesh::box_surface({{0.01, 0.004, 0.006}, {0.05, 0.012, 0.014}}));
    const mesh::SurfaceMesh narrow = inward(mesh::box_surface({{0.01, 0.020, 0.006}, {0.05, 0.024, 0.014}}));
    return test::together(mesh::box_surface({{0, 0, 0}, {0.06, 0.03, 0.02}}), test::together(wide, narrow));
}

const Vector3d in_wide(0.03, 0.008, 0.010), in_narrow(0.03, 0.022, 0.010);

Result<std::vector<Chamber>> chambers_at(const std::vector<Vector3d>& points, const MeshRequest& request) {
    const mesh::SurfaceMesh surface = block_with_chambers();
    experiment::Experiment experiment;
    for (std::size_t i = 0; i < points.size(); ++i) experiment.chambers.push_back({"c" + std::to_string(i), points[i]});
    const Result<BodyMesh> mesh = mesh_body(surface, request, {});
    if (!mesh) return mesh.error();
    return find_chambers(experiment, surface, *mesh, *model::make_body(mesh->mesh, mesh->element, {}));
}

TEST(Chambers, AreFoundByAnyPointOfTheirCavity) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        const Result<std::vector<Chamber>> chambers = chambers_at({in_narrow, in_wide + Vector3d(0.019, 0.003, 0.0)},
                                                                  {kind, {}});
        ASSERT_TRUE(chambers) << chambers.error().text();
        ASSERT_EQ(chambers->size(), 2u);
        EXPECT_NEAR((*chambers)[0].volume_m3, 1.28e-6, 1e-15);
        EXPECT_NEAR((*chambers)[1].volume_m3, 2.56e-6, 1e-15);
        EXPECT_NEAR((*chambers)[1].wall_area_m2, 2 * 64e-6 + 4 * 320e-6, 1e-12);
        EXPECT_EQ((*chambers)[1].volume_factor, 1.0) << "walls that the mesh meets are not corrected";
    }
}

TEST(Chambers, RefusePointsThatAreInNoCavityOfTheirOwn) {
    const auto sentence = [](const std::vector<Vector3d>& points) {
        const Result<std::vector<Chamber>> chambers = chambers_at(points, {fem::ElementKind::hex8, {}});
        return chambers ? std::string("none") : chambers.error().what;
    };
    EXPECT_THAT(sentence({in_wide, Vector3d(0.005, 0.015, 0.01)}),
                testing::AllOf(HasSubstr("chamber[1].inside_m"), HasSubstr("in the material")));
    EXPECT_THAT(sentence({Vector3d(0.03, 0.04, 0.01)}), HasSubstr("outside the body"));
    EXPECT_THAT(sentence({in_wide, in_narrow, in_wide + Vector3d(0.01, 0.0, 0.0)}),
                testing::AllOf(HasSubstr("chamber[2]"), HasSubstr("the cavity of chamber c0")));
}

/// A block that no grid plane meets: coarse voxels fill the narrow chamber; the edge length of the message keeps it.
TEST(Chambers, LostByCoarseVoxelsNameAResolutionThatKeepsThem) {
    mesh::SurfaceMesh slanted = block_with_chambers();
    slanted.vertices.row(0) += 0.1 * slanted.vertices.row(2);
    experiment::Experiment experiment;
    experiment.chambers = {{"narrow", in_narrow + Vector3d(0.001, 0.0, 0.0)}};
    const auto found = [&](double edge) {
        const Result<BodyMesh> mesh = mesh_body(slanted, {fem::ElementKind::hex8, edge}, {});
        EXPECT_TRUE(mesh);
        return find_chambers(experiment, slanted, *mesh, *model::make_body(mesh->mesh, mesh->element, {}));
    };
    const Result<std::vector<Chamber>> lost = found(0.008);
    ASSERT_FALSE(lost);
    const std::string& what = lost.error().what;
    EXPECT_THAT(what, HasSubstr("has lost the closed cavity"));
    const std::size_t at = what.find("choose edges of ");
    ASSERT_NE(at, std::string::npos) << what;
    EXPECT_TRUE(found(std::stod(what.substr(at + 16)))) << what;
}

/// A free body under a pressure inside, at rest on a bed that is too soft to matter.
struct Inflated {
    MeshRequest request;
    double volume_change_m3 = 0.0;  // of the declared cavity, as the walls of the mesh show it
    double factor = 1.0;
    double outer_radius_change = 0.0;
};

Inflated inflated(const mesh::SurfaceMesh& surface, const Vector3d& inside, const MeshRequest& request, double E,
                  double nu, double pressure_Pa) {
    experiment::Experiment experiment;
    experiment.chambers = {{"c", inside}};
    const Result<BodyMesh> mesh = mesh_body(surface, request, {});
    EXPECT_TRUE(mesh) << mesh.error().text();
    model::Model model;
    model.body = model::make_body(mesh->mesh, mesh->element, {});
    const model::Body& body = *model.body;
    model.material = material::find_material("neo_hookean");
    model.density_kg_m3 = 1070.0;
    model.moduli = model::uniform_moduli(body.cell_count(), E, nu);
    const Result<std::vector<Chamber>> chambers = find_chambers(experiment, surface, *mesh, body);
    EXPECT_TRUE(chambers) << chambers.error().text();
    const Chamber& chamber = chambers->front();
    std::vector<int> outer;
    for (int f = 0; f < static_cast<int>(body.boundary.count()); ++f)
        if (std::find(chamber.walls.begin(), chamber.walls.end(), f) == chamber.walls.end()) outer.push_back(f);
    model.force_elements = {chamber_pressure(body, chamber, fibre::Signal::constant(pressure_Pa)),
                            model::elastic_bed(body, outer, 1.0)};
    dynamics::StageSolver solver(model);
    Matrix3Xd x = body.mesh.nodes;
    EXPECT_TRUE(dynamics::solve_equilibrium(solver, 0.0, x).ok());
    Inflated result{request, chamber_volume(body, chamber, x) - chamber.volume_m3, chamber.volume_factor};
    return result;
}

/// Thick sphere after Lame: the cavity grows by 4 pi a^2 u(a), u(a) = p a / E ((1 - 2 nu) a^3 + (1 + nu) b^3 / 2) /
/// (b^3 - a^3).
TEST(Chambers, InflateAThickSphereAsLameSays) {
    const double a = 0.01, b = 0.02, E = 2e5, nu = 0.45, p = 20.0;
    const double u = p * a / E * ((1 - 2 * nu) * a * a * a + 0.5 * (1 + nu) * b * b * b) / (b * b * b - a * a * a);
    const double exact = 4.0 * std::numbers::pi * a * a * u;
    const mesh::SurfaceMesh ball = mesh::weld(test::together(test::sphere(2, b), inward(test::sphere(2, a))));
    for (const MeshRequest& request :
         {MeshRequest{fem::ElementKind::tet10, 0.012}, MeshRequest{fem::ElementKind::tet10, 0.008},
          MeshRequest{fem::ElementKind::tet4, 0.006}, MeshRequest{fem::ElementKind::hex8, 0.005},
          MeshRequest{fem::ElementKind::hex8, 0.004}, MeshRequest{fem::ElementKind::hex8, 0.0025},
          MeshRequest{fem::ElementKind::hex8, 0.002}}) {
        const Inflated found = inflated(ball, Vector3d::Zero(), request, E, nu, p);
        std::printf("sphere %s %.4f: factor %.4f  error %+.4f  uncorrected %+.4f\n",
                    to_string(*request.element).c_str(), *request.resolution_m, found.factor,
                    found.volume_change_m3 / exact - 1.0,
                    found.volume_change_m3 / found.factor / found.factor / exact - 1.0);
    }
}

}  // namespace
}  // namespace myo::setup
