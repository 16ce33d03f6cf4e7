#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "check/checks.hpp"
#include "check/recorded_swing.hpp"
#include "model/model.hpp"
#include "model/mount_motion.hpp"
#include "support/not_finite.hpp"
#include "support/swung_beam.hpp"

namespace myo::check::swings_and_cells_test {
namespace {

using test::nan;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Reversals, AreExtremesWithAReturnOfMoreThanTheLeast) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(5, 0.0, 4.0);
    const Eigen::VectorXd zigzag{{0.0, 1.0, 0.0, 1.0, 0.0}};
    EXPECT_THAT(turning_times(t, zigzag, 0.99), ElementsAre(1.0, 2.0, 3.0)) << "not the start, not the end";
    EXPECT_THAT(turning_times(t, -zigzag, 0.99), ElementsAre(1.0, 2.0, 3.0));
    EXPECT_THAT(turning_times(t, zigzag.array() + 100.0, 0.99), ElementsAre(1.0, 2.0, 3.0));
    EXPECT_THAT(turning_times(t, zigzag, 1.0), IsEmpty());
    EXPECT_THAT(turning_times(t, t, 0.1), IsEmpty());
    EXPECT_THAT(turning_times({}, {}, 0.1), IsEmpty());
    // A ripple below the least neither makes a reversal nor hides one.
    EXPECT_THAT(turning_times(t, Eigen::VectorXd{{0.0, 0.9, 0.8, 1.0, 0.0}}, 0.5), ElementsAre(3.0));
    // Samples that were not seen are skipped, at the start as well.
    EXPECT_THAT(turning_times(t, Eigen::VectorXd{{nan, 0.0, 1.0, nan, 0.0}}, 0.5), ElementsAre(2.0));
    EXPECT_THAT(turning_times(t, Eigen::VectorXd::Constant(5, nan), 0.5), IsEmpty());
}

/// One marker that swings along z with 2 Hz and 1 mm to both sides, every 10 ms for 1.1 s.
setup::PreparedTrial swinging() {
    setup::PreparedTrial trial;
    trial.measured.time_s = Eigen::VectorXd::LinSpaced(111, 0.0, 1.1);
    Eigen::Matrix3Xd track = Eigen::Matrix3Xd::Zero(3, 111);
    track.row(2) = 1e-3 * (4.0 * std::numbers::pi * trial.measured.time_s.transpose().array()).cos();
    trial.measured.tracks = {track};
    return trial;
}

TEST(RecordedSwings, HaveTheFrequencyOfTheirHalves) {
    const RecordedSwing swing = recorded_swing(swinging(), 0.0, 1e-5);
    EXPECT_EQ(swing.turns, 4) << "at every quarter of a second";
    EXPECT_NEAR(swing.frequency_Hz, 2.0, 1e-9);
    // One long half: the median does not see it.
    setup::PreparedTrial trial = swinging();
    trial.measured.time_s.tail(30).array() += 0.5;
    EXPECT_NEAR(recorded_swing(trial, 0.0, 1e-5).frequency_Hz, 2.0, 1e-9);
}

TEST(RecordedSwings, ExceedTenTimesTheNoiseAndATwentiethOfTheMotion) {
    // A half swing is 2 mm.
    EXPECT_GE(recorded_swing(swinging(), 0.0, 0.19e-3).turns, 3);
    EXPECT_EQ(recorded_swing(swinging(), 0.0, 0.21e-3).turns, 0);
    EXPECT_EQ(recorded_swing(swinging(), 0.0, 0.21e-3).frequency_Hz, 0.0);
    // A jump of 36 or 43 mm in the first sample: the range is 38 or 45 mm, a twentieth of it 1.9 or 2.25 mm.
    for (const double jump_m : {0.036, 0.043}) {
        setup::PreparedTrial trial = swinging();
        trial.measured.tracks[0](2, 0) += jump_m;
        EXPECT_EQ(recorded_swing(trial, 0.0, 1e-5).turns >= 3, jump_m < 0.04) << jump_m;
    }
}

TEST(RecordedSwings, AreThoseOfTheCoordinateWithTheLargestMotion) {
    setup::PreparedTrial trial = swinging();
    Eigen::Matrix3Xd drift = Eigen::Matrix3Xd::Zero(3, 111);
    for (const double range_m : {1.9e-3, 2.1e-3}) {
        drift.row(0) = Eigen::RowVectorXd::LinSpaced(111, 0.0, range_m);
        trial.measured.tracks = {swinging().measured.tracks[0], drift};
        EXPECT_EQ(recorded_swing(trial, 0.0, 1e-5).turns > 0, range_m < 2e-3) << range_m;
    }
}

