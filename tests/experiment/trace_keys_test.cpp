// Keys of a trial that say how its recording is read: format, unit, time_unit, axes, and labels with a subject.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// The export of a camera system that has y upwards, with subjects, and the marker of another subject.
const std::string nexus_csv =
    "Trajectories\n100\n,,fish:side,,,fish:base,,,fish:Tip - 1,,,crab:claw,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z,X,Y,Z,X,Y,Z\n"
    ",,mm,mm,mm,mm,mm,mm,mm,mm,mm,mm,mm,mm\n1,0,4000,5000,6000,7000,8000,9000,1000,2000,3000,0,0,1\n"
    "2,0,4000,5000,6000,7000,8000,9000,1000,2000,3500,0,0,1\n3,0,4000,5000,6000,7000,8000,9000,1000,2000,3500,0,0,1\n"
    "4,0,4000,5000,6000,7000,8000,9000,1000,2000,3500,0,0,1\n";

class TraceKeys : public testing::Test {
protected:
    TraceKeys() : folder_("trace_keys") {
        write_files(folder_, good_toml);
        folder_.write("nexus.csv", nexus_csv);
        folder_.write("release.csv",
                      "time_s,tip_x_m,tip_y_m,tip_z_m,side_x_m,side_y_m,side_z_m,base_x_m,base_y_m,base_z_m\n"
                      "0,1,2,3,4,5,6,7,8,9\n500,1,2,3,4,5,6,7,8,9\n1500,1,2,3,4,5,6,7,8,9\n");
    }
    Result<TrialRecording> read(Overrides overrides) const {
        Result<Experiment> experiment = read_experiment(folder_.path(), overrides);
        if (!experiment) return experiment.error();
        return read_trial(*experiment, experiment->trials[0]);
    }
    static Overrides nexus(const std::string& key = "format", const std::string& value = "vicon_csv") {
        return {{"trial[0].trace", "nexus.csv"},
                {"trial[0].start_s", "0"},
                {"trial[0].end_s", "1"},
                {"trial[0].format", "vicon_csv"},
                {"trial[0]." + key, value}};
    }

    Folder folder_;
};

TEST_F(TraceKeys, LabelsOfASubjectMatchWhereTheyAreUnique) {
    const Result<TrialRecording> found = read(nexus());
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(found->recording.labels, (std::vector<std::string>{"tip", "side", "base"}));
    EXPECT_EQ(found->recording.tracks[0].col(0), Eigen::Vector3d(1, 2, 3));
    ASSERT_EQ(found->warnings.size(), 1u);
    EXPECT_THAT(found->warnings[0], HasSubstr("\"crab:claw\"; they are ignored"));
    folder_.write("nexus.csv", replaced(nexus_csv, "crab:claw", "crab:side"));
    EXPECT_THAT(read(nexus()).error().what,
                HasSubstr("\"side\" may be \"fish:side\" or \"crab:side\" of nexus.csv; name one in markers.labels"));
}

TEST_F(TraceKeys, AxesTurnTheRecording) {
    const Result<TrialRecording> found = read(nexus("axes", "[\"x\", \"-z\", \"y\"]"));
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(found->recording.tracks[0].col(0), Eigen::Vector3d(1, -3, 2));
    EXPECT_EQ(found->recording.tracks[1].col(3), Eigen::Vector3d(4, -6, 5));
    struct Case {
        const char *axes, *told;
    };
    for (const Case& wrong : {Case{"[\"x\", \"z\", \"y\"]", "mirrors the recording"},
                              {"[\"x\", \"-x\", \"y\"]", "once"},
                              {"[\"x\", \"y\"]", "three axes"},
                              {"[\"x\", \"y\", \"up\"]", "three axes"},
                              {"[]", "once"},
                              {"\"xyz\"", "array"}}) {
        const Result<TrialRecording> refused = read(nexus("axes", wrong.axes));
        ASSERT_FALSE(refused) << wrong.axes;
        EXPECT_THAT(refused.error().what, StartsWith("trial[0].axes: "));
        EXPECT_THAT(refused.error().what, HasSubstr(wrong.told));
        EXPECT_EQ(refused.error().where, "--set");
    }
}

