#include "dynamics/live_run.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "dynamics/statics.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A damped beam that falls under gravity, with a muscle in its upper third.
model::Model falling_beam(double damping_s = 0.004) {
    test::BeamSpec spec;
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = damping_s;
    model::Model model = test::make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(
        fibre::fibres_in_box(model.body->mesh, Box{{0, 0, 0.02}, {0.1, 0.03, 0.03}}, Vector3d::UnitX(), 1e5, "top"));
    model.fibres = fibres;
    model.activation = {fibre::Signal::constant(1.0)};
    return model;
}

SimulationOptions options_of(StartKind start) { return test::short_steps(start, 0.01, 0.4); }

std::unique_ptr<LiveRun> begun(const model::Model& model, const SimulationOptions& options,
                               const LiveControls& controls) {
    Result<std::unique_ptr<LiveRun>> run = LiveRun::begin(model, options, controls, {});
    EXPECT_TRUE(run) << (run ? "" : run.error().text());
    return run ? std::move(*run) : nullptr;
}

LiveControls steps_of(const model::Model& model, double h) {
    LiveControls controls = controls_of(model, 0.0);
    controls.h_s = h;
    return controls;
}

/// Positions after each step of a live run, the start first.
std::vector<Matrix3Xd> motion(LiveRun& run, const LiveControls& controls, int steps) {
    std::vector<Matrix3Xd> frames{run.state().x};
    for (int k = 0; k < steps; ++k) {
        const Result<void> stepped = run.advance(controls, {});
        EXPECT_TRUE(stepped) << (stepped ? "" : stepped.error().text());
        frames.push_back(run.state().x);
    }
    return frames;
}

/// Largest deviation of the live motion from a run, relative to the motion.
double deviation(const std::vector<Matrix3Xd>& frames, const Trace& trace) {
    Trace live;
    live.positions = frames;
    return test::relative_difference(trace, live);
}

/// A hand on a node of the free end, `offset_m` away from it.
Grip hand_at_tip(const model::Model& model, const Vector3d& offset_m, double stiffness_N_m) {
    const mesh::VolumeMesh& mesh = model.body->mesh;
    Eigen::Index node = 0;
    mesh.nodes.row(0).maxCoeff(&node);
    Grip grip;
    grip.nodes = {static_cast<int>(node)};
    grip.shares = Eigen::VectorXd::Ones(1);
    grip.places_m = mesh.nodes.col(node) + offset_m;
    grip.stiffness_N_m = stiffness_N_m;
    return grip;
}

TEST(LiveRun, UntouchedItMovesAsTheRunWithTheSameStep) {
    for (const Integrator scheme : {Integrator::tr_bdf2, Integrator::bdf2, Integrator::implicit_euler}) {
        const model::Model model = falling_beam();
        SimulationOptions options = options_of(StartKind::straight);
        options.integrator = scheme;
        const Trace trace = simulate(model, options);
        ASSERT_TRUE(trace.complete()) << trace.message;
        const auto live = begun(model, options, steps_of(model, options.h_s));
        EXPECT_LT(deviation(motion(*live, steps_of(model, options.h_s), 40), trace), 1e-7) << to_string(scheme);
        EXPECT_NEAR(live->time_s(), 0.4, 1e-12);
    }
}

/// The tolerance of the window, ten thousandth of the forces, shifts places by less than a thousandth of the motion.
TEST(LiveRun, TheToleranceOfTheWindowIsNotSeen) {
    const model::Model model = falling_beam();
    SimulationOptions options = options_of(StartKind::straight);
    const Trace exact = simulate(model, options);
    ASSERT_TRUE(exact.complete()) << exact.message;
    options.solver.tolerance = 1e-4;
    const auto live = begun(model, options, steps_of(model, options.h_s));
    const double moved = deviation(motion(*live, steps_of(model, options.h_s), 40), exact);
    test::record("deviation", moved);
    EXPECT_LT(moved, 1e-3);
}

