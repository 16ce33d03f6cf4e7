#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "check/catalogue.hpp"
#include "check/checks.hpp"
#include "check/declared_steps.hpp"
#include "check/recorded_swing.hpp"
#include "setup/first_vibration.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::check {
namespace {

using testing::HasSubstr;

/// The beam let go, with its own motion as its recording.
class TimeUnit : public testing::Test {
protected:
    TimeUnit() : folder_("time_unit"), setup_(test::swung_beam(folder_, 0.6)) {
        const prediction::ParameterValues values = prediction::declared_values(setup_);
        const prediction::TrialPrediction truth = prediction::predict_trial(setup_, 0, values);
        for (std::size_t t = 0; t < setup_.trials.size(); ++t) test::record(setup_, t, values, truth.trace);
    }

    /// As read from a file in whose unit a second is so many.
    Finding in_units(double per_second) const {
        setup::Setup setup = setup_;
        scale_times(setup.trials[0], per_second);
        return check_time_unit({setup}).front();
    }

    static void scale_times(setup::PreparedTrial& trial, double factor) {
        trial.measured.time_s *= factor;
        trial.measured.rate_Hz /= factor;
    }

    test::Folder folder_;
    setup::Setup setup_;
};

TEST_F(TimeUnit, SecondsAreThose) {
    const Finding found = in_units(1.0);
    EXPECT_EQ(found.level, CheckLevel::passed) << found.sentence;
    const model::Model model = prediction::trial_model(setup_, 0, prediction::declared_values(setup_));
    const double first_Hz = setup::first_vibration_rad_s(model) / (2.0 * std::numbers::pi);
    EXPECT_NEAR(found.figure, first_Hz, 0.15 * first_Hz);
    EXPECT_NEAR(found.threshold, first_Hz / 30.0, 1e-6 * first_Hz);
}

TEST_F(TimeUnit, KnowsMillisecondsMinutesAndFrameNumbers) {
    const Finding milliseconds = in_units(1000.0), minutes = in_units(1.0 / 60.0), frames = in_units(100.0);
    EXPECT_EQ(milliseconds.level, CheckLevel::wrong);
    EXPECT_THAT(milliseconds.sentence, HasSubstr("times slower than its first vibration"));
    EXPECT_THAT(milliseconds.way_out, HasSubstr("they look like milliseconds"));
    EXPECT_EQ(minutes.level, CheckLevel::doubtful);
    EXPECT_THAT(minutes.way_out, HasSubstr("they look like minutes"));
    EXPECT_EQ(frames.level, CheckLevel::doubtful);
    EXPECT_THAT(frames.way_out, HasSubstr("they look like the numbers of frames"));
    const Finding microseconds = in_units(1e-6);
    EXPECT_EQ(microseconds.level, CheckLevel::doubtful);
    EXPECT_THAT(microseconds.sentence, HasSubstr("1e+08 samples per second"));
}

/// One picture a minute of a body that creeps, and of one that is pulled to and fro, are slow recordings and no slips.
TEST_F(TimeUnit, LeavesSlowRecordingsAlone) {
    setup::Setup creeping = setup_;
    scale_times(creeping.trials[0], 6000.0);
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0.0, 1e-4);
    for (Eigen::Matrix3Xd& track : creeping.trials[0].measured.tracks)
        for (Eigen::Index k = 0; k < track.cols(); ++k) {
            track(2, k) = -0.02 * (1.0 - std::exp(-0.05 * static_cast<double>(k)));
            for (double& x : track.col(k)) x += noise(random);
        }
    EXPECT_EQ(check_time_unit({creeping}).front().level, CheckLevel::passed);

    setup::Setup pulled = setup_;
    scale_times(pulled.trials[0], 6000.0);
    const Eigen::Index nodes = pulled.mesh.mesh.node_count();
    model::DeadForce pull{Eigen::VectorXd::Constant(nodes, 1.0 / static_cast<double>(nodes)), Eigen::Vector3d::UnitZ()};
    pull.until_s = 0.98 * pulled.trials[0].measured.time_s.tail(1)(0);
    pulled.trials[0].model.forces.push_back(pull);
    EXPECT_EQ(check_time_unit({pulled}).front().level, CheckLevel::passed);
    pulled.trials[0].model.forces.back().until_s = 0.0;
    EXPECT_EQ(check_time_unit({pulled}).front().level, CheckLevel::wrong);
}

