#include "measurement/motive_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "measurement/test_files.hpp"
#include "measurement/trace_file.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::ElementsAre;
using testing::HasSubstr;

/// A rigid body with rotation, position and error, one of its own markers with quality, and two labelled markers.
const std::string motive_take =
    "Format Version,1.23,Take Name,take 1,Capture Frame Rate,240.000000,Export Frame Rate,120.000000,Length "
    "Units,Centimeters,Coordinate Space,Global\r\n"
    "\r\n"
    ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body Marker,Rigid Body Marker,Rigid Body Marker,Rigid "
    "Body "
    "Marker,Marker,Marker,Marker,Marker,Marker,Marker\r\n"
    ",Name,base,base,base,base,base:1,base:1,base:1,base:1,\"arm:tip\",\"arm:tip\",\"arm:tip\",root,root,root\r\n"
    ",ID,B,B,B,B,B1,B1,B1,B1,M1,M1,M1,M2,M2,M2\r\n"
    ",,Rotation,Position,Position,Mean Marker Error,Position,Position,Position,Marker "
    "Quality,Position,Position,Position,"
    "Position,Position,Position\r\n"
    "Frame,Time (Seconds),W,X,Y,,X,Y,Z,,X,Y,Z,X,Y,Z\r\n"
    "0,0.000000,1,9,9,0.1,8,8,8,1,10,1.5,-2,1,2,3\r\n"
    "1,0.008333,1,9,9,0.1,8,8,8,1,11,,-2,1,2,3\r\n"
    "2,0.016667,1,9,9,0.1,8,8,8,1,12,1.5,-2\r\n";

std::string motive_with(const std::string& from, const std::string& to) {
    std::string text = motive_take;
    return text.replace(text.find(from), from.size(), to);
}

Result<Recording> read_motive(const std::string& text, const TraceSource& source = {}) {
    return read_motive_csv(TemporaryFile(text, "take.csv").path(), source);
}

TEST(MotiveCsv, ReadsMarkersUnitRateAndGaps) {
    const TemporaryFile file(motive_take, "take.csv");
    const Result<TraceSource> source = guess_trace_source(file.path());
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_EQ(source->format, "motive_csv");
    const Result<Recording> read = read_trace(file.path(), *source);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(read->labels, ElementsAre("arm:tip", "root")) << "neither bodies nor what belongs to them";
    EXPECT_EQ(read->rate_Hz, 120.0) << "of the export, not of the cameras";
    ASSERT_EQ(read->sample_count(), 3);
    EXPECT_NEAR(read->time_s(2), 0.016667, 1e-12);
    EXPECT_LT((read->tracks[0].col(2) - Eigen::Vector3d(0.12, 0.015, -0.02)).norm(), 1e-12);
    EXPECT_TRUE(read->tracks[0].col(1).array().isNaN().all()) << "an empty cell";
    EXPECT_TRUE(read->tracks[1].col(2).array().isNaN().all()) << "missing cells at the end of a row";
    EXPECT_TRUE(read->warnings.empty());
}

/// Relatives of version 1.23: no rate of the export, another order of the rows, unlabelled and repeated names.
TEST(MotiveCsv, ReadsRelatives) {
    std::string text = motive_with("Export Frame Rate,120.000000,", "");
    text.replace(text.find("240.000000"), 10, "120");
    text.replace(text.find(",Type,"), 0, ",Parent,,,\r\n");
    for (int k = 0; k < 3; ++k) text.replace(text.find("\"arm:tip\""), 9, "Unlabeled 7");
    const Result<Recording> read = read_motive(text);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->labels[0], "Unlabeled 7");
    EXPECT_EQ(read->rate_Hz, 120.0);

    const Result<Recording> twice = read_motive(motive_with("root,root,root", "arm:tip,arm:tip,arm:tip"));
    ASSERT_TRUE(twice) << twice.error().text();
    EXPECT_THAT(twice->labels, ElementsAre("arm:tip", "arm:tip (2)")) << "two IDs of one name";

    std::string bodies = motive_take;
    for (std::size_t at = bodies.find(",Marker,Marker"); (at = bodies.find(",Marker", at)) != std::string::npos;
         at += 5)
        if (bodies.compare(at, 8, ",Marker ") != 0) bodies.replace(at, 7, ",Bone");
    const Result<Recording> own = read_motive(bodies);
    ASSERT_TRUE(own) << own.error().text();
    EXPECT_THAT(own->labels, ElementsAre("base:1")) << "the only markers there are";
}

TEST(MotiveCsv, TakesTheUnitFromTheKeyOnlyIfTheFileHasNone) {
    const std::string without = motive_with("Length Units,Centimeters,", "");
    EXPECT_THAT(read_motive(without).error().text(), HasSubstr("Length Units is missing"));
    EXPECT_THAT(read_motive(without).error().text(), HasSubstr("key unit"));
    const Result<Recording> declared = read_motive(without, {.format = "", .metres_per_unit = 1e-3});
    ASSERT_TRUE(declared) << declared.error().text();
    EXPECT_NEAR(declared->tracks[0](0, 0), 0.010, 1e-12);
    EXPECT_TRUE(read_motive(motive_take, {.format = "", .metres_per_unit = 1e-2}));
    EXPECT_THAT(read_motive(motive_take, {.format = "", .metres_per_unit = 1e-3}).error().text(),
                HasSubstr("take.csv:1: the trial's key unit says mm, but Length Units is 'Centimeters'"));
}

struct MotiveFault {
    std::string from, to, told;
};

TEST(MotiveCsv, SaysWhatIsWrongAndWhere) {
    for (const MotiveFault& fault :
         {MotiveFault{"Centimeters", "ells", "take.csv:1: Length Units is 'ells'"},
          MotiveFault{"120.000000", "-1", "take.csv:1: Export Frame Rate is '-1'"},
          MotiveFault{",Type,", ",Kind,", "has no row Type"},
          MotiveFault{"Frame,Time", "Row,Time", "begins with Frame"},
          MotiveFault{"Time (Seconds)", "Clock", "take.csv:7: has no column Time"},
          MotiveFault{"X,Y,Z,X,Y,Z\r", "X,Y,Z,X,Y,W\r", "take.csv:7: marker 'root' has no column Z"},
          MotiveFault{"11,,-2", "11,x,-2", "take.csv:9: column 12 (arm:tip Y) is 'x'"},
          MotiveFault{"2,0.016667", "2,0.001", "take.csv:10: time 0.001 s does not ascend"}}) {
        const Result<Recording> read = read_motive(motive_with(fault.from, fault.to));
        ASSERT_FALSE(read) << fault.to;
        EXPECT_THAT(read.error().text(), HasSubstr(fault.told));
    }
    EXPECT_FALSE(read_motive(""));
}

}  // namespace
}  // namespace myo::measurement
