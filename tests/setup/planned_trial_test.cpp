#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"
#include "support/experiment_folder.hpp"
#include "support/setup_of_folder.hpp"

// Trials of role "simulate": they have a duration in place of a recording.

namespace myo::setup {
namespace {

using experiment::Experiment;
using experiment::TrialRole;
using testing::HasSubstr;

const std::string planned_beam = R"(schema = "experiment/1"
name = "planned"
[geometry]
kind = "box"
size_m = [0.1, 0.02, 0.02]
origin_m = [0.0, 0.0, 0.0]
[clamp]
box_m = [[-1e-3, -1e-3, -1e-3], [1e-3, 0.021, 0.021]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 3e5
poissons_ratio = 0.49
density_kg_m3 = 1070
[markers.rest_m]
tip = [0.1, 0.01, 0.01]
[[trial]]
name = "release"
role = "simulate"
duration_s = 0.25
start = "straight"
)";

std::string error_of(const test::Folder& folder, const std::string& toml) {
    folder.write("experiment.toml", toml);
    const Result<Experiment> read = experiment::read_experiment(folder.path());
    return read ? "" : read.error().what;
}

TEST(PlannedTrial, RunsForItsDurationAndSeesNoMarker) {
    const test::Folder folder("planned");
    folder.write("experiment.toml", planned_beam);
    const setup::Setup setup = test::setup_of_folder(folder, {});
    ASSERT_EQ(setup.trials.size(), 1u);
    const PreparedTrial& trial = setup.trials.front();
    EXPECT_EQ(trial.role, TrialRole::simulate);
    EXPECT_DOUBLE_EQ(trial.measured.time_s(0), 0.0);
    EXPECT_DOUBLE_EQ(trial.measured.time_s(trial.measured.sample_count() - 1), 0.25);
    ASSERT_EQ(trial.measured.tracks.size(), 1u);
    EXPECT_TRUE(trial.measured.tracks[0].array().isNaN().all());
    EXPECT_GE(trial.options.end_s, 0.25);
    // Nothing was measured, so nothing is said about noise or unseen markers.
    EXPECT_THAT(setup.warnings, testing::Not(testing::Contains(HasSubstr("noise"))));
    EXPECT_THAT(setup.warnings, testing::Not(testing::Contains(HasSubstr("no marker was seen"))));
}

TEST(PlannedTrial, NeedsNoMarker) {
    const test::Folder folder("planned_bare");
    folder.write("experiment.toml",
                 testing_support::replaced(planned_beam, "[markers.rest_m]\ntip = [0.1, 0.01, 0.01]\n", ""));
    const setup::Setup setup = test::setup_of_folder(folder, {});
    EXPECT_TRUE(setup.trials.front().measured.tracks.empty());
    EXPECT_GT(mean_noise(setup), 0.0);
}

TEST(PlannedTrial, HasADurationAndNothingOfARecording) {
    const test::Folder folder("planned_errors");
    const auto with = [](const std::string& line) {
        return testing_support::replaced(planned_beam, "duration_s = 0.25", line);
    };
    EXPECT_THAT(error_of(folder, with("")), testing::StartsWith("trial[0].duration_s: "));
    EXPECT_THAT(error_of(folder, with("duration_s = 0.0")), testing::StartsWith("trial[0].duration_s: "));
    EXPECT_THAT(error_of(folder, with("duration_s = 1.0\ntrace = \"a.csv\"")), testing::StartsWith("trial[0].trace: "));
    EXPECT_THAT(error_of(folder, with("duration_s = 1.0\nend_s = 1.0")), testing::StartsWith("trial[0].end_s: "));
    const std::string pose = testing_support::replaced(planned_beam, "start = \"straight\"", "hold = true");
    EXPECT_THAT(error_of(folder, pose), testing::StartsWith("trial[0].duration_s: "));
    EXPECT_EQ(error_of(folder, testing_support::replaced(pose, "duration_s = 0.25\n", "")), "");
    // Only trials without a recording have a duration.
    folder.write("a.csv", "time_s,tip_x_m,tip_y_m,tip_z_m\n0,0.1,0.01,0.01\n");
    EXPECT_THAT(error_of(folder, testing_support::replaced(planned_beam, "role = \"simulate\"",
                                                           "role = \"fit\"\ntrace = \"a.csv\"\nformat = \"csv\"")),
                testing::StartsWith("trial[0].duration_s: "));
}

TEST(PlannedTrial, StandsBesideRecordedOnes) {
    const test::Folder folder("planned_beside");
    std::string csv = "time_s,tip_x_m,tip_y_m,tip_z_m\n";
    for (int k = 0; k < 20; ++k) csv += std::to_string(0.01 * k) + ",0.1,0.01,0.01\n";
    folder.write("a.csv", csv);
    folder.write("experiment.toml", planned_beam + R"([[trial]]
name = "measured"
role = "fit"
trace = "a.csv"
format = "csv"
start = "straight"
)");
    const setup::Setup setup = test::setup_of_folder(folder, {});
    ASSERT_EQ(setup.trials.size(), 2u);
    EXPECT_EQ(setup.trials[0].measured.sample_count(), 26);
    EXPECT_EQ(setup.trials[1].measured.sample_count(), 20);
    EXPECT_TRUE(setup.trials[1].measured.tracks[0].allFinite());
}

}  // namespace
}  // namespace myo::setup
