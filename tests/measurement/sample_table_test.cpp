#include "measurement/sample_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"

// Rows of a table as samples of a recording: times, units, gaps, what a row may lack, and the rate that a file states.

namespace myo::measurement::sample_table_test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

/// Two markers behind a column of times, all in SI units.
SampleTable two_markers() {
    SampleTable table;
    table.markers = {{"a", {1, 2, 3}}, {"b", {4, 5, 6}}};
    table.time_column = 0;
    table.field_count = 7;
    table.column_names = {"time", "a x", "a y", "a z", "b x", "b y", "b z"};
    return table;
}

Result<Recording> read(const std::string& text, const SampleTable& table) {
    return read_samples("take.txt", split_lines(text), table);
}

std::string error_of(const std::string& text, const SampleTable& table) {
    const Result<Recording> recording = read(text, table);
    return recording ? "read" : recording.error().text();
}

bool hidden_at(const Recording& recording, std::size_t marker, Eigen::Index t) {
    return recording.tracks[marker].col(t).array().isNaN().all();
}

TEST(SampleTable, ScalesTimesAndPlaces) {
    SampleTable table = two_markers();
    table.seconds_per_unit = 1e-3;
    table.metres_per_unit = 1e-2;
    const Result<Recording> recording = read("20,1,2,3,4,5,6\n30,-1,0,0,0,0,0\n40,1,2,3,4,5,6\n", table);
    ASSERT_TRUE(recording) << recording.error().text();
    EXPECT_EQ(recording->labels, (std::vector<std::string>{"a", "b"}));
    EXPECT_NEAR(recording->time_s(2), 0.04, 1e-17);
    EXPECT_LT((recording->tracks[0].col(0) - Vector3d(0.01, 0.02, 0.03)).norm(), 1e-17);
    EXPECT_EQ(recording->tracks[1].col(1), Vector3d::Zero()) << "a place, unless zeros are gaps";
    EXPECT_EQ(recording->metres_per_unit, 1e-2);
    EXPECT_NEAR(recording->rate_Hz, 100.0, 1e-9) << "the inverse of the steps";
    // Without a column of times the rate gives them; with both, the column does.
    table.rate_Hz = 50.0;
    EXPECT_EQ(read("20,1,2,3,4,5,6\n30,1,2,3,4,5,6\n", table)->rate_Hz, 50.0);
    table.time_column.reset();
    const Result<Recording> timed = read("20,1,2,3,4,5,6\n30,1,2,3,4,5,6\n", table);
    ASSERT_TRUE(timed);
    EXPECT_EQ(timed->time_s(0), 0.0);
    EXPECT_EQ(timed->time_s(1), 0.02);
}

/// A point that lacks a coordinate cannot be compared: it is hidden as a whole, the others are not.
TEST(SampleTable, KnowsTheMarksOfGaps) {
    SampleTable table = two_markers();
    const std::string seen = ",4,5,6\n";
    for (const char* gap : {"0,1,,3", "0,nan,2,3", "0,,,", "0,1,2,NaN"}) {
        const Result<Recording> recording = read(gap + seen, table);
        ASSERT_TRUE(recording) << recording.error().text();
        EXPECT_TRUE(hidden_at(*recording, 0, 0)) << gap;
        EXPECT_EQ(recording->tracks[1].col(0), Vector3d(4, 5, 6)) << gap;
    }
    EXPECT_THAT(error_of("0,1,NULL,3" + seen, table), HasSubstr("take.txt:1: column 3 (a y) is 'NULL'"));
    table.null_is_occluded = true;
    EXPECT_TRUE(hidden_at(*read("0,1,NULL,3" + seen, table), 0, 0));
    EXPECT_THAT(error_of("NULL,1,2,3" + seen, table), HasSubstr("column 1 (time) is 'NULL'")) << "no time";
    EXPECT_FALSE(hidden_at(*read("0,0,0,0" + seen, table), 0, 0));
    table.zero_is_occluded = true;
    EXPECT_TRUE(hidden_at(*read("0,0,-0.000,0" + seen, table), 0, 0));
    for (const char* place : {"0,0,0,1e-9", "0,1e-9,0,0"}) EXPECT_FALSE(hidden_at(*read(place + seen, table), 0, 0));
}