TEST_F(TraceKeys, UnitsOfLengthAreWordsAndNoContradiction) {
    EXPECT_TRUE(read(nexus("unit", "mm")));
    const Result<TrialRecording> other = read(nexus("unit", "cm"));
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().text(), HasSubstr("nexus.csv:5"));
    EXPECT_THAT(other.error().text(), HasSubstr("key unit says cm, but the row of units is 'mm'"));
    EXPECT_THAT(read(nexus("unit", "furlong")).error().what, StartsWith("trial[0].unit: "));
    std::string unknown = nexus_csv;
    for (std::size_t at = unknown.find("mm"); at != std::string::npos; at = unknown.find("mm")) unknown.erase(at, 2);
    folder_.write("nexus.csv", unknown);
    EXPECT_THAT(read(nexus()).error().what, HasSubstr("state the trial's key unit"));
    const Result<TrialRecording> declared = read(nexus("unit", "dm"));
    ASSERT_TRUE(declared) << declared.error().text();
    EXPECT_EQ(declared->recording.tracks[0].col(0), Eigen::Vector3d(100, 200, 300));
    EXPECT_THAT(read({{"trial[1].unit", "m"}}).error().what, HasSubstr("contradicts columns.unit"));
}

TEST_F(TraceKeys, UnitsOfTimeScaleTheColumnOfTimes) {
    for (const auto& [unit, last_s] : {std::pair{"s", 1500.0}, {"ms", 1.5}, {"us", 1.5e-3}, {"min", 90000.0}}) {
        const Result<TrialRecording> found = read({{"trial[0].time_unit", unit}, {"trial[0].start_s", "0"}});
        ASSERT_TRUE(found) << found.error().text();
        EXPECT_NEAR(found->recording.time_s(2), last_s, 1e-9 * last_s);
    }
    EXPECT_THAT(read({{"trial[0].time_unit", "h"}}).error().what, StartsWith("trial[0].time_unit: "));
    EXPECT_THAT(read(nexus("time_unit", "ms")).error().what, HasSubstr("has a rate instead of times"));
}

TEST_F(TraceKeys, TheFormatIsRecognisedByTheContent) {
    const std::string toml = replaced(replaced(good_toml, "format = \"csv\"\n", ""), "release.csv", "nexus.csv");
    folder_.write("experiment.toml", toml);
    folder_.write("step.txt", "-");
    const Result<Experiment> found = read_experiment(folder_.path());
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(found->trials[0].format, "vicon_csv");
    folder_.write("experiment.toml", good_toml);
    const Result<TrialRecording> other = read({{"trial[0].trace", "nexus.csv"}});
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().what,
                StartsWith("trial[0].format: nexus.csv is no \"csv\" file, but one of format = \"vicon_csv\""));
}

/// Exports of Motive have y upwards; nothing is turned without being asked.
TEST_F(TraceKeys, YUpwardsIsPointedOut) {
    folder_.write(
        "motive.csv",
        "Format Version,1.23,Export Frame Rate,100,Length Units,Meters\n,Type,Marker,Marker,Marker,Marker,Marker,"
        "Marker,Marker,Marker,Marker\n,Name,tip,tip,tip,side,side,side,base,base,base\n,,Position,Position,"
        "Position,Position,Position,Position,Position,Position,Position\nFrame,Time,X,Y,Z,X,Y,Z,X,Y,Z\n"
        "0,0,1,2,3,4,5,6,7,8,9\n1,0.01,1,2,3,4,5,6,7,8,9\n");
    Overrides motive{{"trial[0].trace", "motive.csv"},
                     {"trial[0].format", "motive_csv"},
                     {"trial[0].start_s", "0"},
                     {"trial[0].end_s", "1"},
                     {"registration.known", "true"}};
    const std::string known = replaced(good_toml, "known = false", "known = true");
    folder_.write("experiment.toml", replaced(known, "max_translation_m = 0.001\nmax_rotation_deg = 0.5\n", ""));
    const Result<TrialRecording> found = read(motive);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(found->recording.tracks[0].col(0), Eigen::Vector3d(1, 2, 3));
    ASSERT_EQ(found->warnings.size(), 1u);
    EXPECT_THAT(found->warnings[0], HasSubstr("axes = [\"x\", \"-z\", \"y\"]"));
    motive.emplace_back("trial[0].axes", "[\"x\", \"y\", \"z\"]");
    EXPECT_TRUE(read(motive)->warnings.empty());
}

}  // namespace
}  // namespace myo::experiment
