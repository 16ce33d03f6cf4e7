#include "commands/force_arrows.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mesh/box_mesh.hpp"

// Arrows of the forces that a diagnosis misses: which are shown, when, and how long they are.

namespace myo::ui::force_arrows {
namespace {

using commands::PatchForces;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Two patches; the force on the first grows, that on the second shrinks along -y.
PatchForces two_patches() {
    PatchForces forces;
    forces.time_s = Vector3d(1.0, 2.0, 4.0);
    for (const auto& [first, second] : std::vector<std::pair<double, double>>{{0.0, 4.0}, {6.0, 2.0}, {10.0, 0.0}}) {
        Matrix3Xd force(3, 2);
        force << first, 0.0, 0.0, -second, 0.0, 0.0;
        forces.force_N.push_back(force);
    }
    forces.largest_N = 10.0;
    return forces;
}

/// A diagnosed bar whose halves are the patches, with the forces in its second trial.
struct Diagnosed {
    Diagnosed() {
        auto body = std::make_shared<commands::MeshedBody>();
        body->mesh = mesh::box_hex_mesh({{0, 0, 0}, {3, 1, 1}}, {3, 1, 1});
        body->boundary = mesh::boundary_faces(body->mesh);
        state.body = body;
        state.trial = 1;
        state.time_s = 2.0;
        commands::DiagnosisRow row;
        row.name = "Linear drag";
        row.key = "linear_drag";
        row.chosen = true;
        row.force = {nullptr, std::make_shared<const PatchForces>(two_patches())};
        view.rows = {row};
        view.patches = 2;
        view.patch_of_node = (body->mesh.nodes.row(0).array() > 1.5).cast<int>().transpose();
        publish();
        drawn.positions = body->mesh.nodes;
        drawn.extent = {{0, 0, 0}, {3, 4, 12}};  // its diagonal is 13
    }
    void publish() { state.diagnosis = std::make_shared<commands::DiagnosisView>(view); }
    bool shown() const { return commands::shown_forces(state) != nullptr; }
    void draw() { commands::add_force_arrows(drawn, state, platform::make_theme(platform::ThemeName::dark, 1.0f)); }

