#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bench/beam_run.hpp"
#include "bench/beam_statics.hpp"
#include "bench/published_beam.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"
#include "support/shared_data.hpp"

namespace myo::bench {
namespace {

/// The formulation as published reproduces the node's trace that the published program wrote, in its own frame and
/// steps: where that was solved tightly, to five digits, and otherwise as far as its steps were solved.
TEST(PublishedFormulation, FollowsTheTracesOfThePublishedProgram) {
    const std::filesystem::path folder = test::shared_data("design/reference");
    if (folder.empty()) GTEST_SKIP() << "skipped: no data";
    for (const PublishedTrace& published : published_traces()) {
        const Result<NodeTrace> reference = read_node_trace(folder / published.file);
        ASSERT_TRUE(reference) << reference.error().text();
        const model::Model model = published_beam(published);
        const int node = published_node(model.body->mesh);
        EXPECT_LT((model.body->mesh.nodes.col(node) - reference->positions.col(0)).norm(), 1e-8) << "the same frame";
        const int steps = static_cast<int>(reference->times_s.size()) - 1;
        const dynamics::Trace trace = dynamics::simulate(
            model, bench_options(dynamics::Integrator::implicit_euler, published.h_s, steps, 1e-7));
        ASSERT_TRUE(trace.complete()) << trace.message;
        const double deviation = trace_deviation(trace, node, *reference);
        test::record("deviation_" + published.file, deviation);
        // With half the step its steps were accepted at four times the residual: it stops 2.2 % short of its own rest.
        EXPECT_LT(deviation, published.residual < 1e-5 ? 1e-5 : std::max(0.005, published.residual)) << published.file;
    }
}

/// Known without the data: where the published program comes to rest.
TEST(PublishedFormulation, ComesToTheSameRest) {
    for (const std::size_t which : {std::size_t{0}, std::size_t{3}}) {
        const PublishedTrace& published = published_traces()[which];
        model::Model model = published_beam(published);
        const int node = published_node(model.body->mesh);
        const Result<Eigen::Matrix3Xd> x = beam_equilibrium(model);
        ASSERT_TRUE(x) << x.error().text();
        const double dz_mm = 1e3 * ((*x)(2, node) - model.body->mesh.nodes(2, node));
        EXPECT_NEAR(dz_mm, published.rest_dz_mm, 5e-4 * std::abs(published.rest_dz_mm));
    }
}

TEST(NodeTrace, SaysWhichLineIsWrong) {
    const test::Folder folder("trace");
    folder.write("good.csv", "time,x,y,z\n0,1,2,3\n0.5,4,5,6\n");
    const Result<NodeTrace> good = read_node_trace(folder.path() / "good.csv");
    ASSERT_TRUE(good);
    EXPECT_EQ(good->times_s, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(good->positions.col(1), Eigen::Vector3d(4, 5, 6));
    for (const auto& [name, text, where] : {std::tuple{"short.csv", "time,x,y,z\n0,1,2,3\n1,2,3\n", "short.csv:3"},
                                            {"word.csv", "time,x,y,z\n0,1,2,far\n", "word.csv:2"},
                                            {"empty.csv", "time,x,y,z\n", "empty.csv"}}) {
        folder.write(name, text);
        const Result<NodeTrace> bad = read_node_trace(folder.path() / name);
        ASSERT_FALSE(bad) << name;
        EXPECT_NE(bad.error().where.find(where), std::string::npos) << bad.error().text();
    }
    EXPECT_FALSE(read_node_trace(folder.path() / "absent.csv"));
}

}  // namespace
}  // namespace myo::bench
