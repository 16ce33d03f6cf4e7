#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/missing_force/effect_forces.hpp"
#include "diagnosis/missing_force/force_fields.hpp"
#include "diagnosis/missing_force/missing_force.hpp"
#include "diagnosis/missing_force/peak_energy.hpp"
#include "diagnosis/missing_force/smooth_force.hpp"
#include "diagnosis/missing_force/timed_forces.hpp"
#include "mesh/box_mesh.hpp"

// Parts of the missing force on a single block and on matrices of a few numbers.

namespace myo::diagnosis::missing_force_values_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const MissingForcePolicy policy;

/// A block of 2 x 1 x 1 cells of 1 cm, held at its lower end along x.
model::BodyPointer block() {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh({Eigen::Vector3d::Zero(), {0.02, 0.01, 0.01}}, {2, 1, 1});
    std::vector<int> held;
    for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
        if (mesh.nodes(0, i) == 0.0) held.push_back(static_cast<int>(i));
    return model::make_body(mesh, fem::ElementKind::hex8, held);
}

TEST(KnotTimes, AreAQuarterOfATenthOfASecondApart) {
    const auto knots = [](double end_s) { return knot_times(end_s, policy); };
    const KnotTimes usual = knots(1.0);
    EXPECT_EQ(usual.count, 41);
    EXPECT_NEAR(usual.spacing_s, 0.025, 1e-12);
    EXPECT_NEAR(usual.end_s(), 1.0, 1e-12);
    EXPECT_EQ(knots(0.1).count, policy.min_knots);
    EXPECT_NEAR(knots(0.1).end_s(), 0.1, 1e-12);
    EXPECT_EQ(knots(10.0).count, policy.max_knots);
    EXPECT_NEAR(knots(10.0).end_s(), 10.0, 1e-12);
    EXPECT_EQ(knots(0.26).count, 12) << "eleven intervals";
    EXPECT_EQ(knots(0.28).count, 13);
    MissingForcePolicy wider;
    wider.knot_spacing_s = 0.05;
    EXPECT_EQ(knot_times(1.0, wider).count, 21);
}

TEST(KnotSignal, IsLinearBetweenKnots) {
    const fibre::Signal signal = knot_signal({0.1, 3}, Eigen::Vector3d(1.0, 3.0, -1.0));
    EXPECT_NEAR(signal.value(0.0), 1.0, 1e-12);
    EXPECT_NEAR(signal.value(0.05), 2.0, 1e-12);
    EXPECT_NEAR(signal.value(0.1), 3.0, 1e-12);
    EXPECT_NEAR(signal.value(0.175), 0.0, 1e-12);
    EXPECT_NEAR(signal.value(0.5), -1.0, 1e-12);
}

/// One unknown: the largest lambda for which the residual is allowed has a closed form.
TEST(SmoothForce, OfOneUnknownHasAClosedForm) {
    const MatrixXd A = Eigen::Vector2d(3.0, 4.0), R = MatrixXd::Constant(1, 1, 4.0);
    const SmoothForce solver(A, R, policy);
    const VectorXd d = Eigen::Vector2d(-3.0, -4.0);  // removed by x = 1
    for (const double left : {0.04, 0.25, 0.81}) {   // (1 - x)^2 of it
        const VectorXd x = solver.solve(d, 25.0 * left);
        EXPECT_NEAR(x(0), 1.0 - std::sqrt(left), 1e-6) << left;
    }
    EXPECT_NEAR(solver.solve(d, 100.0)(0), 0.0, 2e-3) << "more than there is";
    MissingForcePolicy four_times;
    four_times.lowest_lambda = four_times.highest_lambda = 4.0;  // lambda R is four times A'A
    EXPECT_NEAR(SmoothForce(A, R, four_times).solve(d, 0.0)(0), 0.2, 1e-9);
    EXPECT_EQ(SmoothForce(MatrixXd::Zero(2, 1), R, policy).solve(d, 1.0)(0), 0.0) << "a force that does nothing";
}

TEST(TimedForces, FollowTheirCourses) {
    const model::BodyPointer body = block();
    Matrix3Xd pattern = Matrix3Xd::Zero(3, body->node_count());
    pattern(1, 5) = 2.0;
    const model::ForceElementPointer force = timed_forces(
        {{pattern, {{0.0, 1.0}, {0.0, 3.0}}}, {pattern, fibre::Signal::constant(0.5)}}, 2.0);
    const auto at = [&](double time_s) {
        model::InternalEnergy out;
        out.gradient = Matrix3Xd::Zero(3, body->node_count());
        force->add(*body, {body->mesh.nodes, nullptr, 1.0, time_s, false}, model::HessianKind::none, out);
        return out.gradient(1, 5);
    };
    EXPECT_NEAR(at(0.0), -2.0 * 2.0 * 0.5, 1e-12) << "the gradient is minus the force";
    EXPECT_NEAR(at(0.5), -2.0 * 2.0 * (1.5 + 0.5), 1e-12);
    EXPECT_EQ(force->parameters().size(), 2u);
    EXPECT_EQ(force->parameters()[0].value, 2.0);
    EXPECT_FALSE(force->steady(0.0, 0.5));
    EXPECT_TRUE(force->steady(2.0, 3.0)) << "constant after the last knot";
    Matrix3Xd change = Matrix3Xd::Zero(3, body->node_count());
    force->add_tangent(*body, {body->mesh.nodes, nullptr, 1.0, 0.5, false}, Eigen::Vector2d(1.0, 0.0), change);
    EXPECT_NEAR(change(1, 5), -2.0 * 1.5, 1e-12);
}

