#include "measurement/trace_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::HasSubstr;

Result<Recording> read_text(const std::string& text) { return read_trace_csv(TemporaryFile(text, "trace.csv").path()); }
std::string error_of(const std::string& text) {
    return test::error_of_reading([](const auto& path) { return read_trace_csv(path); }, text, "trace.csv");
}

const std::string header = "time_s,a_x_m,a_y_m,a_z_m\n";

TEST(TraceCsv, WrittenTracesReadBackExactly) {
    Recording original = test::random_recording(3, 50, 1, true);
    original.time_s = original.time_s.array().square() + original.time_s.array() / 3.0;
    original.labels[1] = "with, comma";
    original.labels[2] = " \tbehind; blanks ";
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

/// Semicolons leave the comma to the numbers.
TEST(TraceCsv, DecimalCommasBetweenSemicolons) {
    for (const std::string text : {"time_s;a_x_m;a_y_m;a_z_m\n0;0,5;-1,25;3\n0,01;nan;;3\n",
                                   "time_s\ta_x_m\ta_y_m\ta_z_m\n0\t0.5\t-1,25\t3\n0,01\tnan\t\t3\n"}) {
        const Result<Recording> read = read_text(text);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->tracks[0].col(0), Eigen::Vector3d(0.5, -1.25, 3.0));
        EXPECT_EQ(read->time_s(1), 0.01);
        EXPECT_TRUE(read->tracks[0].col(1).array().isNaN().all());
    }
    EXPECT_THAT(error_of("time_s;a_x_m;a_y_m;a_z_m\n0;1.000,5;1;3\n"), HasSubstr("column 2 (a_x_m) is '1.000,5'"));
    EXPECT_THAT(error_of(header + "0,01,0,5,1,25,3,0\n"), HasSubstr("decimal mark"));
    const std::string wide = "time;" + std::string(500, 'x');
    EXPECT_LT(error_of(wide + "\n").size(), 250u) << "the line is not quoted as a whole";
}

TEST(TraceCsv, UnitsOfTheHeaderAndOfTheKeys) {
    const Result<Recording> read = read_text("time_s,a_x_mm,a_y_mm,a_z_mm\n0,120,1,2\n");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(read->tracks[0](0, 0), 0.12, 1e-15);
    EXPECT_EQ(read->metres_per_unit, 1e-3);
    const TemporaryFile metres(header + "0,1,2,3\n10,1,2,3\n", "trace.csv");
    EXPECT_THAT(read_trace_csv(metres.path(), {.format = "", .metres_per_unit = 1e-3}).error().text(),
                HasSubstr("trace.csv:1: the trial's key unit says mm, but the header is 'm'"));
    const Result<Recording> milliseconds = read_trace_csv(metres.path(), {.format = "", .seconds_per_unit = 1e-3});
    ASSERT_TRUE(milliseconds) << milliseconds.error().text();
    EXPECT_NEAR(milliseconds->time_s(1), 0.01, 1e-15);
    EXPECT_DOUBLE_EQ(milliseconds->rate_Hz, 100.0);
}

}  // namespace
}  // namespace myo::measurement