/// Whose motion is a target to be reached.
TEST_F(TimeUnit, LeavesMotionsAloneWhoseSignalsAreSought) {
    setup::Setup sought = setup_;
    scale_times(sought.trials[0], 1000.0);
    sought.trials[0].model.activation = {fibre::Signal::constant(1.0)};
    EXPECT_EQ(check_time_unit({sought}).front().level, CheckLevel::passed);
    sought.trials[0].model.activation = {fibre::Signal::step(0.0, 1.0, 0.8)};
    EXPECT_EQ(check_time_unit({sought}).front().level, CheckLevel::wrong);
}

TEST_F(TimeUnit, IsAskedBeforeEveryJob) {
    scale_times(setup_.trials[0], 1000.0);
    const std::vector<Finding> before = check_before(setup_);
    EXPECT_TRUE(std::any_of(before.begin(), before.end(), [](const Finding& finding) {
        return finding.check == "time_unit" && finding.level == CheckLevel::wrong;
    }));
}

/// A run of times in another unit would take thousands of times as long; the key says that they are seconds.
TEST_F(TimeUnit, TimesInAnotherUnitAreRefusedUnlessTheKeySaysSo) {
    const auto refused = [](const setup::Setup& setup) { return require_time_unit(setup, findings_on_units(setup)); };
    EXPECT_TRUE(refused(setup_));
    setup::Setup slow = setup_;
    scale_times(slow.trials[0], 1000.0);
    const Result<void> found = refused(slow);
    ASSERT_FALSE(found);
    EXPECT_THAT(found.error().what, testing::StartsWith("trial[0].time_unit: "));
    EXPECT_THAT(found.error().what, HasSubstr("look like milliseconds: state time_unit = \"ms\", or \"s\""));
    EXPECT_THAT(found.error().where, HasSubstr("experiment.toml:"));
    slow.experiment.trials[0].seconds_per_unit = 1.0;
    EXPECT_TRUE(refused(slow)) << "the user says that they are seconds";
    setup::Setup micro = setup_;
    scale_times(micro.trials[0], 1e6);
    EXPECT_THAT(refused(micro).error().what, HasSubstr("time_unit = \"us\""));
    // At a usual rate a modulus off by a factor of a million is as likely; a fast swing is not too long to run.
    setup::Setup stiff = setup_;
    for (setup::PreparedTrial& trial : stiff.trials)
        trial.model.moduli = model::uniform_moduli(stiff.body->cell_count(), 2.6e11, 0.49);
    EXPECT_TRUE(refused(stiff));
    setup::Setup fast = setup_;
    scale_times(fast.trials[0], 1e-3);
    EXPECT_TRUE(refused(fast));
}

TEST(TurningTimes, AreThoseOfTheMotionAndNotOfTheNoise) {
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(201, 0.0, 2.0);
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0.0, 0.01);
    Eigen::VectorXd swing(201), still(201);
    for (Eigen::Index k = 0; k < 201; ++k) {
        swing(k) = std::cos(2.0 * std::numbers::pi * 1.5 * time(k)) + noise(random);
        still(k) = noise(random);
    }
    swing.segment(50, 3).setConstant(std::nan(""));
    const std::vector<double> turns = turning_times(time, swing, 0.1);
    ASSERT_EQ(turns.size(), 5u);  // 1/3, 2/3, ... s; the first is where it begins
    for (std::size_t i = 0; i < turns.size(); ++i) EXPECT_NEAR(turns[i], static_cast<double>(i + 1) / 3.0, 0.04);
    EXPECT_TRUE(turning_times(time, still, 0.1).empty());
}

TEST(LastChange, IsThatOfLoadsAndSignals) {
    model::Model model;
    EXPECT_EQ(last_change_s(model), 0.0);
    model.activation = {fibre::Signal{{0.0, 1.0, 2.0, 5.0}, {1.0, 1.0, 0.8, 0.801}}};
    EXPECT_EQ(last_change_s(model), 2.0);
    model::DeadForce force{Eigen::VectorXd::Ones(1), Eigen::Vector3d::UnitX()};
    force.until_s = 3.0;
    model.forces = {force};
    EXPECT_EQ(last_change_s(model), 3.0);
}

}  // namespace
}  // namespace myo::check