TEST(SampleTable, RowsMayEndEarlyOrLateWhereItIsAllowed) {
    SampleTable table = two_markers();
    const std::string whole = "0,1,2,3,4,5,6";
    EXPECT_THAT(error_of(whole + ",\n", table), HasSubstr("take.txt:1: has 8 fields, expected 7"));
    table.trailing_separator = true;
    EXPECT_EQ(error_of(whole + ",\n", table), "read");
    EXPECT_EQ(error_of(whole + "\n", table), "read") << "it may, but need not";
    EXPECT_THAT(error_of(whole + ",,\n", table), HasSubstr("has 9 fields"));
    EXPECT_THAT(error_of(whole + ",7\n", table), HasSubstr("has 8 fields"));
    table = two_markers();
    table.ragged = true;
    EXPECT_EQ(error_of(whole + ",,,\n", table), "read");
    EXPECT_THAT(error_of(whole + ",,8\n", table), HasSubstr("has 9 fields"));
    const Result<Recording> cut = read(whole + "\n1,1,2,3,4\n2,1,2\n", table);
    ASSERT_TRUE(cut) << cut.error().text();
    EXPECT_TRUE(hidden_at(*cut, 1, 1) && hidden_at(*cut, 0, 2) && hidden_at(*cut, 1, 2));
    EXPECT_FALSE(hidden_at(*cut, 0, 1));
    EXPECT_THAT(error_of(whole + "\n\n1,1,2,3,4,5,6\n", table), HasSubstr("take.txt:2: is an empty line between rows"));
}

TEST(SampleTable, CommasAsDecimalMarks) {
    SampleTable table = two_markers();
    // Each number with its own comma takes two fields.
    EXPECT_THAT(error_of("0,0,1,5,2,5,3,5,4,5,5,5,6,5\n", table), HasSubstr("decimal mark"));
    EXPECT_THAT(error_of("0,1,2,3,4,5,6,7,8,9,10\n", table), HasSubstr("decimal mark")) << "11 fields of 7";
    EXPECT_EQ(error_of("0,1,2,3,4,5,6,7,8,9\n", table), "take.txt:1: has 10 fields, expected 7");
    table.separator = ';';
    EXPECT_THAT(error_of("0;1,5;2;3;4;5;6\n", table), HasSubstr("column 2 (a x) is '1,5'"));
    table.decimal_comma = true;
    const Result<Recording> recording = read("0,5;1,5;-2,25;3.5;4;5;6\n", table);
    ASSERT_TRUE(recording) << recording.error().text();
    EXPECT_EQ(recording->tracks[0].col(0), Vector3d(1.5, -2.25, 3.5));
    EXPECT_EQ(recording->time_s(0), 0.5);
    EXPECT_THAT(error_of("0;1.000,5;2;3;4;5;6\n", table), HasSubstr("is '1.000,5'"));
}

TEST(SampleTable, SaysWhatIsWrongInWhichColumn) {
    SampleTable table = two_markers();
    table.frame_column = 6;
    EXPECT_THAT(error_of("0,1,2,3,4,5,\n", table), HasSubstr("column 7 (b z) is empty, expected a number"));
    EXPECT_THAT(error_of("0,1,2,3,4,5,nan\n", table), HasSubstr("column 7 (b z) is 'nan'")) << "a frame has a number";
    table = two_markers();
    table.column_names.clear();
    EXPECT_EQ(error_of("0,1,2,3,4,5,6\n1,1,2,3,x,5,6\n", table), "take.txt:2: column 5 is 'x', expected a number");
    EXPECT_THAT(error_of("0,1,2,3,4,5,inf\n", table), HasSubstr("column 7 is 'inf'"));
    EXPECT_EQ(error_of("", table), "take.txt: holds no rows of data");
    const std::string at_0_5 = "0.5,1,2,3,4,5,6\n";
    EXPECT_EQ(error_of(at_0_5 + at_0_5, table), "take.txt:2: time 0.5 s does not ascend from 0.5 s in the row before");
    EXPECT_THAT(error_of(at_0_5 + "0.25,1,2,3,4,5,6\n", table), HasSubstr("time 0.25 s does not ascend from 0.5 s"));
}

