#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "dynamics/random_model.hpp"
#include "dynamics/stage_problem.hpp"
#include "dynamics/statics.hpp"
#include "support/figures.hpp"

// Random starts: each ends converged or with a clear report, in a bounded number of iterations, and never with a number
// that is none. The share that converges is recorded for every kind of case. Three hundred of them; as many hundreds as
// MYOLOOP_RANDOM_STARTS says.

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;

constexpr int cases_per_shard = 100;

int shards() {
    const char* const cases = std::getenv("MYOLOOP_RANDOM_STARTS");
    return cases ? std::max(1, std::atoi(cases) / cases_per_shard) : 3;
}

/// Iterations that all strategies and fallbacks of one solve may take together.
constexpr int max_iterations = 2400;

/// Imbalance of forces at a stage's solution over the forces on the body, measured by other means than the solver's.
double imbalance(const model::Model& model, StageSolver& solver, const Stage& stage, const Matrix3Xd& start,
                 const Matrix3Xd& x, double tolerance) {
    const StageConstants constants = stage_constants(model);
    const Matrix3Xd r = stage.inertia_1_s2 *
                            model::times_mass(
                                x, constants.masses[model::span_at(constants.masses, stage.inertia_at_s)].mass) -
                        stage.constant - solver.total_forces(stage, x);
    const StageProblem problem(constants, stage);
    const double scale = std::max(problem.force_scale(start, tolerance), problem.force_scale(x, tolerance));
    return model::gather(model.body->pattern, r).norm() / scale;
}

/// True: converged. What it must not do is a failure.
bool solves_statics(const test::RandomCase& c) {
    StageSolver solver(c.model, c.options.solver);
    const Matrix3Xd start = c.options.initial.positions.size() > 0 ? c.options.initial.positions
                                                                   : c.model.body->mesh.nodes;
    Matrix3Xd x = start;
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    EXPECT_TRUE(x.allFinite());
    EXPECT_LE(report.newton_iterations, max_iterations);
    if (report.ok()) {
        EXPECT_LE(imbalance(c.model, solver, static_stage(*c.model.body, 0.0), start, x, c.options.solver.tolerance),
                  100.0 * c.options.solver.tolerance);
    } else {
        EXPECT_NE(report.message.find("no equilibrium was found"), std::string::npos) << report.message;
    }
    return report.ok();
}

bool runs(const test::RandomCase& c) {
    RunObserver observer;
    Matrix3Xd start = c.options.initial.positions.size() > 0 ? c.options.initial.positions : c.model.body->mesh.nodes;
    observer.stepped = [&](StageSolver& solver, const TimeScheme&, double, double,
                           const std::vector<SolvedStage>& solved) {
        for (const SolvedStage& s : solved) {
            EXPECT_LE(imbalance(c.model, solver, s.stage, start, s.solution.x, c.options.solver.tolerance),
                      100.0 * c.options.solver.tolerance)
                << s.stage.time_s;
            start = s.solution.x;
        }
    };
    const Trace trace = simulate(c.model, c.options, {}, observer);
    EXPECT_EQ(trace.positions.size(), trace.times_s.size());
    EXPECT_EQ(trace.velocities.size(), trace.times_s.size());
    for (const Matrix3Xd& x : trace.positions) EXPECT_TRUE(x.allFinite());
    for (const Matrix3Xd& v : trace.velocities) EXPECT_TRUE(v.allFinite());
    EXPECT_LE(trace.newton_iterations, max_iterations * std::max(1, trace.stages));
    if (trace.complete()) {
        EXPECT_NEAR(trace.times_s.back(), c.options.end_s, 1e-9 * c.options.end_s);
    } else {
        EXPECT_EQ(trace.status, RunStatus::failed);
        EXPECT_FALSE(trace.message.empty());
    }
    return trace.complete();
}

class RandomStarts : public testing::TestWithParam<int> {};

TEST_P(RandomStarts, ConvergeOrSayWhyNot) {
    std::map<std::string, std::pair<int, int>> counts;  // kind -> converged, all
    std::vector<double> failed;
    int converged = 0;
    for (int k = 0; k < cases_per_shard; ++k) {
        const unsigned seed = static_cast<unsigned>(1 + GetParam() * cases_per_shard + k);
        SCOPED_TRACE("case " + std::to_string(seed));
        const test::RandomCase c = test::random_case(seed);
        const bool ok = c.statics ? solves_statics(c) : runs(c);
        converged += ok ? 1 : 0;
        if (!ok) failed.push_back(seed);
        for (const std::string& kind : c.kinds) {
            counts[kind].first += ok ? 1 : 0;
            ++counts[kind].second;
        }
    }
    for (const auto& [kind, count] : counts)
        test::record(kind, {static_cast<double>(count.first), static_cast<double>(count.second)});
    test::record("converged_of_" + std::to_string(cases_per_shard), converged);
    test::record("not_converged", failed);
    EXPECT_GE(converged, 80);
}

INSTANTIATE_TEST_SUITE_P(All, RandomStarts, testing::Range(0, shards()));

}  // namespace
}  // namespace myo::dynamics
