#include "experiment/read_trial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "experiment/read_experiment.hpp"
#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"
#include "support/shared_data.hpp"

namespace myo::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;

// base (fixed), side and "Tip - 1" in another order than declared; the fixed marker is seen in one of four samples.
const std::string release_csv =
    "time_s,base_x_m,base_y_m,base_z_m,Tip - 1_x_m,Tip - 1_y_m,Tip - 1_z_m,side_x_m,side_y_m,side_z_m\n"
    "0.00,7,8,9,1,2,3,4,5,6\n"
    "0.50,nan,nan,nan,1,2,3,4,5,6\n"
    "1.00,,,,1,2,3,4,5,6\n"
    "1.50,nan,nan,nan,1,2,2.5,4,5,6\n";
const std::string
    step_txt = "4000;5000;6000;7000;8000;9000;1000;2000;3000\n4000;5000;6000;7000;8000;9000;1000;2000;3500\n";
const std::string check_tsv =
    "NO_OF_FRAMES\t2\nNO_OF_MARKERS\t3\nFREQUENCY\t100\nMARKER_NAMES\ttip\tside\tbase\n"
    "1000\t2000\t3000\t4000\t5000\t6000\t7000\t8000\t9000\n1000\t2000\t3500\t0.000\t0.000\t0.000\t7000\t8000\t9000\n";
const std::string signal_csv = "time_s,left\n0,1\n0.5,0.8\n";

class ReadTrial : public testing::Test {
protected:
    ReadTrial() : folder_("read_trial") {
        write_files(folder_, good_toml);
        folder_.write("release.csv", release_csv);
        folder_.write("step.txt", step_txt);
        folder_.write("check.tsv", check_tsv);
        folder_.write("signal.csv", signal_csv);
    }
    Experiment experiment(const std::vector<std::pair<std::string, std::string>>& overrides = {}) const {
        Result<Experiment> read = read_experiment(folder_.path(), overrides);
        EXPECT_TRUE(read) << read.error().text();
        return *read;
    }
    std::string place(const std::string& part) const {
        return (folder_.path() / "experiment.toml").string() + ":" + std::to_string(line_of(good_toml, part));
    }

    Folder folder_;
};

/// A reflection taken for the marker in one sample is as good as none seen.
TEST_F(ReadTrial, LeavesOutASampleThatStandsOutAndSaysSo) {
    std::string csv = release_csv.substr(0, release_csv.find('\n') + 1);
    for (int k = 0; k < 20; ++k)
        csv += std::to_string(0.5 * k) + ",7,8,9,1,2," +
               (k == 9 ? "3.02" : std::to_string(3.0 + 1e-4 * (k % 2) + 1e-3 * k * k)) + ",4,5,6\n";
    folder_.write("release.csv", csv);
    const Experiment e = experiment();
    const Result<TrialRecording> read = read_trial(e, e.trials.front());
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_THAT(read->warnings[0], HasSubstr("\"tip\" stands out from its own motion by up to 61"));
    EXPECT_THAT(read->warnings[0], HasSubstr("1 sample, which is left out, the first at 4.5 s"));
    for (Eigen::Index t = 0; t < 20; ++t) EXPECT_EQ(read->recording.tracks[0].col(t).allFinite(), t != 9) << t;
}

/// A reflection followed for longer, while the others go on, tells nothing either.
TEST_F(ReadTrial, LeavesOutWhereAMarkerJumpsAwayAndBackAndSaysSo) {
    std::string csv = release_csv.substr(0, release_csv.find('\n') + 1);
    for (int k = 0; k < 30; ++k) {
        const std::string still = std::to_string(1e-4 * (k % 2));
        csv += std::to_string(0.5 * k) + "," + still + ",8,9,1,2," + (k >= 12 && k < 18 ? "0.02" : still) + ",4," +
               still + ",6\n";
    }
    folder_.write("release.csv", csv);
    const Experiment e = experiment();
    const Result<TrialRecording> read = read_trial(e, e.trials.front());
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_THAT(read->warnings[0],
                HasSubstr("\"tip\" jumps by up to 20.1 mm and back; 6 samples between are left out, the first at 6 s"));
    for (Eigen::Index t = 0; t < 30; ++t)
        EXPECT_EQ(read->recording.tracks[0].col(t).allFinite(), t < 12 || t >= 18) << t;
}

