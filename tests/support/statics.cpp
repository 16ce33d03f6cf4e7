#include "support/statics.hpp"

#include <gtest/gtest.h>

#include "dynamics/statics.hpp"

namespace myo::test {

Eigen::Matrix3Xd equilibrium(const model::Model& model) {
    dynamics::StageSolver solver(model);
    // The search starts at rest, with all loads applied at t = 0.
    Eigen::Matrix3Xd x = model.body->mesh.nodes;
    const dynamics::StageReport report = dynamics::solve_equilibrium(solver, 0.0, x);
    EXPECT_TRUE(report.ok()) << report.message;
    return x;
}

Eigen::Vector3d tip_at_equilibrium(const model::Model& model, const BeamSpec& spec) {
    return tip_displacement(model, spec, equilibrium(model));
}

}  // namespace myo::test
