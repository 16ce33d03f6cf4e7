#include "setup/recording_frame.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace myo::setup {
namespace {

/// Fixed markers come last in a recording and serve registration only: nothing of them stays in the trial.
TEST(RecordingFrame, KeepsWhatBelongsToTheMarkersOnTheBody) {
    experiment::Experiment experiment;
    experiment.registration.known = true;
    experiment.markers.compare = experiment::Comparison::position;
    experiment.markers.on_body = {{"tip", {0.1, 0.0, 0.0}, "tip"}};
    experiment.markers.fixed = {{"base", {-0.1, 0.0, 0.0}, "base"}};
    experiment::TrialDeclaration declaration;
    declaration.name = "swing";
    declaration.format = "csv";
    declaration.start_s = 0.0;
    experiment.trials = {declaration};
    measurement::Recording recording;
    recording.labels = {"tip", "base"};
    recording.time_s = Eigen::Vector3d(0.0, 0.01, 0.02);
    recording.rate_Hz = 100.0;
    recording.tracks = {Eigen::Matrix3Xd::Constant(3, 3, 0.1), Eigen::Matrix3Xd::Constant(3, 3, -0.1)};
    recording.residual_m = {Eigen::Vector3d::Constant(1e-4), Eigen::Vector3d::Constant(2e-4)};
    PreparedTrial trial;
    const Result<void> placed = place_recording(experiment, experiment.trials.front(), recording, trial);
    ASSERT_TRUE(placed) << placed.error().text();
    EXPECT_EQ(trial.measured.labels, std::vector<std::string>{"tip"});
    EXPECT_EQ(trial.measured.tracks.size(), 1u);
    ASSERT_EQ(trial.measured.residual_m.size(), 1u);
    EXPECT_EQ(trial.measured.residual_m[0](2), 1e-4);
    // A file without residuals has none of the markers on the body either.
    recording.residual_m.clear();
    PreparedTrial without;
    ASSERT_TRUE(place_recording(experiment, experiment.trials.front(), recording, without));
    EXPECT_TRUE(without.measured.residual_m.empty());
}

}  // namespace
}  // namespace myo::setup