/// Names that were borne by another for a while are given back.
TEST_F(ReadTrial, PutsExchangedMarkersBackAndSaysSo) {
    std::string csv = release_csv.substr(0, release_csv.find('\n') + 1);
    for (int k = 0; k < 20; ++k)
        csv += std::to_string(0.5 * k) + ",7,8,9," + (k >= 8 && k < 13 ? "4,5,6,1,2,3\n" : "1,2,3,4,5,6\n");
    folder_.write("release.csv", csv);
    const Experiment e = experiment();
    const Result<TrialRecording> read = read_trial(e, e.trials.front());
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_THAT(read->warnings[0],
                HasSubstr("markers \"tip\", \"side\" have exchanged names from 4 s to 6 s, which is corrected"));
    for (const Eigen::Matrix3Xd& track : read->recording.tracks)
        EXPECT_EQ((track.colwise() - track.col(0)).norm(), 0.0);
}

TEST_F(ReadTrial, PutsTracksUnderDeclaredNamesAndOrder) {
    const Experiment e = experiment();
    for (const TrialDeclaration& trial : e.trials) {
        const Result<measurement::Recording> read = read_trial_recording(e, trial);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_THAT(read->labels, ElementsAre("tip", "side", "base")) << trial.name;
        EXPECT_EQ(read->tracks[0].col(0), Eigen::Vector3d(1, 2, 3)) << trial.name;
        EXPECT_EQ(read->tracks[1].col(0), Eigen::Vector3d(4, 5, 6)) << trial.name;
        EXPECT_EQ(read->tracks[2].col(0), Eigen::Vector3d(7, 8, 9)) << trial.name;
    }
    EXPECT_DOUBLE_EQ(read_trial_recording(e, e.trials[1])->time_s[1], 0.02) << "columns: 50 Hz";
    EXPECT_EQ(read_trial_recording(e, e.trials[0])->time_s[0], 0.0) << "times stay those of the file";
    EXPECT_TRUE(std::isnan(read_trial_recording(e, e.trials[2])->tracks[1](0, 1)));
}

TEST_F(ReadTrial, WarnsOfAMarkerSeenLessThanHalfTheTime) {
    const Experiment e = experiment();
    const Result<TrialRecording> read = read_trial(e, e.trials[0]);
    ASSERT_TRUE(read);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_THAT(read->warnings[0], HasSubstr("\"base\" is occluded in 3 of 4"));
    EXPECT_TRUE(read_trial(e, e.trials[2])->warnings.empty()) << "half is not over half";
}

TEST_F(ReadTrial, MissingAndUndeclaredMarkersAreErrors) {
    const Experiment e = experiment();
    folder_.write("release.csv",
                  replaced(replaced(replaced(release_csv, "Tip - 1_x", "Tip - 2_x"), "Tip - 1_y", "Tip - 2_y"),
                           "Tip - 1_z", "Tip - 2_z"));
    const Result<TrialRecording> missing = read_trial(e, e.trials[0]);
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().what, StartsWith("trial[0].trace: "));
    EXPECT_THAT(missing.error().what, HasSubstr("\"Tip - 1\" (the label of tip)"));
    EXPECT_EQ(missing.error().where, place("trace = \"release.csv\""));

    folder_.write("check.tsv",
                  "NO_OF_FRAMES\t1\nNO_OF_MARKERS\t4\nFREQUENCY\t100\nMARKER_NAMES\ttip\tside\tbase\tghost\n"
                  "1\t2\t3\t4\t5\t6\t7\t8\t9\t1\t1\t1\n");
    const Result<TrialRecording> undeclared = read_trial(e, e.trials[2]);
    ASSERT_FALSE(undeclared);
    EXPECT_THAT(undeclared.error().what, HasSubstr("\"ghost\""));
    EXPECT_EQ(undeclared.error().where, place("trace = \"check.tsv\""));
}

