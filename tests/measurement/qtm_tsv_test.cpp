#include "measurement/qtm_tsv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::HasSubstr;

Result<Recording> read_export(const std::string& text) { return read_qtm_tsv(TemporaryFile(text, "take.tsv").path()); }
std::string export_error(const std::string& text) {
    return test::error_of_reading([](const auto& path) { return read_qtm_tsv(path); }, text, "take.tsv");
}

const std::string names = "MARKER_NAMES\ta\tb\n";
const std::string counts = "NO_OF_FRAMES\t3\nNO_OF_MARKERS\t2\n";
const std::string rate = "FREQUENCY\t50\n";
const std::string rows = "1\t2\t3\t4\t5\t6\n0.000\t0.000\t0.000\t4\t5\t6\n1\t2\t3\t\tNULL\t6\n";

TEST(QtmTsv, AllColumnsAreCoordinatesWithoutAFrameLine) {
    const Result<Recording> read = read_export(rate + "SOMETHING_NEW\t1\t2\nEVENT\tkick\t3\t0.1\n" + names + counts +
                                               rows);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, (std::vector<std::string>{"a", "b"}));
    EXPECT_TRUE(read->tracks[1].col(0).isApprox(Eigen::Vector3d(4e-3, 5e-3, 6e-3), 1e-15));
    EXPECT_TRUE(read->tracks[0].col(1).array().isNaN().all());
    EXPECT_TRUE(read->tracks[1].col(2).array().isNaN().all());
    EXPECT_TRUE(read->tracks[0].col(2).allFinite());
    EXPECT_NEAR(read->time_s(2), 0.04, 1e-15);
    EXPECT_DOUBLE_EQ(read->rate_Hz, 50.0);
}

TEST(QtmTsv, FrameAndTimeColumnsAreTakenWhenTheLineIsThere) {
    const std::string content =
        "Frame\tTime\ta X\ta Y\ta Z\tb X\tb Y\tb Z\n11\t0.20\t1\t2\t3\t4\t5\t6\t\r\n12\t0.22\t1\t2\t3\t4\t5\t6\r\n";
    const Result<Recording> read = read_export("NO_OF_MARKERS\t2\r\n" + names + "NO_OF_FRAMES\t2\n" + rate + content +
                                               "\n");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_DOUBLE_EQ(read->time_s(0), 0.20);
    EXPECT_DOUBLE_EQ(read->time_s(1), 0.22);
    // An external clock gives no frequency; the times do.
    const Result<Recording> external = read_export(names + "FREQUENCY\tEXT\n" + content);
    ASSERT_TRUE(external) << external.error().text();
    EXPECT_NEAR(external->rate_Hz, 50.0, 1e-9);
}

TEST(QtmTsv, CountsAreCheckedAndErrorsHaveLineAndColumn) {
    EXPECT_EQ(export_error(names + counts + rate + rows), "no error");
    EXPECT_THAT(export_error(names + "NO_OF_FRAMES\t4\n" + rate + rows),
                HasSubstr("take.tsv:2: NO_OF_FRAMES is 4, but the file has 3 rows"));
    EXPECT_THAT(export_error(names + "NO_OF_MARKERS\t3\n" + rate + rows),
                HasSubstr("take.tsv:2: NO_OF_MARKERS is 3, but MARKER_NAMES lists 2"));
    EXPECT_THAT(export_error(names + "NO_OF_FRAMES\tmany\n" + rate + rows),
                HasSubstr("take.tsv:2: NO_OF_FRAMES is 'many'"));
    EXPECT_THAT(export_error(names + counts + rows), HasSubstr("no FREQUENCY"));
    EXPECT_THAT(export_error(rate + rows), HasSubstr("no MARKER_NAMES"));
    EXPECT_THAT(export_error("MARKER_NAMES\ta\ta\n" + rate + rows),
                HasSubstr("take.tsv:1: MARKER_NAMES holds 'a' twice"));
    EXPECT_THAT(export_error(names + rate + "1\t2\t3\t4\t5\t6\n1\t2\tx\t4\t5\t6\n"),
                HasSubstr("take.tsv:4: column 3 (a Z) is 'x'"));
    EXPECT_THAT(export_error(names + rate + "1\t2\t3\t4\t5\n"), HasSubstr("take.tsv:3: has 5 fields, expected 6"));
    EXPECT_THAT(export_error(names + rate + "Frame\tTime\n1\t0\t1\t2\t3\t4\t5\t6\n2\t0\t1\t2\t3\t4\t5\t6\n"),
                HasSubstr("take.tsv:5: time 0 s does not ascend"));
    EXPECT_THAT(export_error(names + rate), HasSubstr("no rows"));
    EXPECT_THAT(export_error(""), HasSubstr("is empty"));
}

}  // namespace
}  // namespace myo::measurement
