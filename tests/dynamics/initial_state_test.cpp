#include <gtest/gtest.h>

#include <limits>

#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Trace run_from(const model::Model& model, const InitialState& initial, double h, double end) {
    SimulationOptions options;
    options.h_s = h;
    options.end_s = end;
    options.initial = initial;
    options.solver.tolerance = 1e-9;
    return simulate(model, options);
}

/// A run that is stopped and taken up again from its positions and velocities goes on as if it had not been.
TEST(InitialState, ARunCanBeTakenUpAgain) {
    for (const char* element : {"hex8", "tet10"})
        for (const double damping : {0.0, 0.004}) {
            test::BeamSpec spec;
            spec.kind = test::element(element);
            spec.gravity_m_s2 = 9.81;
            spec.damping_s = damping;
            const model::Model model = test::make_beam(spec);
            const double h = 0.005;
            const Trace whole = run_from(model, {}, h, 40 * h);
            const Trace rest = run_from(model, {whole.positions[20], whole.velocities[20]}, h, 20 * h);
            ASSERT_TRUE(whole.complete() && rest.complete()) << whole.message << rest.message;
            const double motion = (whole.positions.back() - whole.positions[20]).cwiseAbs().maxCoeff();
            const double difference = (rest.positions.back() - whole.positions.back()).cwiseAbs().maxCoeff() / motion;
            test::record(std::string(element) + (damping > 0.0 ? "_damped" : ""), difference);
            EXPECT_GT(motion, 1e-3);
            EXPECT_LT(difference, 1e-5) << element << " " << damping;
        }
}

/// A free body thrown as a whole flies on without deforming; a clamped node stays where it is.
TEST(InitialState, AThrownBodyFlies) {
    test::BeamSpec spec;
    spec.clamped = false;
    model::Model model = test::make_beam(spec);
    const Vector3d v(1.0, -2.0, 0.5);
    const Matrix3Xd X = model.body->mesh.nodes;
    const Trace flight = run_from(model, {X.colwise() + Vector3d(0.0, 0.0, 0.3), v.replicate(1, X.cols())}, 0.01, 0.1);
    ASSERT_TRUE(flight.complete()) << flight.message;
    EXPECT_LT((flight.positions.back() - (X.colwise() + (Vector3d(0.0, 0.0, 0.3) + 0.1 * v))).cwiseAbs().maxCoeff(),
              1e-9);

    spec.clamped = true;
    model = test::make_beam(spec);
    const Trace held = run_from(model, {X.colwise() + v, v.replicate(1, X.cols())}, 0.01, 0.01);
    for (Eigen::Index i = 0; i < X.cols(); ++i)
        if (model.body->clamped[static_cast<std::size_t>(i)]) {
            EXPECT_EQ(held.positions.front().col(i), X.col(i));
            EXPECT_EQ(held.velocities.front().col(i), Vector3d::Zero());
            EXPECT_EQ(held.positions.back().col(i), X.col(i));
        }
}

TEST(InitialState, MustBeFinite) {
    const model::Model model = test::make_beam({});
    Matrix3Xd x = model.body->mesh.nodes;
    x(1, 2) = std::numeric_limits<double>::quiet_NaN();
    for (const InitialState& initial : {InitialState{x, {}}, InitialState{{}, x}}) {
        const Trace trace = run_from(model, initial, 0.01, 0.1);
        EXPECT_EQ(trace.status, RunStatus::failed);
        EXPECT_NE(trace.message.find("initial"), std::string::npos) << trace.message;
        EXPECT_TRUE(trace.positions.empty());
    }
}

}  // namespace
}  // namespace myo::dynamics
