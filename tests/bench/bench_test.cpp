#include <gtest/gtest.h>

#include <set>

#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "support/figures.hpp"

namespace myo::bench {
namespace {

TEST(Bench, CasesAndRunsHaveNamesOfTheirOwn) {
    std::set<std::string> ids;
    for (const BenchCase& one : bench_catalogue()) {
        EXPECT_TRUE(ids.insert(one.id).second) << one.id;
        EXPECT_FALSE(one.summary.empty());
        std::set<std::string> names;
        for (const BenchRun& run : one.runs) EXPECT_TRUE(names.insert(run.name).second) << one.id << ": " << run.name;
        EXPECT_FALSE(names.empty()) << one.id;
    }
}

/// A row counts what the run did; its times are not asserted.
TEST(Bench, ARowDescribesItsRun) {
    BenchBeam beam;
    beam.cells = {4, 1, 1};
    const Result<BenchFigures> figures = measure_run("short", beam,
                                                     bench_options(dynamics::Integrator::tr_bdf2, 0.01, 5, 1e-6));
    ASSERT_TRUE(figures);
    EXPECT_EQ(figures->dofs, 60);
    EXPECT_EQ(figures->cells, 4);
    EXPECT_EQ(figures->steps, 5);
    EXPECT_GT(figures->iterations_per_step, 1.0);
    EXPECT_GT(figures->factorisations_per_step, 0.0);
    EXPECT_GT(figures->run_s, 0.0);
    EXPECT_GT(figures->limit_ms, 0.0);
    EXPECT_GT(figures->real_time_factor(), 0.0);
}

TEST(Bench, ARunThatFailsSaysSo) {
    BenchBeam beam;
    beam.cells = {4, 1, 1};
    beam.tip_force_N = 1e9;
    const Result<BenchFigures> figures = measure_run(
        "torn", beam, bench_options(dynamics::Integrator::implicit_euler, 0.05, 3, 1e-6));
    ASSERT_FALSE(figures);
    EXPECT_NE(figures.error().text().find("torn"), std::string::npos);
}

/// The cost of many holds in iterations: the first evaluation follows the commands, later ones correct a pose.
TEST(BenchHolds, FitTheModulusInFewIterations) {
    const BenchCase holds = bench_holds();
    const Result<BenchFigures> figures = holds.runs.front().run();
    ASSERT_TRUE(figures) << figures.error().text();
    ASSERT_FALSE(figures->quantities.empty());
    EXPECT_NEAR(*figures->quantities.front().error(), 0.0, 1e-4);
    test::record("iterations_per_hold", figures->iterations_per_step);
    EXPECT_GT(figures->steps, 10);
    EXPECT_LT(figures->iterations_per_step, 9.0);
}

}  // namespace
}  // namespace myo::bench
