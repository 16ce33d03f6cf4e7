#include "measurement/trace_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::HasSubstr;

Result<Recording> read_text(const std::string& text) { return read_trace_csv(TemporaryFile(text, "trace.csv").path()); }
std::string error_of(const std::string& text) { return test::error_of_reading(read_trace_csv, text, "trace.csv"); }

const std::string header = "time_s,a_x_m,a_y_m,a_z_m\n";

TEST(TraceCsv, WrittenTracesReadBackExactly) {
    Recording original = test::random_recording(3, 50, 1, true);
    original.time_s = original.time_s.array().square() + original.time_s.array() / 3.0;
    original.labels[1] = "with, comma";
    const TemporaryFile file("", "trace.csv");
    ASSERT_TRUE(write_trace_csv(file.path(), original));
    const Result<Recording> read = read_trace_csv(file.path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, original.labels);
    EXPECT_EQ(read->time_s, original.time_s);
    EXPECT_EQ(test::largest_difference(original, *read), 0.0);
}

TEST(TraceCsv, ColumnsInAnyOrderGapsAndLineEnds) {
    const Result<Recording> read = read_text(
        "\xEF\xBB\xBFtime_s,b_z_m,a_x_m,a_y_m,a_z_m,b_x_m,b_y_m\r\n0,6,1,2,3,4,5\r\n0.005,,1,2,3,4,5\r\n0.01,6,nan,2,3,"
        "4,5\r\n\r\n  \r\n");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, (std::vector<std::string>{"b", "a"}));
    EXPECT_EQ(read->tracks[0].col(0), Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(read->tracks[1].col(0), Eigen::Vector3d(1, 2, 3));
    EXPECT_TRUE(read->tracks[0].col(1).array().isNaN().all());
    EXPECT_TRUE(read->tracks[1].col(2).array().isNaN().all());
    EXPECT_DOUBLE_EQ(read->rate_Hz, 200.0);
    EXPECT_EQ(read_text(header + "0,0,0,0\n")->tracks[0].col(0), Eigen::Vector3d(0, 0, 0));  // zero is a place here
}

TEST(TraceCsv, EveryErrorHasFileAndLine) {
    EXPECT_THAT(error_of(""), HasSubstr("trace.csv:1: is empty"));
    EXPECT_THAT(error_of("t,a_x_m,a_y_m,a_z_m\n0,1,2,3\n"), HasSubstr("trace.csv:1: the first column is 't'"));
    EXPECT_THAT(error_of("time_s,a_x_m,a_z_m\n0,1,2\n"), HasSubstr("trace.csv:1: column 'a_y_m' is missing"));
    EXPECT_THAT(error_of("time_s,a_x_m,a_y_m,a_z_m,a_y_m\n0,1,2,3,4\n"),
                HasSubstr("trace.csv:1: column 'a_y_m' appears twice"));
    EXPECT_THAT(error_of("time_s,a_x_mm,a_y_m,a_z_m\n0,1,2,3\n"), HasSubstr("trace.csv:1: column 2 is 'a_x_mm'"));
    EXPECT_THAT(error_of("time_s\n0\n"), HasSubstr("names no marker"));
    EXPECT_THAT(error_of(header), HasSubstr("no rows"));
    EXPECT_THAT(error_of(header + "0,1,2,3\n0.01,1,x,3\n"), HasSubstr("trace.csv:3: column 3 (a_y_m) is 'x'"));
    EXPECT_THAT(error_of(header + "0,1,2,3\n0.01,1,inf,3\n"), HasSubstr("trace.csv:3: column 3"));
    EXPECT_THAT(error_of(header + "0,1,2,3\n0.01,1,2\n"), HasSubstr("trace.csv:3: has 3 fields, expected 4"));
    EXPECT_THAT(error_of(header + "0,1,2,3\n\n0.01,1,2,3\n"), HasSubstr("trace.csv:3: is an empty line"));
    EXPECT_THAT(error_of(header + "0,1,2,3\n0.01,1,2,3\n0.01,1,2,3\n"),
                HasSubstr("trace.csv:4: time 0.01 s does not ascend"));
    EXPECT_THAT(error_of(header + "0.02,1,2,3\n0.01,1,2,3\n"), HasSubstr("trace.csv:3: time 0.01 s does not ascend"));
    EXPECT_THAT(error_of(header + "nan,1,2,3\n"), HasSubstr("trace.csv:2: column 1 (time_s) is 'nan'"));
    EXPECT_THAT(error_of(header + ",1,2,3\n"), HasSubstr("trace.csv:2: column 1 (time_s) is empty"));
    EXPECT_THAT(error_of(header + "0;1;2;3\n"), HasSubstr("trace.csv:2"));
}

TEST(TraceCsv, ALabelThatCannotStandInAHeaderIsRefused) {
    Recording recording = test::random_recording(1, 2, 1);
    recording.labels[0] = "two\nlines";
    const TemporaryFile file("", "trace.csv");
    EXPECT_FALSE(write_trace_csv(file.path(), recording));
}

}  // namespace
}  // namespace myo::measurement
