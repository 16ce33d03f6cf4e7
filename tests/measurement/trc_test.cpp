#include <gtest/gtest.h>

#include <cmath>

#include "measurement/test_files.hpp"
#include "measurement/trace_file.hpp"
#include "measurement/trc.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;

const std::string trc_header =
    "PathFileType\t4\t(X/Y/Z)\tbeam.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
    "200.00\t200.00\t3\t2\tmm\n"
    "Frame#\tTime\ttip left\t\t\troot\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n";
const std::string trc_rows =
    "\n"
    "1\t0.000\t100.5\t-2\t3\t10\t20\t30\n"
    "2\t0.005\t101.5\t-2\t3\t\t\t\t\n"
    "3\t0.010\t102.5\t-2\t3\t10\t20\t30\n";

/// The example with one text replaced.
std::string with(const std::string& from, const std::string& to) {
    std::string text = trc_header + trc_rows;
    return text.replace(text.find(from), from.size(), to);
}

TEST(Trc, ReadsNamesRateUnitAndGaps) {
    const TemporaryFile file(trc_header + trc_rows, "beam.trc");
    const Result<TraceSource> source = guess_trace_source(file.path());
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_EQ(source->format, "trc");
    const Result<Recording> read = read_trace(file.path(), *source);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels, (std::vector<std::string>{"tip left", "root"}));
    EXPECT_EQ(read->rate_Hz, 200.0);
    ASSERT_EQ(read->sample_count(), 3);
    EXPECT_NEAR(read->time_s(2), 0.010, 1e-15);
    EXPECT_NEAR(read->tracks[0](0, 1), 0.1015, 1e-15);
    EXPECT_NEAR(read->tracks[0](1, 1), -0.002, 1e-15);
    EXPECT_TRUE(std::isnan(read->tracks[1](0, 1)));
    EXPECT_NEAR(read->tracks[1](2, 2), 0.030, 1e-15);
}

/// What exports do with their tabs, and units of other programs.
TEST(Trc, ReadsMessyTabsAndUnits) {
    const auto read_text = [](const std::string& text) { return read_trc(TemporaryFile(text, "beam.trc").path()); };
    const std::string names_of_two = "tip left\t\t\troot\t\t\n";
    for (const std::string& text :
         {with(names_of_two, "tip left\t\t\troot\n"), with(names_of_two, "tip left\t\t\troot\t\t\t\t\t\n"),
          with(names_of_two, "tip left\troot\n"), with("\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n", ""), with("\t\t\t\t\n3", "\n3"),
          with("10\t20\t30\n2", "10\t20\t30\t\t\n2"), with("PathFileType", "\xEF\xBB\xBFPathFileType")}) {
        const Result<Recording> read = read_text(text);
        ASSERT_TRUE(read) << read.error().text() << text;
        EXPECT_EQ(read->labels, (std::vector<std::string>{"tip left", "root"}));
        EXPECT_TRUE(std::isnan(read->tracks[1](0, 1)));
        EXPECT_NEAR(read->tracks[1](2, 2), 0.030, 1e-15);
    }
    EXPECT_NEAR(read_text(with("\tmm\n", "\tdm\n"))->tracks[0](0, 0), 10.05, 1e-12);
    EXPECT_NEAR(read_text(with("\tmm\n", "\tcm\n"))->tracks[0](0, 0), 1.005, 1e-12);
    const TemporaryFile ells(with("\tmm\n", "\tell\n"), "beam.trc");
    EXPECT_NEAR(read_trc(ells.path(), {.format = "", .metres_per_unit = 1e-3})->tracks[0](0, 0), 0.1005, 1e-12);
    EXPECT_FALSE(read_text("PathFileType\t4\nA\n1\nFrame#\tTime\n"));
}

TEST(Trc, RateIsThatOfTheDataAndOfTheTimes) {
    const auto read_text = [](const std::string& text) { return read_trc(TemporaryFile(text, "beam.trc").path()); };
    EXPECT_EQ(read_text(with("200.00\t200.00", "200.00\t1000.00"))->rate_Hz, 200.0);
    const Result<Recording> other = read_text(with("200.00\t200.00", "600.00\t200.00"));
    ASSERT_TRUE(other) << other.error().text();
    EXPECT_EQ(other->rate_Hz, 200.0);
    ASSERT_EQ(other->warnings.size(), 1u);
    EXPECT_NE(other->warnings[0].find("DataRate says 600 Hz"), std::string::npos) << other->warnings[0];

    std::string text = with("0.005", "5.0");
    text.replace(text.find("0.010"), 5, "10.0");
    const Result<Recording> thousand = read_text(text);
    ASSERT_FALSE(thousand);
    EXPECT_NE(thousand.error().text().find("beam.trc:3: "), std::string::npos) << thousand.error().text();
    EXPECT_NE(thousand.error().text().find("time_unit = \"ms\""), std::string::npos) << thousand.error().text();
    const TemporaryFile file(text, "beam.trc");
    const Result<Recording> declared = read_trc(file.path(), {.format = "", .seconds_per_unit = 1e-3});
    ASSERT_TRUE(declared) << declared.error().text();
    EXPECT_NEAR(declared->time_s(2), 0.010, 1e-15);
    EXPECT_TRUE(declared->warnings.empty());
    EXPECT_EQ(read_trc(file.path(), {.format = "", .seconds_per_unit = 1.0})->warnings.size(), 1u)
        << "the user says that it is right";
}

struct Wrong {
    std::string from, to, told;
};

TEST(Trc, SaysWhatIsWrongAndWhere) {
    for (const Wrong& wrong :
         {Wrong{"\tmm\n", "\tfurlong\n", "furlong"}, Wrong{"\tUnits\n", "\tOther\n", "Units"},
          Wrong{"DataRate", "Data", "DataRate"}, Wrong{"200.00\t200", "0\t200", "DataRate"},
          Wrong{"\t3\t2\tmm", "\t4\t2\tmm", "NumFrames"}, Wrong{"\t3\t2\tmm", "\t3\t7\tmm", "NumMarkers"},
          Wrong{"root", "tip left", "twice"}, Wrong{"tip left\t\t\troot", "tip left\t\troot\t", "three columns"},
          Wrong{"Frame#", "Row", "Frame#"}, Wrong{"101.5", "x", "x"}, Wrong{"2\t0.005", "2\t0.020", "0.01"}}) {
        const TemporaryFile file(with(wrong.from, wrong.to), "beam.trc");
        const Result<Recording> read = read_trc(file.path());
        ASSERT_FALSE(read) << wrong.to;
        EXPECT_NE(read.error().text().find(wrong.told), std::string::npos) << read.error().text();
        EXPECT_NE(read.error().where.find("beam.trc:"), std::string::npos) << read.error().text();
    }
    EXPECT_FALSE(read_trc(TemporaryFile("PathFileType\t4\n", "short.trc").path()));
}

}  // namespace
}  // namespace myo::measurement
