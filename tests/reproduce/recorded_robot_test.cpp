#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "measurement/trace_csv.hpp"
#include "reproduce/arm_static_parts.hpp"
#include "reproduce/real_robots.hpp"
#include "reproduce/reproduction.hpp"
#include "reproduce/signal_fit.hpp"
#include "support/folder.hpp"

// Recordings of robots from made files, means of their poses, and what the pages of the paper's cases say of them.

namespace myo::reproduce::recorded_robot_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;

/// A trial whose point moves along x by the time, with a marker that moves twice as far.
RobotTrial moving_trial() {
    RobotTrial trial;
    trial.time_s = Eigen::VectorXd::LinSpaced(11, 0.0, 1.0);
    trial.tip_m = Matrix3Xd::Zero(3, 11);
    trial.tip_m.row(0) = trial.time_s.transpose();
    trial.marker_m = {2.0 * trial.tip_m};
    return trial;
}

TEST(RecordedRobot, MeansIncludeBothEndsAndPassOverWhatIsHidden) {
    RobotTrial trial = moving_trial();
    EXPECT_NEAR(mean_between(trial, 0.2, 0.4)(0, 0), 0.3, 1e-12);
    EXPECT_NEAR(mean_between(trial, 0.2, 0.4)(0, 1), 0.6, 1e-12);
    EXPECT_NEAR(mean_between(trial, 0.19, 0.21)(0, 0), 0.2, 1e-12);
    trial.tip_m.col(2).setConstant(std::nan(""));
    EXPECT_NEAR(mean_between(trial, 0.15, 0.45)(0, 0), 0.35, 1e-12);
    EXPECT_TRUE(std::isnan(mean_between(trial, 0.15, 0.25)(0, 0)));
    EXPECT_TRUE(std::isnan(mean_between(trial, 2.0, 3.0)(0, 0)));
    EXPECT_NEAR(pose_at(trial, Instant::after_0_7_s)(0, 0), 0.7, 1e-12);
    EXPECT_NEAR(pose_at(trial, Instant::end)(0, 0), 0.95, 1e-12);
    EXPECT_EQ(to_string(Instant::after_0_7_s), "0.7 s");
    EXPECT_EQ(to_string(Instant::end), "end");
}

TEST(RecordedRobot, DirectionsAreAveragedAsUnitVectors) {
    const auto at = [](double degrees, double size) {
        const double angle = degrees * std::numbers::pi / 180.0;
        return Matrix3Xd(Vector3d(size * std::cos(angle), size * std::sin(angle), 0.4));
    };
    const double one = std::numbers::pi / 180.0;
    EXPECT_NEAR(bending_direction({at(30.0, 1.0)}, 1.0), 30.0 * one, 1e-12);
    // With the sign of the robot: from the opposite direction.
    EXPECT_NEAR(bending_direction({at(210.0, 1.0)}, -1.0), 30.0 * one, 1e-12);
    EXPECT_NEAR(bending_direction({at(210.0, 1.0)}), 30.0 * one, 1e-12);
    // Across half a turn, where the mean of the angles would be wrong, and whatever their sizes.
    EXPECT_NEAR(std::abs(bending_direction({at(170.0, 1.0), at(-170.0, 1.0)}, 1.0)), std::numbers::pi, 1e-12);
    EXPECT_NEAR(bending_direction({at(10.0, 5.0), at(50.0, 1e-3)}, 1.0), 30.0 * one, 1e-12);
}

/// Nominal places of the markers of the arm's sweep [m], three on the tip and four on the frame.
const std::vector<Vector3d>& nominal_m() {
    static const std::vector<Vector3d> places{
        {-9.645e-3, -26.5e-3, 0},    {-9.645e-3, 26.5e-3, 0},    {-28.2e-3, 0, 0},          {-50.5e-3, -20.5e-3, 0.102},
        {-30.5e-3, -50.5e-3, 0.102}, {-10.5e-3, 50.5e-3, 0.102}, {-50.5e-3, 23.5e-3, 0.102}};
    return places;
}

/// Camera data of an arm whose tip moves by `way` and tilts, from t = 1 s on, in a frame of the cameras.
measurement::Recording arm_recording(const Vector3d& way) {
    const char* const labels[] = {"tip_1", "tip_2", "tip_3", "frame_1", "frame_2", "frame_3", "frame_4"};
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    RandomStream random{8};
    measurement::Recording recording;
    recording.rate_Hz = 100.0;
    recording.time_s = Eigen::VectorXd::LinSpaced(301, 0.0, 3.0);
    for (std::size_t m = 0; m < nominal_m().size(); ++m) {
        Matrix3Xd track(3, 301);
        for (Eigen::Index k = 0; k < 301; ++k) {
            const double since = std::max(0.0, recording.time_s(k) - 1.0), share = 1.0 - std::exp(-since / 0.1);
            // The tilt lifts each marker by its distance from the axis.
            const Vector3d tilt(0.0, 0.0, 0.2 * nominal_m()[m].x() - 0.1 * nominal_m()[m].y());
            const Vector3d moved = m < 3 ? Vector3d(share * (way + tilt)) : Vector3d(Vector3d::Zero());
            track.col(k) = turn * (nominal_m()[m] + moved) + Vector3d(0.5, -1.0, 2.0);
            for (int a = 0; a < 3; ++a) track(a, k) += 2e-5 * random.normal();
        }
        recording.labels.emplace_back(labels[m]);
        recording.tracks.push_back(track);
    }
    return recording;
}

