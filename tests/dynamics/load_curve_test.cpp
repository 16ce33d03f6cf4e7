#include <gtest/gtest.h>

#include "dynamics/simulate.hpp"
#include "support/beam.hpp"
#include "support/statics.hpp"

// Dead forces with a course over time.

namespace myo::dynamics {
namespace {

test::BeamSpec damped() {
    test::BeamSpec spec;
    spec.poissons_ratio = 0.45;
    spec.damping_s = 0.01;
    return spec;
}

Trace run(const model::Model& model, double end_s, double h_s) {
    SimulationOptions options;
    options.h_s = h_s;
    options.end_s = end_s;
    options.solver.tolerance = 1e-9;
    const Trace trace = simulate(model, options);
    EXPECT_TRUE(trace.complete()) << trace.message;
    return trace;
}

TEST(LoadCurve, ASlowRampEndsAtTheStaticPose) {
    const test::BeamSpec spec = damped();
    model::Model model = test::make_beam(spec);
    test::push_tip(model, spec, {0.0, 0.0, -0.2});
    const double still = test::tip_at_equilibrium(model, spec).z();
    model.forces.back().course = {{0.0, 4.0}, {0.0, 1.0}};
    const Trace trace = run(model, 4.0, 0.02);
    const double half = test::tip_displacement(model, spec, trace.positions[trace.positions.size() / 2]).z(),
                 end = test::tip_displacement(model, spec, trace.positions.back()).z();
    EXPECT_LT(still, -0.002);
    EXPECT_NEAR(end / still, 1.0, 0.02);
    EXPECT_NEAR(half / still, 0.5, 0.05);
}

/// A jump has two rows; what a window of time says is the same force, to the last bit.
TEST(LoadCurve, AJumpIsTheStartOfAWindow) {
    const test::BeamSpec spec = damped();
    model::Model window = test::make_beam(spec);
    test::push_tip(window, spec, {0.0, 0.1, -0.2});
    model::Model curve = window;
    window.forces.back().from_s = 0.033;
    window.forces.back().until_s = 0.072;
    curve.forces.back().course = {{0.033, 0.033, 0.072, 0.072}, {0.0, 1.0, 1.0, 0.0}};
    EXPECT_EQ(model::jump_times(window), model::jump_times(curve));
    const Trace a = run(window, 0.1, 0.005), b = run(curve, 0.1, 0.005);
    EXPECT_EQ(a.positions.back(), b.positions.back());
    EXPECT_LT(test::tip_displacement(window, spec, a.positions.back()).z(), -1e-3);
}

}  // namespace
}  // namespace myo::dynamics
