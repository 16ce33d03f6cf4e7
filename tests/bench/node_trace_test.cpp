#include <gtest/gtest.h>

#include <string>

#include "bench/published_beam.hpp"
#include "support/folder.hpp"

namespace myo::bench::node_trace_test {
namespace {

using namespace std::string_literals;

TEST(NodeTrace, HasFourNumbersPerLine) {
    const test::Folder folder("node_trace");
    const auto read = [&](const std::string& rows) {
        folder.write("trace.csv", "time,x,y,z\n" + rows);
        return read_node_trace(folder.path() / "trace.csv");
    };
    const Result<NodeTrace> trace = read("0,1,2,3\n0.5,-1,2e-3,4\n");
    ASSERT_TRUE(trace) << trace.error().text();
    EXPECT_EQ(trace->times_s, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(trace->positions.col(1), Eigen::Vector3d(-1.0, 2e-3, 4.0));
    for (const std::string& wrong : {"0,1,2"s, "0,1,2,3,4"s, "0,1,2,x"s, "0,1,2,nan"s, ""s}) {
        const Result<NodeTrace> refused = read("0,1,2,3\n" + wrong + "\n");
        ASSERT_FALSE(refused) << wrong;
        EXPECT_NE(refused.error().text().find("trace.csv:3"), std::string::npos) << refused.error().text();
    }
    EXPECT_FALSE(read(""));
}

}  // namespace
}  // namespace myo::bench::node_trace_test
