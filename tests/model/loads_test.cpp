#include <gtest/gtest.h>

#include "support/beam.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST(Loads, GravityAndAttachedMassWeighWhatTheyShould) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet4, fem::ElementKind::tet10}) {
        test::BeamSpec spec;
        spec.kind = kind;
        spec.gravity_m_s2 = 9.81;
        Model model = test::make_beam(spec);
        model.masses.push_back({test::tip_share(model, spec), 0.05});
        const auto mass = mass_matrix(model);
        const VectorXd ones = VectorXd::Ones(model.body->node_count());
        const double body = 1070.0 * spec.size.prod();
        EXPECT_NEAR(ones.dot(mass.isotropic * ones), body + 0.05, 1e-15);
        EXPECT_LT((Eigen::MatrixXd(mass.isotropic) - Eigen::MatrixXd(mass.isotropic).transpose()).norm(),
                  1e-15 * mass.isotropic.norm());
        const Matrix3Xd f = external_forces(model, mass, 0.0);
        EXPECT_LT((f.rowwise().sum() - Vector3d(0, 0, -9.81 * (body + 0.05))).norm(), 1e-14);
        // About the clamp: the body's weight at half the length, the attached one at the tip.
        EXPECT_NEAR(-f.row(2).dot(model.body->mesh.nodes.row(0)), 9.81 * spec.size(0) * (0.5 * body + 0.05), 1e-14);
    }
}

TEST(Loads, WindowsAreClosedOnTheLeftAndOpenOnTheRight) {
    test::BeamSpec spec;
    Model model = test::make_beam(spec);
    DeadForce force;
    force.share = test::tip_share(model, spec);
    force.force_N = {1.0, 2.0, 3.0};
    force.from_s = 0.1;
    force.until_s = 0.3;
    model.forces.push_back(force);
    const auto mass = mass_matrix(model);
    const auto total = [&](double t, bool before) {
        return Vector3d(external_forces(model, mass, t, before).rowwise().sum());
    };
    EXPECT_EQ(total(0.05, false).norm(), 0.0);
    EXPECT_LT((total(0.1, false) - force.force_N).norm(), 1e-14);
    EXPECT_EQ(total(0.1, true).norm(), 0.0);
    EXPECT_LT((total(0.2, true) - force.force_N).norm(), 1e-14);
    EXPECT_EQ(total(0.3, false).norm(), 0.0);
    EXPECT_LT((total(0.3, true) - force.force_N).norm(), 1e-14);

    DeadForce always = force;
    always.from_s = -std::numeric_limits<double>::infinity();
    always.until_s = 0.1;
    model.forces.push_back(always);
    model.activation = {fibre::Signal::step(0.2, 1.0, 0.8), fibre::Signal::constant(1.0)};
    EXPECT_EQ(jump_times(model), (std::vector<double>{0.1, 0.2, 0.3}));
    EXPECT_EQ(activations(model, 0.2), (std::vector<double>{0.8, 1.0}));
    EXPECT_EQ(activations(model, 0.2, true), (std::vector<double>{1.0, 1.0}));
}

TEST(Loads, FreeNodesAreNumberedAndThePatternIsSorted) {
    const Model model = test::make_beam({});
    const BlockPattern& pattern = model.body->pattern;
    int clamped = 0;
    for (const bool c : model.body->clamped) clamped += c;
    EXPECT_EQ(clamped, 4);
    EXPECT_EQ(pattern.free_count, model.body->node_count() - 4);
    EXPECT_EQ(pattern.zero.rows(), pattern.unknowns());
    for (int column = 0; column < pattern.zero.outerSize(); ++column) {
        int last = column - 1;
        for (solver::SymmetricSparse::InnerIterator entry(pattern.zero, column); entry; ++entry) {
            EXPECT_GT(entry.row(), last);
            last = static_cast<int>(entry.row());
        }
    }
}

}  // namespace
}  // namespace myo::model