TEST(RecordedRobot, ASweepIsReadInItsFrameByAscendingPressure) {
    const test::Folder folder("recorded_sweep");
    ReproduceSettings settings;
    settings.data = folder.path();
    EXPECT_TRUE(read_arm_sweep(settings)->empty()) << "no folder";
    const std::filesystem::path place = folder.path() / "data/mocap/arm_pressure_sweep";
    folder.write("data/mocap/arm_pressure_sweep/notes.csv", "no pressure in its name");
    folder.write("data/mocap/arm_pressure_sweep/mbar.csv", "nor here");
    const Vector3d far(-0.02, 0.005, 0.003), near(-0.01, 0.001, 0.001);
    ASSERT_TRUE(measurement::write_trace_csv(place / "300mbar.csv", arm_recording(far)));
    ASSERT_TRUE(measurement::write_trace_csv(place / "75mbar.csv", arm_recording(near)));
    const Result<std::vector<RobotTrial>> sweep = read_arm_sweep(settings);
    ASSERT_TRUE(sweep) << sweep.error().text();
    ASSERT_EQ(sweep->size(), 2u);
    EXPECT_EQ((*sweep)[0].pressure_mbar, 75.0);
    EXPECT_EQ((*sweep)[1].pressure_mbar, 300.0);
    EXPECT_EQ((*sweep)[1].name, "300mbar");
    for (std::size_t i = 0; i < 2; ++i) {
        const RobotTrial& trial = (*sweep)[i];
        EXPECT_FALSE(trial.stepped);
        EXPECT_NEAR(trial.time_s(0), -1.0, 0.05) << "the onset";
        EXPECT_LT(trial.frame_rms_m, 1e-4);
        ASSERT_EQ(trial.marker_m.size(), 3u);
        // The centre, which is on the axis, is not lifted by the tilt; the markers are.
        const Matrix3Xd pose = mean_between(trial, 1.5, 1.9);
        const Vector3d way = i == 0 ? near : far;
        EXPECT_LT((pose.col(0) - way).norm(), 1e-4);
        EXPECT_LT((pose.col(3) - way - Vector3d(0.0, 0.0, -0.2 * 28.2e-3)).norm(), 1e-4);
        // Weights 0.76, 0.76, -0.52 of independent markers.
        EXPECT_NEAR(trial.noise_m, 1.194 * 2e-5, 1.2e-5);
        EXPECT_LT(mean_between(trial, -0.5, -0.1).norm(), 1e-4);
    }
    EXPECT_TRUE(read_arm_steps(settings)->empty());
    EXPECT_TRUE(read_fish(settings)->empty());
}

TEST(RecordedRobot, ARecordingWithoutMotionIsNamed) {
    const test::Folder folder("recorded_still");
    ReproduceSettings settings;
    settings.data = folder.path();
    measurement::Recording still = arm_recording(Vector3d::Zero());
    for (std::size_t m = 0; m < 3; ++m) still.tracks[m] = still.tracks[3];
    const std::filesystem::path file = folder.path() / "data/mocap/arm_pressure_sweep/100mbar.csv";
    ASSERT_TRUE(measurement::write_trace_csv(file, still));
    const Result<std::vector<RobotTrial>> sweep = read_arm_sweep(settings);
    ASSERT_FALSE(sweep);
    EXPECT_EQ(sweep.error().where, file.string());
}

Score score_of(const Vector3d& predicted, const Vector3d& measured, bool extrapolated = false) {
    Score score;
    score.extrapolated = extrapolated;
    score.prediction.tip_m = predicted;
    score.measured_m = measured;
    return score;
}