TEST_F(ReadTrial, ErrorsOfTheReadersCarryKeyAndLineOfTheTrace) {
    const Experiment e = experiment();
    folder_.write("release.csv", replaced(release_csv, "1.00,,,,1", "1.00,,,,one"));
    const Result<TrialRecording> words = read_trial(e, e.trials[0]);
    ASSERT_FALSE(words);
    EXPECT_THAT(words.error().what, StartsWith("trial[0].trace: "));
    EXPECT_THAT(words.error().where, HasSubstr("release.csv:4"));
    folder_.write("release.csv", replaced(release_csv, "1.00,", "0.25,"));
    EXPECT_FALSE(read_trial(e, e.trials[0])) << "descending times";
    folder_.write("release.csv", "");
    EXPECT_FALSE(read_trial(e, e.trials[0]));
}

TEST_F(ReadTrial, StartAndEndMustLieInTheRecording) {
    const Experiment late = experiment({{"trial[0].start_s", "1.5"}, {"trial[0].end_s", "9"}});
    const Result<TrialRecording> read = read_trial(late, late.trials[0]);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, StartsWith("trial[0].start_s: "));
    EXPECT_EQ(read.error().where, "--set");
    const Experiment early = experiment({{"trial[0].start_s", "-2"}, {"trial[0].end_s", "-1"}});
    EXPECT_FALSE(read_trial(early, early.trials[0]));
}

TEST_F(ReadTrial, ActuationHasARowForEveryMuscle) {
    const Experiment e = experiment();
    const Result<measurement::ActuationTable> read = read_trial_actuation(e, e.trials[0]);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(read->muscles, ElementsAre("left", "right"));
    EXPECT_EQ(read->time_s, Eigen::Vector2d(0, 0.5));
    EXPECT_NEAR(read->values(0, 1), 0.8, 1e-15);
    EXPECT_NEAR(read->values(1, 1), 1.1, 1e-15) << "a - 1 of the follower is -0.5 times that of the leader";
    EXPECT_EQ(read->values.col(0), Eigen::Vector2d(1, 1));

    const Result<measurement::ActuationTable> none = read_trial_actuation(e, e.trials[1]);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->values, Eigen::MatrixXd::Ones(2, 1)) << "no file: passive";
}

/// A trial that is tried has the signal in memory and no file yet.
TEST_F(ReadTrial, ATriedSignalCountsAsItsFileWould) {
    Experiment e = experiment();
    const Result<measurement::ActuationTable> recorded = measurement::read_actuation_csv(*e.trials[0].actuation),
                                              file = read_trial_actuation(e, e.trials[0]);
    ASSERT_TRUE(recorded);
    ASSERT_TRUE(file) << file.error().text();
    e.trials[0].actuation.reset();
    e.trials[0].tried_actuation = *recorded;
    const Result<measurement::ActuationTable> tried = read_trial_actuation(e, e.trials[0]);
    ASSERT_TRUE(tried) << tried.error().text();
    EXPECT_EQ(tried->time_s, file->time_s);
    EXPECT_EQ(tried->values, file->values);
    e.trials[0].tried_actuation->muscles[0] = "lift";
    EXPECT_THAT(read_trial_actuation(e, e.trials[0]).error().what, HasSubstr("no declared muscle"));
}

TEST_F(ReadTrial, WarningsOfTheSignalFileArePassedOn) {
    folder_.write("signal.csv", signal_csv + "0.2,0.8\n");
    const Experiment e = experiment();
    const Result<measurement::ActuationTable> read = read_trial_actuation(e, e.trials[0]);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_THAT(read->warnings[0], StartsWith("trial[0].actuation: "));
}

TEST_F(ReadTrial, LeadersOfChainsMultiply) {
    const Experiment e = experiment(
        {{"muscle[2]",
          "{name='third', box_m=[[0.01,0,0],[0.02,0.01,0.01]], fibre=[1,0,0], stiffness_Pa=1, "
          "follows={muscle='right', ratio=4}}"}});
    const std::vector<MuscleLeader> leaders = muscle_leaders(e);
    EXPECT_EQ(leaders[0].leader, 0u);
    EXPECT_EQ(leaders[2].leader, 0u);
    EXPECT_EQ(leaders[2].factor, -2.0);
    const Result<measurement::ActuationTable> read = read_trial_actuation(e, e.trials[0]);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(read->values(2, 1), 1.4, 1e-15);
}

