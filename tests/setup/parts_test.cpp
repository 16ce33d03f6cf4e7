#include "setup/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fibre/cell_paint.hpp"
#include "material/catalogue.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "model/internal_forces.hpp"
#include "model/model.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"
#include "support/statics.hpp"

namespace myo::setup {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double length = 0.12, side = 0.012, force_N = 2e-4, body_Pa = 1e5, part_Pa = 4e5, poisson = 0.3;

experiment::PartDeclaration stiff_part(decltype(experiment::PartDeclaration::place) place) {
    experiment::PartDeclaration part;
    part.name = "spine";
    part.place = std::move(place);
    part.youngs_modulus_Pa = part_Pa;
    part.poissons_ratio = poisson;
    part.density_kg_m3 = 2000.0;
    return part;
}

experiment::Experiment bar_with(const experiment::PartDeclaration& part) {
    experiment::Experiment experiment;
    experiment::StlGeometry geometry;
    geometry.metres_per_unit = 1.0;
    experiment.geometry = geometry;
    experiment.material.youngs_modulus_Pa = body_Pa;
    experiment.material.poissons_ratio = poisson;
    experiment.material.density_kg_m3 = 1000.0;
    experiment.parts = {part};
    return experiment;
}

/// A held clamped at x = 0 on a mesh of edges near `edge_m`.
struct Bar {
    model::Model model;
    Eigen::VectorXd end;  // shares of the end face
    std::vector<std::string> warnings;
};
Bar bar_of(const experiment::Experiment& experiment, fem::ElementKind element, double edge_m) {
    const mesh::SurfaceMesh surface = mesh::box_surface({Vector3d::Zero(), {length, side, side}});
    const Result<BodyMesh> mesh = mesh_body(surface, {element, edge_m}, part_boxes(experiment));
    EXPECT_TRUE(mesh) << mesh.error().text();
    Bar held;
    const Result<Eigen::MatrixXd> shares = part_shares(experiment, *mesh, held.warnings);
    EXPECT_TRUE(shares) << shares.error().text();
    EXPECT_NEAR((shares->rowwise().sum().array() - 1.0).abs().maxCoeff(), 0.0, 1e-12);
    held.model.body = model::make_body(mesh->mesh, element,
                                       mesh::nodes_in_box(mesh->mesh, {{-1.0, -1.0, -1.0}, {1e-9, 1.0, 1.0}}));
    held.model.material = material::find_material("neo_hookean");
    held.model.moduli = mixed_moduli(experiment, *shares, declared_materials(experiment, 0.0), 1.0);
    held.model.density_kg_m3 = experiment.material.density_kg_m3;
    held.model.density_factors = density_factors(experiment, *shares);
    const mesh::SurfaceIntegral tip = mesh::surface_weights(held.model.body->mesh, held.model.body->boundary,
                                                            {{length, -1.0, -1.0}, {length + 1e-9, 1.0, 1.0}});
    held.end = tip.weight / tip.weight.sum();
    model::DeadForce load;
    load.share = held.end;
    load.force_N = {0.0, 0.0, force_N};
    held.model.forces = {load};
    return held;
}

double deflection(const Bar& held) {
    const Eigen::Matrix3Xd x = test::equilibrium(held.model);
    return ((x - held.model.body->mesh.nodes) * held.end).z();
}

/// Two materials one behind the other against the beam of Timoshenko.
TEST(Parts, OneBehindTheOtherBendAsABeamOfTwoMaterials) {
    const double half = 0.5 * length, I = std::pow(side, 4) / 12.0, A = side * side;
    const auto cube = [](double a) { return a * a * a; };
    const double bending = force_N / (3.0 * I) * ((cube(length) - cube(half)) / part_Pa + cube(half) / body_Pa);
    const double shear = force_N / (5.0 / 6.0 * A) * 2.0 * (1.0 + poisson) * (half / part_Pa + half / body_Pa);
    std::vector<double> errors;
    for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        const Bar held = bar_of(bar_with(stiff_part(Box{{-1.0, -1.0, -1.0}, {half, 1.0, 1.0}})), element, 0.006);
        EXPECT_TRUE(held.warnings.empty()) << held.warnings[0];
        errors.push_back(deflection(held) / (bending + shear) - 1.0);
        EXPECT_NEAR(errors.back(), 0.0, 0.015);
    }
    test::record("errors", errors);
}