TEST(MedianRate, IsThatOfMostSteps) {
    EXPECT_EQ(median_rate(VectorXd()), 100.0);
    EXPECT_EQ(median_rate(VectorXd::Constant(1, 5.0)), 100.0) << "nothing can be known of one sample";
    EXPECT_EQ(median_rate(Eigen::Vector2d(0.0, 0.02)), 50.0);
    VectorXd dropped(8);
    dropped << 0.0, 0.01, 0.02, 0.03, 0.09, 0.1, 0.11, 0.2;  // frames are missing twice
    EXPECT_EQ(median_rate(dropped), 100.0) << "rounded to nine digits";
    VectorXd thirds(5);
    thirds << 0.0, 0.333333333, 0.666666667, 1.0, 1.333333333;
    EXPECT_NEAR(median_rate(thirds), 3.0, 1e-7);
}

/// A recording of this many samples at equal steps.
Recording at_steps(double step_s, Eigen::Index samples = 11) {
    Recording recording;
    recording.time_s = VectorXd::LinSpaced(samples, 0.0, step_s * static_cast<double>(samples - 1));
    return recording;
}

TEST(StatedRate, HoldsIfTheTimesAgreeWithinATenth) {
    for (const double ratio : {1.0 / 1.101, 1.0 / 1.099, 1.0, 1.099, 1.101}) {
        Recording recording = at_steps(0.01);
        const bool agrees = ratio > 1.0 / 1.1 && ratio < 1.1;
        ASSERT_TRUE(set_rate(recording, "DataRate", 100.0 * ratio, "a.trc:3", false));
        EXPECT_NEAR(recording.rate_Hz, agrees ? 100.0 * ratio : 100.0, 1e-9) << ratio;
        EXPECT_EQ(recording.warnings.empty(), agrees) << ratio;
    }
    Recording other = at_steps(0.01);
    ASSERT_TRUE(set_rate(other, "DataRate", 250.0, "a.trc:3", false));
    ASSERT_EQ(other.warnings.size(), 1u);
    EXPECT_EQ(other.warnings[0], "DataRate says 250 Hz, but the times are 0.01 s apart, which is used");
    Recording single = at_steps(0.01, 1);
    ASSERT_TRUE(set_rate(single, "DataRate", 250.0, "a.trc:3", false));
    EXPECT_EQ(single.rate_Hz, 250.0) << "one sample tells nothing against it";
}

/// Times in another unit are told by their ratio to the rate, and read as seconds if these are declared.
TEST(StatedRate, NamesTheUnitOfTheTimes) {
    for (const auto& [unit, seconds] : {std::pair{"ms", 1e-3}, {"us", 1e-6}, {"min", 60.0}}) {
        Recording recording = at_steps(0.01 / seconds);
        const Result<void> set = set_rate(recording, "FREQUENCY", 100.0, "take.tsv:2", false);
        ASSERT_FALSE(set) << unit;
        EXPECT_EQ(set.error().where, "take.tsv:2");
        EXPECT_THAT(set.error().what, HasSubstr("FREQUENCY says 100 Hz, but the times are " +
                                                format_number(0.01 / seconds) + " apart, "));
        EXPECT_THAT(set.error().what,
                    HasSubstr(std::string("as if they were in ") + unit + "; state the trial's key time_unit = \"" +
                              unit + "\", or \"s\" if they are seconds"));
        EXPECT_TRUE(set_rate(recording, "FREQUENCY", 100.0, "take.tsv:2", true)) << unit;
        EXPECT_NEAR(recording.rate_Hz / (100.0 * seconds), 1.0, 1e-8) << unit;
        EXPECT_EQ(recording.warnings.size(), 1u);
    }
}

}  // namespace
}  // namespace myo::measurement::sample_table_test