TEST_F(ReadTrial, ActuationColumnsMustBeMusclesThatMove) {
    struct Case {
        const char* content;
        const char* word;
    };
    const Experiment e = experiment();
    for (const Case& c :
         {Case{"time_s,left,right\n0,1,1\n", "follows"}, Case{"time_s,lift\n0,1\n", "no declared muscle"}}) {
        folder_.write("signal.csv", c.content);
        const Result<measurement::ActuationTable> read = read_trial_actuation(e, e.trials[0]);
        ASSERT_FALSE(read);
        EXPECT_THAT(read.error().what, StartsWith("trial[0].actuation: "));
        EXPECT_THAT(read.error().what, HasSubstr(c.word));
        EXPECT_EQ(read.error().where, place("actuation = \"signal.csv\""));
    }
    folder_.write("signal.csv", signal_csv);
    const Experiment both = experiment({{"trial[0].actuation_step.left", "0.5"}});
    EXPECT_THAT(read_trial_actuation(both, both.trials[0]).error().what, HasSubstr("actuation_step as well"));
    const Experiment more = experiment(
        {{"muscle[2]", "{name='third', box_m=[[0.01,0,0],[0.02,0.01,0.01]], fibre=[1,0,0], stiffness_Pa=1}"}});
    EXPECT_THAT(read_trial_actuation(more, more.trials[0]).error().what, HasSubstr("no column \"third\""));
}

TEST(ReadTrialOfSharedExamples, EveryTraceAndSignalIsRead) {
    const std::vector<std::filesystem::path> folders = test::shared_experiments();
    if (folders.empty()) GTEST_SKIP() << "skipped: no data";
    int traces = 0;
    for (const std::filesystem::path& folder : folders) {
        const Result<Experiment> e = read_experiment(folder);
        ASSERT_TRUE(e) << e.error().text();
        for (const TrialDeclaration& trial : e->trials) {
            const Result<TrialRecording> read = read_trial(*e, trial);
            ASSERT_TRUE(read) << read.error().text();
            EXPECT_EQ(read->recording.labels.size(), e->markers.on_body.size() + e->markers.fixed.size());
            EXPECT_GT(read->recording.sample_count(), 100);
            EXPECT_NEAR(read->recording.rate_Hz, 100.0, 0.1);
            const Result<measurement::ActuationTable> signals = read_trial_actuation(*e, trial);
            ASSERT_TRUE(signals) << signals.error().text();
            EXPECT_EQ(signals->values.rows(), static_cast<Eigen::Index>(e->muscles.size()));
            ++traces;
        }
    }
    EXPECT_GT(traces, 0);
}

TEST(ReadTrialOfSharedExamples, BothFormsOfOneTraceAgree) {
    const std::filesystem::path folder = test::shared_data("experiments/example_none");
    if (folder.empty()) GTEST_SKIP() << "skipped: no data";
    const Result<Experiment> csv = read_experiment(folder);
    const Result<Experiment> tsv = read_experiment(
        folder, {{"trial[0].trace", "gravity_release.tsv"}, {"trial[0].format", "qtm_tsv"}});
    ASSERT_TRUE(csv && tsv);
    const Result<measurement::Recording> a = read_trial_recording(*csv, csv->trials[0]);
    const Result<measurement::Recording> b = read_trial_recording(*tsv, tsv->trials[0]);
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->sample_count(), b->sample_count());
    for (std::size_t i = 0; i < a->tracks.size(); ++i) {
        const Eigen::ArrayXXd difference = (a->tracks[i] - b->tracks[i]).array();
        EXPECT_LT(difference.isNaN().select(0.0, difference.abs()).maxCoeff(), 2e-6) << a->labels[i];
    }
}

}  // namespace
}  // namespace myo::experiment
