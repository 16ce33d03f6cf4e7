#include "measurement/vicon_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measurement/test_files.hpp"
#include "measurement/trace_file.hpp"

namespace myo::measurement {
namespace {

using test::TemporaryFile;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string nexus_devices =
    "Devices\r\n1000\r\n,,Force Plate,,\r\nFrame,Sub Frame,Fx,Fy,Fz\r\n,,N,N,N\r\n1,0,1,2,3\r\n1,1,1,2,3\r\n\r\n";
const std::string nexus_trajectories =
    "Trajectories\r\n200\r\n,,arm:tip,,,arm:root,,\r\nFrame,Sub Frame,X,Y,Z,X,Y,Z\r\n,,mm,mm,mm,mm,mm,mm\r\n"
    "51,0,100.5,-2,3,10,20,30\r\n52,0,101.5,-2,3,,,\r\n54,0,102.5,-2,3\r\n";
const std::string nexus_outputs =
    "\r\nModel Outputs\r\n200\r\n,,arm:Angles,,\r\nFrame,Sub Frame,X,Y,Z\r\n,,deg,deg,deg\r\n51,0,1,2,3\r\n";

std::string nexus_with(const std::string& from, const std::string& to) {
    std::string text = nexus_devices + nexus_trajectories + nexus_outputs;
    return text.replace(text.find(from), from.size(), to);
}

Result<Recording> read_nexus(const std::string& text, const TraceSource& source = {}) {
    return read_vicon_csv(TemporaryFile(text, "nexus.csv").path(), source);
}

TEST(ViconCsv, ReadsTheTrajectoriesAmongOtherSections) {
    const TemporaryFile file(nexus_devices + nexus_trajectories + nexus_outputs, "nexus.csv");
    const Result<TraceSource> source = guess_trace_source(file.path());
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_EQ(source->format, "vicon_csv");
    const Result<Recording> read = read_trace(file.path(), *source);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(read->labels, ElementsAre("arm:tip", "arm:root"));
    EXPECT_EQ(read->rate_Hz, 200.0);
    ASSERT_EQ(read->sample_count(), 3);
    EXPECT_NEAR(read->time_s(1), 0.005, 1e-12) << "from the first frame on";
    EXPECT_NEAR(read->time_s(2), 0.015, 1e-12) << "a frame is missing";
    EXPECT_NEAR(read->tracks[0](0, 2), 0.1025, 1e-12);
    EXPECT_TRUE(read->tracks[1].col(1).array().isNaN().all());
    EXPECT_TRUE(read->tracks[1].col(2).array().isNaN().all()) << "missing cells at the end of a row";
}

/// As spreadsheets save it: lines filled up with separators, or semicolons with decimal commas.
TEST(ViconCsv, ReadsWhatSpreadsheetsMakeOfIt) {
    std::string filled = nexus_with("Trajectories\r\n200", "Trajectories,,,,,,,\r\n200,,,,,,,");
    filled.replace(filled.find("\r\n\r\nModel"), 4, "\r\n,,,,,,,\r\n");
    const Result<Recording> read = read_nexus(filled);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sample_count(), 3);

    std::string german = nexus_trajectories;
    std::replace(german.begin(), german.end(), ',', ';');
    std::replace(german.begin(), german.end(), '.', ',');
    const Result<Recording> commas = read_nexus(german);
    ASSERT_TRUE(commas) << commas.error().text();
    EXPECT_NEAR(commas->tracks[0](0, 0), 0.1005, 1e-12);
}

TEST(ViconCsv, SkipsVelocitiesBesideTheCoordinates) {
    const Result<Recording> read = read_nexus(
        "Trajectories\n100\n,,tip,,,,\nFrame,Sub Frame,X,Y,Z,X',Y'\n,,mm,mm,mm,mm/s,mm/s\n1,0,1,2,3,40,50\n");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LT((read->tracks[0].col(0) - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-15);
}

struct NexusFault {
    std::string from, to, told;
};

TEST(ViconCsv, SaysWhatIsWrongAndWhere) {
    for (const NexusFault& fault :
         {NexusFault{"Trajectories", "Trajectory", "no section Trajectories"},
          NexusFault{"\r\n200\r\n", "\r\n0\r\n", "nexus.csv:10: the rate is '0'"},
          NexusFault{",,arm:tip,,,arm:root,,", ",,,,,,,", "nexus.csv:11: names no marker"},
          NexusFault{"Frame,Sub Frame,X,Y,Z,X,Y,Z", "Row,Sub Frame,X,Y,Z,X,Y,Z", "nexus.csv:12: the columns do not"},
          NexusFault{"Sub Frame,X,Y,Z,X,Y,Z", "Sub Frame,X,Y,Z,X,Y,W",
                     "nexus.csv:11: marker 'arm:root' has no column Z"},
          NexusFault{"mm,mm,mm,mm,mm,mm", "mm,mm,mm,cm,cm,cm", "nexus.csv:13: has coordinates in 'mm' and in 'cm'"},
          NexusFault{"mm,mm,mm,mm,mm,mm", "el,el,el,el,el,el", "nexus.csv:13: the row of units is 'el'"},
          NexusFault{"101.5", "x", "nexus.csv:15: column 3 (arm:tip X) is 'x'"},
          NexusFault{"52,0", "51,0", "nexus.csv:15: time"}}) {
        const Result<Recording> read = read_nexus(nexus_with(fault.from, fault.to));
        ASSERT_FALSE(read) << fault.to;
        EXPECT_THAT(read.error().text(), HasSubstr(fault.told));
    }
    EXPECT_THAT(read_nexus(nexus_trajectories, {.format = "", .metres_per_unit = 1.0}).error().text(),
                HasSubstr("key unit says m, but the row of units is 'mm'"));
    EXPECT_THAT(read_nexus("Trajectories\n100\n").error().text(), HasSubstr("ends within the header"));
}

}  // namespace
}  // namespace myo::measurement