/// Two layers of other moduli against the composite section; the mesh meets the interface.
TEST(Parts, OneOnTheOtherBendAsACompositeSection) {
    // With the interface at a third and moduli 4 : 1 the neutral axis lies at a third, and EI is 256 body_Pa mm^4 per
    // mm.
    const double EI = 256e-9 * side * body_Pa;
    const double bending = force_N * std::pow(length, 3) / (3.0 * EI);
    std::vector<double> errors;
    for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        const Bar held = bar_of(bar_with(stiff_part(Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, side / 3.0}})), element, 0.004);
        EXPECT_TRUE(held.warnings.empty()) << held.warnings[0];
        errors.push_back(deflection(held) / bending - 1.0);
        EXPECT_NEAR(errors.back(), 0.01, 0.025) << "shear adds about a percent";
    }
    test::record("errors", errors);
}

/// A part given by a surface: cells that it crosses have the mean modulus, and that is told.
TEST(Parts, OfASurfaceHaveMeanModuliInTheCellsThatTheyCross) {
    const test::Folder folder("part_surface");
    folder.write("spine.stl", test::hollow_box_stl({{-0.01, -0.01, -0.01}, {0.2, 0.1, side / 3.0}}, {}));
    experiment::Experiment experiment = bar_with(stiff_part(folder.path() / "spine.stl"));
    const Bar coarse = bar_of(experiment, fem::ElementKind::hex8, 0.006);
    ASSERT_EQ(coarse.warnings.size(), 1u);
    EXPECT_THAT(coarse.warnings[0], HasSubstr("50 % of the body is in cells that an interface of parts crosses"));
    // Where the cells meet the interface, a surface is as good as a box.
    const Bar met = bar_of(experiment, fem::ElementKind::hex8, 0.004);
    EXPECT_TRUE(met.warnings.empty());
    const Bar box = bar_of(bar_with(stiff_part(Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, side / 3.0}})),
                           fem::ElementKind::hex8, 0.004);
    EXPECT_NEAR(deflection(met), deflection(box), 1e-9 * deflection(box));
    // 234 instead of 256 of the composite section: layers of moduli 3 and 1, 6 mm each.
    EXPECT_NEAR(deflection(coarse) / deflection(met), 256.0 / 234.0, 0.02);
}

TEST(Parts, HaveTheirOwnWeight) {
    const Bar held = bar_of(bar_with(stiff_part(Box{{-1.0, -1.0, -1.0}, {0.03, 1.0, 1.0}})), fem::ElementKind::tet10,
                            0.006);
    const double volume = length * side * side;
    const model::MassMatrix mass = model::mass_matrix(held.model);
    EXPECT_NEAR(mass.nodal_kg.sum(), 1000.0 * 0.75 * volume + 2000.0 * 0.25 * volume, 1e-12);
    // The centre of mass lies where the densities say.
    const double first_moment = (held.model.body->mesh.nodes.row(0) * mass.nodal_kg)(0);
    EXPECT_NEAR(first_moment, (2000.0 * 0.03 * 0.015 + 1000.0 * 0.09 * 0.075) * side * side, 1e-12);
}

TEST(Parts, HaveTheirOwnDamping) {
    experiment::Experiment experiment = bar_with(stiff_part(Box{{-1.0, -1.0, -1.0}, {0.03, 1.0, 1.0}}));
    experiment.parts[0].damping_s = 0.02;
    Bar held = bar_of(experiment, fem::ElementKind::hex8, 0.006);
    const mesh::SurfaceMesh surface = mesh::box_surface({Vector3d::Zero(), {length, side, side}});
    const Result<BodyMesh> mesh = mesh_body(surface, {fem::ElementKind::hex8, 0.006}, part_boxes(experiment));
    const Eigen::MatrixXd shares = *part_shares(experiment, *mesh, held.warnings);
    held.model.damping_s = 0.003;
    held.model.damping_excess_s = damping_excess(experiment, shares, declared_materials(experiment, 0.003));
    const model::Stiffness stiffness = model::stiffness(held.model);
    for (std::size_t c = 0; c < stiffness.viscous.size(); ++c) {
        const bool in_part = shares(static_cast<Index>(c), 1) > 0.5;
        EXPECT_NEAR(stiffness.viscous[c].mu, (in_part ? 0.02 : 0.003) * stiffness.elastic[c].mu,
                    1e-12 * stiffness.elastic[c].mu);
    }
}

