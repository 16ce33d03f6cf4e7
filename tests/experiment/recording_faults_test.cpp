#include "experiment/recording_faults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "measurement/swinging_markers.hpp"
#include "measurement/trace_csv.hpp"
#include "support/folder.hpp"

namespace myo::experiment {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using testing::HasSubstr;

const std::vector<std::string> five_names{"m0", "m1", "m2", "m3", "m4"};

/// Five markers of a swinging beam, in a file rounded to a micrometre.
class RecordingFaults : public testing::Test {
protected:
    RecordingFaults() : folder_("recording_faults"), truth_(test::swinging_markers(1e-4, 1)) {
        for (Matrix3Xd& track : truth_) track = (track / 1e-6).array().round() * 1e-6;
        experiment_.markers.noise_m = 1e-4;
        for (const std::string& name : five_names)
            experiment_.markers.on_body.push_back({name, Eigen::Vector3d::Zero(), name});
        TrialDeclaration trial;
        trial.name = "swing";
        trial.trace = folder_.path() / "swing.csv";
        experiment_.trials = {trial};
    }

    /// What is read of these tracks.
    TrialRecording read(const std::vector<Matrix3Xd>& tracks) const {
        measurement::Recording recording;
        recording.labels = five_names;
        recording.tracks = tracks;
        recording.time_s = Eigen::VectorXd::LinSpaced(120, 0.0, 1.19);
        EXPECT_TRUE(measurement::write_trace_csv(experiment_.trials[0].trace, recording));
        const Result<TrialRecording> result = read_trial(experiment_, experiment_.trials[0]);
        EXPECT_TRUE(result) << result.error().text();
        return *result;
    }

    /// All true samples are there, and those of a marker in [first, end) are hidden.
    void expect_hidden(const TrialRecording& read, std::size_t marker, Index first, Index end) const {
        for (std::size_t m = 0; m < five_names.size(); ++m)
            for (Index t = 0; t < 120; ++t) {
                const bool hidden = m == marker && t >= first && t < end;
                if (hidden)
                    EXPECT_TRUE(read.recording.tracks[m].col(t).array().isNaN().all()) << m << " " << t;
                else
                    EXPECT_LT((read.recording.tracks[m].col(t) - truth_[m].col(t)).norm(), 1e-12) << m << " " << t;
            }
    }

    test::Folder folder_;
    std::vector<Matrix3Xd> truth_;
    Experiment experiment_;
};

TEST_F(RecordingFaults, NothingIsChangedWithoutOne) {
    const TrialRecording found = read(truth_);
    EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
    expect_hidden(found, 0, 0, 0);
}

TEST_F(RecordingFaults, AFrozenMarkerIsHiddenAndNamed) {
    std::vector<Matrix3Xd> tracks = truth_;
    for (Index t = 40; t < 80; ++t) tracks[1].col(t) = tracks[1].col(39);
    const TrialRecording found = read(tracks);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_THAT(found.warnings[0], HasSubstr("trial[0].trace: marker \"m1\" repeats one position exactly from 0.4 s to "
                                             "0.79 s while others move; these 40 samples are left out"));
    expect_hidden(found, 1, 40, 80);
}

TEST_F(RecordingFaults, ZerosBehindAGapAreAGap) {
    std::vector<Matrix3Xd> tracks = truth_;
    test::hide(tracks[3], 40, 45);
    tracks[3].middleCols(45, 20).setZero();
    const TrialRecording found = read(tracks);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_THAT(found.warnings[0], HasSubstr("\"m3\" is at exactly 0, 0, 0 in 20 samples from 0.45 s to 0.64 s"));
    expect_hidden(found, 3, 40, 65);
}

/// Behind one hidden sample the same stretch used to survive at the cost of three true samples.
TEST_F(RecordingFaults, AFalseStretchBesideAGapIsHiddenAndNoTrueSample) {
    for (const Index hidden : {1, 2, 7, 15}) {
        std::vector<Matrix3Xd> tracks = truth_;
        tracks[4].middleCols(50, 20).colwise() += Eigen::Vector3d(0.03, 0.03, 0.0);
        test::hide(tracks[4], 50 - hidden, 50);
        const TrialRecording found = read(tracks);
        ASSERT_EQ(found.warnings.size(), 1u) << hidden;
        EXPECT_THAT(found.warnings[0], HasSubstr("\"m4\" is up to 42."));
        EXPECT_THAT(found.warnings[0], HasSubstr("from 0.5 s to 0.69 s, beside a gap; these 20 samples are left out"));
        expect_hidden(found, 4, 50 - hidden, 70);
    }
}

TEST_F(RecordingFaults, NamesExchangedInACommonGapAreRestored) {
    std::vector<Matrix3Xd> tracks = truth_;
    for (const std::size_t m : {3u, 4u}) test::hide(truth_[m], 40, 45);
    tracks = truth_;
    tracks[3].rightCols(75) = truth_[4].rightCols(75);
    tracks[4].rightCols(75) = truth_[3].rightCols(75);
    const TrialRecording found = read(tracks);
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_THAT(found.warnings[0],
                HasSubstr("markers \"m3\", \"m4\" have exchanged names from 0.45 s on, after a gap of "
                          "both, which is corrected"));
    for (const std::size_t m : {3u, 4u})
        EXPECT_LT((found.recording.tracks[m].rightCols(75) - truth_[m].rightCols(75)).norm(), 1e-12);
}

}  // namespace
}  // namespace myo::experiment