TEST(ForceFields, OfABlockAreUniformTogether) {
    const model::BodyPointer body = block();
    const ForceFields fields = force_fields(*body, policy);
    ASSERT_EQ(fields.patterns.size(), 9u);
    for (int axis = 0; axis < 3; ++axis) {
        Matrix3Xd sum = Matrix3Xd::Zero(3, body->node_count());
        for (int station = 0; station < 3; ++station)
            sum += fields.patterns[static_cast<std::size_t>(3 * station + axis)];
        for (int other = 0; other < 3; ++other)
            if (other != axis) {
                EXPECT_EQ(sum.row(other).norm(), 0.0);
            }
        // Hat functions add up to one: the weight of the nodes that are free.
        double free_volume = 0.0;
        const VectorXd mass = body->unit_mass * VectorXd::Ones(body->node_count());
        for (int i = 0; i < body->node_count(); ++i)
            if (!body->clamped[static_cast<std::size_t>(i)]) free_volume += mass(i);
        EXPECT_NEAR(sum.row(axis).sum(), free_volume, 1e-9 * free_volume);
    }
    EXPECT_LT((fields.volume - fields.volume.transpose()).norm(), 1e-18);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(fields.volume).eigenvalues()(0), 0.0);
    MissingForcePolicy ends_only;
    ends_only.stations = 2;
    EXPECT_EQ(force_fields(*body, ends_only).patterns.size(), 6u);
}

/// A uniform stretch at constant volume: mu/2 (l^2 + 2/l - 3) in every cell.
TEST(PeakEnergy, OfAUniformStretchHasAClosedForm) {
    model::Model model;
    model.body = block();
    model.moduli.assign(2, {});
    model.moduli[0].mu = 3e4;
    model.moduli[1].mu = 5e4;
    prediction::TrialPrediction stretched;
    const double l = 1.3;
    const Matrix3Xd x = Eigen::Vector3d(l, 1.0 / std::sqrt(l), 1.0 / std::sqrt(l)).asDiagonal() *
                        model.body->mesh.nodes;
    stretched.trace.positions = {x};
    const double stiff = 0.5 * 5e4 * (l * l + 2.0 / l - 3.0);
    EXPECT_NEAR(peak_isochoric_energy({model}, {stretched}), stiff, 1e-9 * stiff);
    stretched.trace.positions = {1.7 * x};
    EXPECT_NEAR(peak_isochoric_energy({model}, {stretched}), stiff, 1e-9 * stiff) << "a change of volume counts not";
    stretched.trace.positions = {model.body->mesh.nodes};
    EXPECT_NEAR(peak_isochoric_energy({model}, {stretched}), 0.0, 1e-9);
    EXPECT_EQ(peak_isochoric_energy({}, {}), 0.0);
}

TEST(MissingForceValues, SharesAndPeaks) {
    MissingForce force;
    EXPECT_EQ(force.removed(), 0.0);
    force.before_over_noise = 10.0;
    force.after_over_noise = 5.0;
    EXPECT_NEAR(force.removed(), 0.75, 1e-12);
    ForceMode mode;
    EXPECT_EQ(mode.peak_N(), 0.0);
    mode.amplitude_N = Eigen::Vector2d(3.0, -4.0);
    EXPECT_NEAR(mode.rms_N(), std::sqrt(12.5), 1e-12);
    EXPECT_EQ(mode.peak_N(), 4.0);
}

TEST(BodyPatches, SumOverTheNodesOfACube) {
    const model::BodyPointer body = block();
    const BodyPatches patches = body_patches(*body, 2);
    ASSERT_EQ(patches.count, 2) << "one per centimetre";
    const Matrix3Xd sums = patches.sums(Matrix3Xd::Ones(3, body->node_count()));
    EXPECT_EQ(sums.sum(), 3.0 * body->node_count());
    for (Eigen::Index i = 0; i < body->node_count(); ++i)
        EXPECT_EQ(patches.patch_of_node(i) == patches.patch_of_node(0), body->mesh.nodes(0, i) < 0.0099) << i;
}

}  // namespace
}  // namespace myo::diagnosis::missing_force_values_test
