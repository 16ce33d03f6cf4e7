#include "diagnosis/missing_force/effect_forces.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// The whole body moves with constant acceleration from rest; nothing is strained.
dynamics::Trace pushed(const Matrix3Xd& X, const Vector3d& a, double end_s) {
    dynamics::Trace trace;
    trace.status = dynamics::RunStatus::complete;
    for (int k = 0; k <= 10; ++k) {
        const double t = end_s * k / 10.0;
        trace.times_s.push_back(t);
        trace.positions.push_back(X.colwise() + 0.5 * t * t * a);
        trace.velocities.push_back(Matrix3Xd::Zero(3, X.cols()).colwise() + t * a);
    }
    return trace;
}

prediction::ParameterValues with_effect(const setup::Setup& setup, effect::EffectDeclaration effect) {
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.effects.push_back(std::move(effect));
    return values;
}

TEST(EffectForces, OfAPointMassAreItsWeightAndInertia) {
    const test::Folder folder("effect_forces");
    const setup::Setup setup = test::swung_beam(folder);
    const Vector3d a(0.3, -2.0, 1.1), tip(0.1, 0.015, 0.03);
    const prediction::ParameterValues values = with_effect(
        setup, {"point_mass", {{"mass_kg", 0.004}, {"position_m", Eigen::VectorXd(tip)}}});
    const NodalForces found = effect_forces(setup, 0, values, 0, pushed(setup.mesh.mesh.nodes, a, 0.5), 20);
    ASSERT_TRUE(found.failure.empty()) << found.failure;
    ASSERT_EQ(found.times_s.size(), 11u);
    for (const Matrix3Xd& force : found.force_N) {
        EXPECT_LT((force.rowwise().sum() - 0.004 * (Vector3d(0.0, 0.0, -9.81) - a)).norm(), 1e-9);
        Vector3d moment = Vector3d::Zero();  // about the place of the mass
        for (Eigen::Index i = 0; i < force.cols(); ++i)
            moment += Vector3d(setup.mesh.mesh.nodes.col(i) - tip).cross(Vector3d(force.col(i)));
        EXPECT_LT(moment.norm(), 1e-9);
    }
}

TEST(EffectForces, OfADragGrowWithTheSpeedAndGoAgainstIt) {
    const test::Folder folder("effect_forces");
    const setup::Setup setup = test::swung_beam(folder);
    const Matrix3Xd& X = setup.mesh.mesh.nodes;
    const Vector3d a(0.0, 0.0, 1.0);
    const prediction::ParameterValues values = with_effect(setup, {"quadratic_drag", {{"coefficient_kg_m3", 500.0}}});
    const NodalForces found = effect_forces(setup, 0, values, 0, pushed(X, a, 1.0), 20);
    ASSERT_EQ(found.force_N.size(), 11u);
    EXPECT_EQ(found.force_N.front().norm(), 0.0);
    const Vector3d whole = found.force_N.back().rowwise().sum(), half = found.force_N[5].rowwise().sum();
    EXPECT_LT((whole - 4.0 * half).norm(), 1e-9 * whole.norm());
    // Traction -500 v^2 on all faces but those at the clamp, whose nodes are held: between the free and the whole
    // surface.
    const double area = 4.0 * 0.1 * 0.03 + 0.03 * 0.03;
    EXPECT_LT(-whole.z(), 500.0 * area);
    EXPECT_GT(-whole.z(), 0.85 * 500.0 * area);
    for (Eigen::Index i = 0; i < X.cols(); ++i)
        EXPECT_TRUE(!setup.body->clamped[static_cast<std::size_t>(i)] || found.force_N.back().col(i).norm() == 0.0);
}

TEST(EffectForces, AreNoneForWhatIsOnlySeenOrRemembered) {
    const test::Folder folder("effect_forces");
    const setup::Setup setup = test::swung_beam(folder);
    const dynamics::Trace motion = pushed(setup.mesh.mesh.nodes, {0.0, 0.0, 1.0}, 1.0);
    const NodalForces seen = effect_forces(setup, 0, with_effect(setup, {"clock_offset", {{"offset_s", 0.02}}}), 0,
                                           motion, 5);
    ASSERT_TRUE(seen.failure.empty());
    for (const Matrix3Xd& force : seen.force_N) EXPECT_EQ(force.norm(), 0.0);
    const NodalForces creep = effect_forces(
        setup, 0, with_effect(setup, {"viscoelastic_creep", {{"modulus_ratio", 0.2}, {"relaxation_time_s", 0.3}}}), 0,
        motion, 5);
    EXPECT_FALSE(creep.failure.empty());
    EXPECT_TRUE(creep.force_N.empty());
}

TEST(BodyPatches, KeepTheWholeForce) {
    const test::Folder folder("effect_forces");
    const setup::Setup setup = test::swung_beam(folder);
    const BodyPatches patches = body_patches(*setup.body, 40);
    EXPECT_GT(patches.count, 20);
    EXPECT_LT(patches.count, 80);
    const Matrix3Xd force = Matrix3Xd::Random(3, setup.mesh.mesh.nodes.cols());
    EXPECT_LT((patches.sums(force).rowwise().sum() - force.rowwise().sum()).norm(), 1e-12);
    EXPECT_EQ(patches_on(*setup.body, *setup.body, patches).patch_of_node, patches.patch_of_node);
}

/// Nodes of other cells lie in the box of the nodes of their patch, but for half a cell.
TEST(BodyPatches, HoldTheNodesOfAnotherMesh) {
    const test::Folder folder("patches_on");
    const setup::Setup coarse = test::swung_beam(folder, 0.05);
    setup::SetupSettings settings = coarse.settings;
    settings.mesh.refinement = 0.4;
    const setup::Setup fine = test::setup_of_folder(folder, settings);
    const BodyPatches patches = body_patches(*fine.body, 40), mapped = patches_on(*coarse.body, *fine.body, patches);
    EXPECT_EQ(mapped.count, patches.count);
    ASSERT_EQ(mapped.patch_of_node.size(), coarse.mesh.mesh.nodes.cols());
    std::vector<Eigen::AlignedBox3d> boxes(static_cast<std::size_t>(patches.count));
    for (Eigen::Index k = 0; k < patches.patch_of_node.size(); ++k)
        boxes[static_cast<std::size_t>(patches.patch_of_node(k))].extend(Vector3d(fine.mesh.mesh.nodes.col(k)));
    for (Eigen::Index i = 0; i < mapped.patch_of_node.size(); ++i)
        EXPECT_LT(boxes[static_cast<std::size_t>(mapped.patch_of_node(i))].exteriorDistance(
                      Vector3d(coarse.mesh.mesh.nodes.col(i))),
                  0.5 * fine.mesh.resolution_m * std::sqrt(3.0));
}

}  // namespace
}  // namespace myo::diagnosis