    commands::WorkbenchState state;
    commands::DiagnosisView view;
    viewport::DrawnScene drawn;
};

TEST(ForceAtTime, IsLinearBetweenSamplesAndHeldBeyond) {
    const PatchForces forces = two_patches();
    for (const auto& [t, first, second] : std::vector<std::array<double, 3>>{{-9.0, 0.0, 4.0},
                                                                             {1.0, 0.0, 4.0},
                                                                             {1.5, 3.0, 3.0},
                                                                             {2.0, 6.0, 2.0},
                                                                             {3.0, 8.0, 1.0},
                                                                             {4.0, 10.0, 0.0},
                                                                             {99.0, 10.0, 0.0}}) {
        const Matrix3Xd force = commands::force_at_time(forces, t);
        EXPECT_LT((force.col(0) - Vector3d(first, 0.0, 0.0)).norm(), 1e-12) << t;
        EXPECT_LT((force.col(1) - Vector3d(0.0, -second, 0.0)).norm(), 1e-12) << t;
    }
    EXPECT_EQ(commands::force_at_time({}, 0.0).cols(), 0);
}

TEST(TimeWithForces, StaysWhereForcesAreSeenAndGoesToTheLargestOtherwise) {
    PatchForces forces = two_patches();
    for (const double t : {0.0, 1.0, 1.7, 3.0, 9.0}) EXPECT_EQ(commands::time_with_forces(forces, t), t);
    // A tenth of the largest force is the limit.
    forces.force_N[0].col(1).y() = -0.99;
    EXPECT_EQ(commands::time_with_forces(forces, 1.5), 4.0);
    forces.force_N[0].col(1).y() = -1.01;
    EXPECT_EQ(commands::time_with_forces(forces, 1.5), 1.5);
}

TEST(ShownForces, AreThoseOfTheRowTheTrialAndTheMesh) {
    Diagnosed diagnosed;
    EXPECT_TRUE(diagnosed.shown());
    for (const int trial : {0, 2}) {
        diagnosed.state.trial = trial;
        EXPECT_FALSE(diagnosed.shown()) << trial;
    }
    diagnosed.state.trial = 1;
    diagnosed.state.body_settings.resolution_m *= 2.0;
    EXPECT_FALSE(diagnosed.shown()) << "patches are lists of the nodes of another mesh";
    diagnosed.state.diagnosis_settings = diagnosed.state.body_settings;
    EXPECT_TRUE(diagnosed.shown());
    const Eigen::VectorXi patches = diagnosed.view.patch_of_node;
    diagnosed.view.patch_of_node.conservativeResize(patches.size() - 1);
    diagnosed.publish();
    EXPECT_FALSE(diagnosed.shown());
    diagnosed.view.patch_of_node = patches;
    diagnosed.publish();
    EXPECT_TRUE(diagnosed.shown());
    auto none = std::make_shared<PatchForces>(two_patches());
    none->largest_N = 0.0;
    diagnosed.view.rows[0].force[1] = none;
    diagnosed.publish();
    EXPECT_FALSE(diagnosed.shown()) << "they have no length";
    diagnosed.state.diagnosis.reset();
    EXPECT_FALSE(diagnosed.shown());
}

TEST(ForceArrows, StartAtTheMiddlesOfThePatchesInTheirScale) {
    Diagnosed diagnosed;
    diagnosed.draw();
    ASSERT_EQ(diagnosed.drawn.lines.size(), 1u);
    const Matrix3Xd& points = diagnosed.drawn.lines[0].points;
    ASSERT_EQ(points.cols(), 20);
    // The largest force of the trial has 30 % of the diagonal: 10 N are 3.9 m.
    ASSERT_TRUE(diagnosed.drawn.arrows);
    EXPECT_DOUBLE_EQ(diagnosed.drawn.arrows->metres_per_N, 0.39);
    EXPECT_EQ(diagnosed.drawn.arrows->name, "Force of linear drag");
    const Vector3d first(0.5, 0.5, 0.5), second(2.5, 0.5, 0.5);
    EXPECT_LT((points.col(0) - first).norm(), 1e-12);
    EXPECT_LT((points.col(1) - first - Vector3d(6.0 * 0.39, 0.0, 0.0)).norm(), 1e-12);
    EXPECT_LT((points.col(10) - second).norm(), 1e-12);
    EXPECT_LT((points.col(11) - second - Vector3d(0.0, -2.0 * 0.39, 0.0)).norm(), 1e-12);
    EXPECT_LT(diagnosed.drawn.body_opacity, 1.0) << "they begin inside of the body";
}

TEST(ForceArrows, MoveWithTheBodyAndLeaveVeryShortOnesOut) {
    Diagnosed diagnosed;
    diagnosed.drawn.positions.colwise() += Vector3d(0.0, 7.0, 0.0);
    diagnosed.drawn.body_opacity = 0.1;
    for (const auto& [time_s, arrows] : std::vector<std::pair<double, int>>{{2.0, 2}, {3.79, 2}, {3.81, 1}, {4.0, 1}}) {
        diagnosed.drawn.lines.clear();
        diagnosed.state.time_s = time_s;  // the second force is 0.2 N, a fiftieth of the largest, at 3.8 s
        diagnosed.draw();
        ASSERT_EQ(diagnosed.drawn.lines.size(), 1u);
        EXPECT_EQ(diagnosed.drawn.lines[0].points.cols(), 10 * arrows) << time_s;
        EXPECT_LT((diagnosed.drawn.lines[0].points.col(0) - Vector3d(0.5, 7.5, 0.5)).norm(), 1e-12);
    }
    EXPECT_EQ(diagnosed.drawn.body_opacity, 0.1) << "more translucent than the arrows need";
}

TEST(ForceArrows, AreLeftOutOnDemandAndOnAnotherShape) {
    Diagnosed diagnosed;
    diagnosed.state.view.effect_force = false;
    diagnosed.draw();
    EXPECT_TRUE(diagnosed.drawn.lines.empty());
    diagnosed.state.view.effect_force = true;
    diagnosed.drawn.positions.conservativeResize(3, diagnosed.drawn.positions.cols() - 1);
    diagnosed.draw();
    EXPECT_TRUE(diagnosed.drawn.lines.empty());
    EXPECT_FALSE(diagnosed.drawn.arrows);
    EXPECT_EQ(diagnosed.drawn.body_opacity, 1.0);
    // The missing force is no effect.
    Diagnosed missing;
    missing.view.rows[0].kind = commands::DiagnosisRow::Kind::missing_force;
    missing.view.rows[0].name = "Missing force";
    missing.publish();
    missing.draw();
    ASSERT_TRUE(missing.drawn.arrows);
    EXPECT_EQ(missing.drawn.arrows->name, "Missing force");
}

}  // namespace
}  // namespace myo::ui::force_arrows