TEST(RecordedSwings, AreLookedForWhereTheBodyIsFree) {
    setup::PreparedTrial trial = swinging();
    trial.measured.tracks[0].row(2).tail(61).setZero();
    EXPECT_EQ(recorded_swing(trial, 0.5, 1e-5).turns, 0) << "what moved it before does not count";
    EXPECT_EQ(recorded_swing(swinging(), 0.3, 1e-5).turns, 3);
    EXPECT_EQ(recorded_swing(swinging(), 9.0, 1e-5).turns, 0);
    trial = swinging();
    trial.first_sample = 30;
    EXPECT_EQ(recorded_swing(trial, 0.0, 1e-5).turns, 3) << "nor what is not compared";
    trial.first_sample = 108;
    EXPECT_EQ(recorded_swing(trial, 0.0, 1e-5).turns, 0);
    trial = swinging();
    trial.mount = model::with_vibrations(nullptr, {{Eigen::Vector3d::UnitX(), 1.0, 0.0}});
    EXPECT_EQ(recorded_swing(trial, 0.0, 1e-5).turns, 0) << "its mount may have shaken it";
    EXPECT_EQ(recorded_swing(swinging(), 0.0, 1e-5).turns, 4);
}

TEST(LastChanges, AreThoseOfMoreThanATwentiethOfASignal) {
    model::Model model;
    for (const double last : {0.94, 0.96}) {
        model.activation = {fibre::Signal{{0.0, 1.0, 2.0}, {0.0, 1.0, last}}};
        EXPECT_EQ(last_change_s(model), last < 0.95 ? 2.0 : 1.0) << last;
    }
    model.activation = {fibre::Signal::constant(1.0)};
    EXPECT_EQ(last_change_s(model), 0.0);
    model::DeadForce force{Eigen::VectorXd::Ones(1), Eigen::Vector3d::UnitX()};
    force.course = fibre::Signal{{0.0, 4.0}, {1.0, 0.5}};
    model.forces = {force};
    EXPECT_EQ(last_change_s(model), 4.0);
    // The latest of all.
    model.activation = {fibre::Signal::step(6.0, 0.0, 1.0), fibre::Signal::step(5.0, 0.0, 1.0)};
    EXPECT_EQ(last_change_s(model), 6.0);
}

/// A run of the first trial with these numbers of states, each at rest, 10 ms apart.
prediction::SetupRun still_run(const setup::Setup& setup, std::size_t states) {
    prediction::SetupRun run;
    run.predictions.resize(setup.trials.size());
    for (std::size_t k = 0; k < states; ++k) {
        run.predictions[0].trace.times_s.push_back(0.01 * static_cast<double>(k));
        run.predictions[0].trace.positions.push_back(setup.mesh.mesh.nodes);
    }
    return run;
}

TEST(CellsInsideOut, AreCountedByTheirWorstCorner) {
    const test::Folder folder("cells_inside_out");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    prediction::SetupRun run = still_run(setup, 100);
    ASSERT_EQ(check_inside_out({setup, &run}).size(), 1u) << "a trial that was not run has no finding";
    EXPECT_EQ(check_inside_out({setup, &run}).front().figure, 0.0);
    // One corner of the body pushed through its cell, in one state.
    Eigen::Index corner = 0;
    (setup.mesh.mesh.nodes.colwise() - Eigen::Vector3d(0.1, 0.0, 0.03)).colwise().norm().minCoeff(&corner);
    run.predictions[0].trace.positions[77](0, corner) -= 0.05;
    const Finding pushed = check_inside_out({setup, &run}).front();
    EXPECT_EQ(pushed.level, CheckLevel::wrong);
    EXPECT_EQ(pushed.figure, 1.0);
    EXPECT_THAT(pushed.sentence, HasSubstr("up to 1 of "));
    EXPECT_THAT(pushed.sentence, HasSubstr("the first at 0.77 s"));
    // A flat cell is none either. The largest count is told, with the time of the first.
    run.predictions[0].trace.positions[90].row(2).setZero();
    const Finding flat = check_inside_out({setup, &run}).front();
    EXPECT_EQ(flat.figure, static_cast<double>(setup.mesh.mesh.cell_count()));
    EXPECT_THAT(flat.sentence, HasSubstr("the first at 0.77 s"));
}

TEST(CellsInsideOut, AreSeenInLongRunsIfTheyStay) {
    const test::Folder folder("cells_long_run");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    prediction::SetupRun run = still_run(setup, 250);
    // Three states of 250 are more than a hundredth.
    for (const std::size_t state : {121u, 122u, 123u}) run.predictions[0].trace.positions[state].row(2) *= -1.0;
    const Finding found = check_inside_out({setup, &run}).front();
    EXPECT_EQ(found.level, CheckLevel::wrong);
    EXPECT_EQ(found.figure, static_cast<double>(setup.mesh.mesh.cell_count()));
    EXPECT_THAT(found.sentence, HasSubstr("the first at 1.23 s"));
}

}  // namespace
}  // namespace myo::check::swings_and_cells_test