TEST(Parts, AreFoundByTheNumberOfTheirCells) {
    experiment::Experiment experiment = bar_with(stiff_part(experiment::PartDeclaration::Region{3}));
    BodyMesh mesh;
    mesh.mesh = mesh::box_hex_mesh({Vector3d::Zero(), {0.02, 0.01, 0.01}}, {2, 1, 1});
    std::vector<std::string> warnings;
    Result<Eigen::MatrixXd> shares = part_shares(experiment, mesh, warnings);
    ASSERT_FALSE(shares);
    EXPECT_THAT(shares.error().what, HasSubstr("gives its cells no numbers of regions"));
    mesh.mesh.regions = {1, 2};
    shares = part_shares(experiment, mesh, warnings);
    ASSERT_FALSE(shares);
    EXPECT_THAT(shares.error().what, HasSubstr("holds no material of the body"));
    mesh.mesh.regions = {1, 3};
    shares = part_shares(experiment, mesh, warnings);
    ASSERT_TRUE(shares) << shares.error().text();
    EXPECT_EQ((*shares)(0, 1), 0.0);
    EXPECT_EQ((*shares)(1, 1), 1.0);
}

/// Paint of the mesh itself is taken cell by cell, in memory as from its file; a finer mesh has it resampled.
TEST(Parts, AreFoundByTheirPaint) {
    const test::Folder folder("part_paint");
    BodyMesh mesh, finer;
    mesh.mesh = mesh::box_hex_mesh({Vector3d::Zero(), {0.04, 0.01, 0.01}}, {4, 1, 1});
    finer.mesh = mesh::box_hex_mesh({Vector3d::Zero(), {0.04, 0.01, 0.01}}, {8, 2, 2});
    fibre::CellPaint paint = fibre::blank_paint(mesh.mesh);
    paint.weights << 0.0, 1.0, 0.5, 0.0;
    paint.directions.row(0).setOnes();
    const auto mask = std::make_shared<const fibre::PaintedMask>(fibre::mask_of_cells(mesh.mesh, paint));
    ASSERT_TRUE(fibre::write_painted_mask(folder.path() / "spine.csv", *mask));
    using Painted = experiment::PartDeclaration::Painted;
    for (const Painted& painted : {Painted{mask}, Painted{folder.path() / "spine.csv"}}) {
        std::vector<std::string> warnings;
        const Result<Eigen::MatrixXd> shares = part_shares(bar_with(stiff_part(painted)), mesh, warnings);
        ASSERT_TRUE(shares) << shares.error().text();
        EXPECT_NEAR((shares->col(1) - paint.weights).norm(), 0.0, 1e-9);
        EXPECT_NEAR((shares->rowwise().sum().array() - 1.0).abs().maxCoeff(), 0.0, 1e-12);
        const Result<Eigen::MatrixXd> again = part_shares(bar_with(stiff_part(painted)), finer, warnings);
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_NEAR(again->col(1).dot(mesh::cell_volumes(finer.mesh)), 1.5e-6, 1e-9);
    }
}

TEST(Parts, WhoseMaskIsMissingOrElsewhereAreRefusedOrDoubted) {
    const test::Folder folder("part_paint_missing");
    BodyMesh mesh;
    mesh.mesh = mesh::box_hex_mesh({Vector3d::Zero(), {0.04, 0.01, 0.01}}, {4, 1, 1});
    std::vector<std::string> warnings;
    using Painted = experiment::PartDeclaration::Painted;
    Result<Eigen::MatrixXd> shares = part_shares(bar_with(stiff_part(Painted{folder.path() / "spine.csv"})), mesh,
                                                 warnings);
    ASSERT_FALSE(shares);
    EXPECT_THAT(shares.error().what, HasSubstr("part[0].mask: file not found: "));
    fibre::CellPaint paint = fibre::blank_paint(mesh.mesh);
    paint.weights.setOnes();
    paint.directions.row(0).setOnes();
    fibre::PaintedMask mask = fibre::mask_of_cells(mesh.mesh, paint);
    mask.centroids_m.row(2).array() += 1.0;
    shares = part_shares(bar_with(stiff_part(Painted{std::make_shared<const fibre::PaintedMask>(mask)})), mesh,
                         warnings);
    ASSERT_FALSE(shares);
    EXPECT_THAT(shares.error().what, HasSubstr("part[0].mask: holds no material of the body"));
    EXPECT_THAT(warnings, testing::Contains(HasSubstr("painted elements lie where the body has none")));
}

}  // namespace
}  // namespace myo::setup