TEST(RecordedRobot, ErrorsOfPredictionsAreSharesOfTheWay) {
    const Score far = score_of({0.0, 0.0, 0.09}, {0.0, 0.0, 0.1}),
                off = score_of({0.03, 0.0, 0.04}, {0.03, 0.0, 0.0}, true),
                turned = score_of({0.0, 0.05, 0.01}, {0.05, 0.0, 0.01});
    EXPECT_NEAR(far.error(), 0.1, 1e-12);
    EXPECT_NEAR(off.error(), 4.0 / 3.0, 1e-12);
    EXPECT_NEAR(mean_error({far, off}), 0.5 * (0.1 + 4.0 / 3.0), 1e-12);
    EXPECT_NEAR(mean_error({far, off}, false), 0.1, 1e-12);
    EXPECT_TRUE(std::isnan(mean_error({})));
    EXPECT_TRUE(std::isnan(mean_error({off}, false)));
    // Turned about the axis, it is wrong in space and right in its own plane.
    EXPECT_GT(turned.error(), 1.0);
    EXPECT_NEAR(error_in_plane(turned), 0.0, 1e-12);
    EXPECT_NEAR(error_in_plane(far), 0.1, 1e-12);
    EXPECT_NEAR(mean_error_in_plane({far, turned, off}), 0.05, 1e-12);
    EXPECT_TRUE(std::isnan(mean_error_in_plane({off})));
}

TEST(ReproductionFiles, TablesBecomeRowsWithUnitsInTheirKeys) {
    const report::Table table{
        "", {{"model"}, {"rms", "mm"}, {"left"}}, {{"ours", 1.5}, {"theirs", std::nan(""), 2.0, "more"}}};
    EXPECT_EQ(table_json(table).dump(),
              R"([{"model":"ours","rms [mm]":1.5},{"model":"theirs","rms [mm]":null,"left":2.0}])");
    EXPECT_EQ(table_json({}).dump(), "[]");
}

TEST(ReproductionFiles, AllThatIsWrittenMayBeReplacedAndNothingElse) {
    const test::Folder folder("reproduction_files");
    const ReproductionCase* const one = find_reproduction("fish");
    ASSERT_NE(one, nullptr);
    EXPECT_EQ(find_reproduction("Fish"), nullptr);
    EXPECT_EQ(reproduction_ids().size(), reproduction_catalogue().size());
    Reproduction result;
    result.title = "Tail <1>";
    result.findings = {"it swings"};
    result.figures = {{"", {"<svg/>", "first"}}, {"trace", {"<svg/>", "second"}}};
    result.tables = {{"numbers", {{"a"}}, {{1.0}}}};
    result.values = {{"rms_m", 0.5}};
    ASSERT_TRUE(write_reproduction(folder.path(), *one, result));
    const report::Json json = *report::read_json(folder.path() / "fish.json");
    EXPECT_EQ(json.at("rms_m"), 0.5);
    EXPECT_EQ(json.at("findings").dump(), R"(["it swings"])");
    EXPECT_EQ(json.at("tables").at(0).at("rows").at(0).at("a"), 1.0);
    folder.write("arm-static.svg", "");
    folder.write("fish.txt", "");
    folder.write("fish_old.svg", "");
    std::vector<std::string> names;
    for (const std::filesystem::path& file : reproduction_files(folder.path(), *one))
        names.push_back(file.filename().string());
    std::sort(names.begin(), names.end());
    EXPECT_THAT(names, ElementsAre("fish.json", "fish.svg", "fish_old.svg", "fish_trace.svg", "report.html"));
    EXPECT_EQ(reproduction_files(folder.path() / "absent", *one).size(), 2u);
    EXPECT_THAT(report::html(reproduction_report(*one, result)), HasSubstr("Tail &lt;1&gt;"));
}

TEST(ReproductionFiles, SignalsAreSummedUpWithTheirLimits) {
    SignalFit fit;
    fit.variant.name = "ours";
    fit.times_s = Eigen::VectorXd::LinSpaced(3, 0.0, 0.2);
    fit.measured_m = fit.simulated_m = Matrix3Xd::Zero(3, 3);
    fit.measured_m(0, 2) = 0.05;
    fit.rms_m = {0.003, 0.0, 0.004};
    fit.largest_jump = 0.2;
    fit.range = 0.8;
    fit.activation = {{{-1.0, 0.0, 0.1, 5.0}, {1.0, 1.0, 1.2, 3.0}}};
    const report::Table table = signal_table("", {fit});
    const std::vector<report::Cell>& row = table.rows.at(0);
    ASSERT_EQ(row.size(), table.columns.size());
    const auto number = [&](std::size_t column) { return std::get<double>(row.at(column).content); };
    EXPECT_DOUBLE_EQ(number(2), 3.0);
    EXPECT_DOUBLE_EQ(number(4), 4.0);
    EXPECT_DOUBLE_EQ(number(5), 10.0);
    EXPECT_DOUBLE_EQ(number(7), 25.0);
    const report::Json json = signal_json({fit});
    EXPECT_EQ(json.at(0).at("way_m"), 0.05);
    EXPECT_EQ(json.at(0).at("activation").at(0).at("values").size(), 4u);
    EXPECT_THAT(signal_figure("tail", {fit}), HasSubstr("<svg"));
}

}  // namespace
}  // namespace myo::reproduce::recorded_robot_test
