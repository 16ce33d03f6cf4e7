#include "measurement/actuation_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::HasSubstr;

std::string actuation_error(const std::string& text) {
    return test::error_of_reading(read_actuation_csv, text, "act.csv");
}

TEST(ActuationCsv, RoundTrip) {
    ActuationTable table;
    table.muscles = {"left", "right"};
    table.time_s = Eigen::Vector3d(0.0, 0.1, 1.0 / 3.0);
    table.values = Eigen::MatrixXd::Random(2, 3);
    const TemporaryFile file("", "act.csv");
    ASSERT_TRUE(write_actuation_csv(file.path(), table));
    const Result<ActuationTable> read = read_actuation_csv(file.path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->muscles, table.muscles);
    EXPECT_EQ(read->time_s, table.time_s);
    EXPECT_EQ(read->values, table.values);
}

TEST(ActuationCsv, AClosingRowThatGoesBackAndSaysNothingNewIsLeftOut) {
    const std::string text = "time_s,m\n0,1\n1.9,0.9\n2.3,1\n";
    const Result<ActuationTable> read = read_actuation_csv(TemporaryFile(text + "2,1\n", "act.csv").path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->time_s, Eigen::Vector3d(0.0, 1.9, 2.3));
    EXPECT_EQ(read->values.cols(), 3);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_THAT(read->warnings[0], HasSubstr("act.csv:5"));
    EXPECT_THAT(actuation_error(text + "2,0.9\n"), HasSubstr("act.csv:5: time 2 s does not ascend"));
}

TEST(ActuationCsv, TwoRowsOfOneTimeAreAJump) {
    const Result<ActuationTable> read = read_actuation_csv(
        TemporaryFile("time_s,m\n0,1\n0.3,1\n0.3,0.8\n1,0.8\n", "act.csv").path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->time_s, Eigen::Vector4d(0.0, 0.3, 0.3, 1.0));
    EXPECT_TRUE(read->warnings.empty());
    EXPECT_THAT(actuation_error("time_s,m\n0,1\n0.3,1\n0.3,0.8\n0.3,0.7\n"),
                HasSubstr("act.csv:5: is the third row of time 0.3 s"));
}

TEST(ActuationCsv, EveryErrorHasFileAndLine) {
    EXPECT_EQ(actuation_error("\xEF\xBB\xBFtime_s,m\r\n0,1\r\n0.1,0.9\r\n\r\n"), "no error");
    EXPECT_THAT(actuation_error("time_s\n0\n"), HasSubstr("act.csv:1: names no muscle"));
    EXPECT_THAT(actuation_error("time,m\n0,1\n"), HasSubstr("act.csv:1: the first column is 'time'"));
    EXPECT_THAT(actuation_error("time_s,m,m\n0,1,1\n"), HasSubstr("act.csv:1: column 'm' appears twice"));
    EXPECT_THAT(actuation_error("time_s,m,\n0,1,1\n"), HasSubstr("act.csv:1: column 3 has no name"));
    EXPECT_THAT(actuation_error("time_s,m\n"), HasSubstr("no rows"));
    EXPECT_THAT(actuation_error("time_s,m\n0,nan\n"), HasSubstr("act.csv:2: column 2 (m) is 'nan'"));
    EXPECT_THAT(actuation_error("time_s,m\n0,\n"), HasSubstr("act.csv:2: column 2 (m) is ''"));
    EXPECT_THAT(actuation_error("time_s,m\n0,1,2\n"), HasSubstr("act.csv:2: has 3 fields, expected 2"));
    EXPECT_THAT(actuation_error("time_s,m\n0,1\n-1,1\n0,1\n"), HasSubstr("act.csv:3: time -1 s does not ascend"));
}

}  // namespace
}  // namespace myo::measurement