TEST(LiveRun, ASliderOfAMuscleActsAsAJumpOfItsSignal) {
    model::Model model = falling_beam();
    LiveControls controls = steps_of(model, 0.01);
    const auto live = begun(model, options_of(StartKind::equilibrium), controls);
    std::vector<Matrix3Xd> frames = motion(*live, controls, 10);
    controls.activation = {0.8};
    const std::vector<Matrix3Xd> later = motion(*live, controls, 30);
    frames.insert(frames.end(), later.begin() + 1, later.end());
    model.activation = {fibre::Signal{{0.0, 0.1, 0.1}, {1.0, 1.0, 0.8}}};
    const Trace trace = simulate(model, options_of(StartKind::equilibrium));
    ASSERT_TRUE(trace.complete()) << trace.message;
    EXPECT_LT(deviation(frames, trace), 1e-6);
}

TEST(LiveRun, DampingCanChangeWhileTheBodyMoves) {
    const model::Model model = falling_beam(0.0);
    LiveControls controls = steps_of(model, 0.01);
    const auto live = begun(model, options_of(StartKind::straight), controls);
    const std::vector<Matrix3Xd> swinging = motion(*live, controls, 10);
    controls.damping_s = 10.0;
    const std::vector<Matrix3Xd> creeping = motion(*live, controls, 3);
    EXPECT_LT((creeping[3] - creeping[2]).norm(), 0.1 * (swinging[10] - swinging[9]).norm()) << "it still swings";
}

TEST(LiveRun, PulledByAHandItRestsWhereTheForceBendsIt) {
    model::Model model = falling_beam(0.05);
    LiveControls controls = steps_of(model, 0.02);
    controls.grip = hand_at_tip(model, {0.0, 0.0, 0.05}, 20.0);
    const auto live = begun(model, options_of(StartKind::equilibrium), controls);
    motion(*live, controls, 400);
    const Vector3d force = live->grip_force();
    EXPECT_GT(force.z(), 0.1);
    // The same force as a dead load.
    Eigen::VectorXd share = Eigen::VectorXd::Zero(model.body->mesh.node_count());
    share(controls.grip->nodes.front()) = 1.0;
    model.forces.push_back({share, force});
    StageSolver solver(model, options_of(StartKind::straight).solver);
    Matrix3Xd x = model.body->mesh.nodes;
    ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
    const double moved = (x - model.body->mesh.nodes).cwiseAbs().maxCoeff();
    EXPECT_LT((live->state().x - x).cwiseAbs().maxCoeff(), 1e-4 * moved);
    // Let go, it falls back to its own equilibrium.
    controls.grip.reset();
    motion(*live, controls, 400);
    EXPECT_TRUE(live->grip_force().isZero());
    const Matrix3Xd alone = begun(falling_beam(0.05), options_of(StartKind::equilibrium), controls)->state().x;
    EXPECT_LT((live->state().x - alone).cwiseAbs().maxCoeff(), 1e-4 * moved);
}

TEST(LiveRun, AStepEndsWhereALoadJumps) {
    test::BeamSpec spec;
    model::Model model = test::make_beam(spec);
    test::push_tip(model, spec, {0.0, 0.0, -0.2});
    model.forces.back().until_s = 0.033;
    const LiveControls controls = steps_of(model, 0.02);
    const auto live = begun(model, options_of(StartKind::equilibrium), controls);
    const std::vector<Matrix3Xd> frames = motion(*live, controls, 2);
    EXPECT_DOUBLE_EQ(live->time_s(), 0.033);
    const double motion_before = (frames[2] - frames[0]).cwiseAbs().maxCoeff();
    EXPECT_LT(motion_before, 1e-9) << "in equilibrium until the load ends";
    EXPECT_GT((motion(*live, controls, 1)[1] - frames[0]).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(LiveRun, CancelledItKeepsItsState) {
    const model::Model model = falling_beam();
    const LiveControls controls = steps_of(model, 0.01);
    const auto live = begun(model, options_of(StartKind::straight), controls);
    motion(*live, controls, 3);
    const Matrix3Xd before = live->state().x;
    std::atomic<bool> cancelled{true};
    EXPECT_FALSE(live->advance(controls, Progress({}, &cancelled)));
    EXPECT_EQ(live->state().x, before);
    EXPECT_TRUE(live->advance(controls, {}));
}

}  // namespace
}  // namespace myo::dynamics
