#include "results/optimize_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "measurement/actuation_csv.hpp"
#include "support/chambered_beam.hpp"
#include "support/known_run.hpp"
#include "support/muscle_beam.hpp"

namespace myo::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A search for the signal of one muscle at 0, 0.1 and 0.2 s, made without a search.
class OptimizeOutput : public testing::Test {
protected:
    OptimizeOutput()
        : folder_("optimize_output"),
          setup_(*test::muscle_beam_setup(folder_, test::muscle_beam_toml(), "time_s,up\n0,1\n1,1\n", 0.0, 0.2)) {
        inverse::SoughtSignals& sought = made_.problem.sought;
        sought.signals = {{"up", 0.5, 2.0, 1.0}};
        sought.groups = {{0, 1.0}};
        sought.frequency_Hz = 10.0;
        sought.end_s = 0.2;
        made_.problem.smoothness_m_s = 1e-4;
        made_.fit.status = inverse::FitStatus::converged;
        made_.fit.values = Eigen::RowVector3d(1.0, 0.9, 1.0 / 3.0 + 0.5);
        made_.fit.first.status = made_.fit.best.status = dynamics::RunStatus::complete;
        made_.fit.first.loss_m2 = 4e-6;
        made_.fit.best.loss_m2 = 1e-8;
        made_.fit.best.steps = 40;
        made_.fit.log = {{true, 4e-6, 2e-3, 1e-5, 0.5}, {false, 0.0, 0.0, 0.0, 0.25}};
        made_.starts = {{inverse::FitStatus::converged, "", 4e-6, 1e-8, 12}, {}};
        made_.starts[1].status = inverse::FitStatus::failed;
        made_.starts[1].message = "it broke";
        made_.earlier_evaluations = 3;
        made_.before = test::run_missed_by(setup_, {{0.0, 0.0, 3e-3}, {0.0, 0.0, 3e-3}});
        made_.after = test::run_missed_by(setup_, {{1e-4, 2e-4, 3e-4}, {1e-4, 2e-4, 3e-4}});
        made_.deviations.reason = "was not asked for";
    }

    report::Json json() const { return optimize_json(setup_, made_, {}); }
    /// Message of read_optimization() for this file; empty if it is read.
    std::string refused(const report::Json& file) const {
        EXPECT_TRUE(report::write_json(folder_.path() / "optimize.json", file));
        const auto read = read_optimization(folder_.path(), setup_, made_.problem);
        return read ? std::string() : read.error().what;
    }

    test::Folder folder_;
    setup::Setup setup_;
    calibration::Optimization made_;
};

TEST_F(OptimizeOutput, StatesSignalsAndCost) {
    const report::Json file = json();
    EXPECT_EQ(file["schema"], "optimize/1");
    EXPECT_EQ(file["trial"], "swing");
    EXPECT_EQ(file["interpolation"], "linear");
    EXPECT_EQ(file["knot_times_s"], report::Json({0.0, 0.1, 0.2}));
    EXPECT_EQ(file["signals"][0]["values"][2], 1.0 / 3.0 + 0.5);
    EXPECT_EQ(file["signals"][0]["lower"], 0.5);
    EXPECT_EQ(file["signals"][0]["upper"], 2.0);
    EXPECT_EQ(file["muscles"][0]["name"], "up");
    EXPECT_EQ(file["muscles"][0]["factor"], 1.0);
    EXPECT_EQ(file["loss_before_m2"], 4e-6);
    EXPECT_EQ(file["loss_after_m2"], 1e-8);
    EXPECT_EQ(file["evaluations"], 12);
    EXPECT_EQ(file["evaluations_in_all"], 15);
    EXPECT_EQ(file["steps"], 40);
    EXPECT_EQ(file["starts"][1]["message"], "it broke");
    EXPECT_FALSE(file["starts"][1].contains("loss_after_m2"));
    EXPECT_EQ(file["history"].size(), 2u);
    EXPECT_EQ(file["history"][0]["rms_m"], 2e-3);
    EXPECT_FALSE(file["history"][1].contains("rms_m"));
    EXPECT_EQ(file["std"], "was not asked for");
    EXPECT_FALSE(file.contains("missed"));
    EXPECT_FALSE(file.contains("registration"));
}

TEST_F(OptimizeOutput, SplitsTheErrorByAxis) {
    const report::Json axes = json()["rms_after_xyz_m"];
    EXPECT_NEAR(axes[0].get<double>(), 1e-4, 1e-17);
    EXPECT_NEAR(axes[1].get<double>(), 2e-4, 1e-17);
    EXPECT_NEAR(axes[2].get<double>(), 3e-4, 1e-17);
    EXPECT_NEAR(json()["rms_after_m"].get<double>(), std::sqrt(14e-8 / 3.0), 1e-16);
    for (Eigen::Matrix3Xd& residual : made_.after.predictions[0].residual_m) residual.row(1).setConstant(std::nan(""));
    EXPECT_TRUE(json()["rms_after_xyz_m"][1].is_null());
}

TEST_F(OptimizeOutput, StatesDeviationsAndTheMiss) {
    made_.deviations.found = true;
    made_.deviations.deviations = Eigen::RowVector3d(0.1, std::nan(""), 0.2);
    made_.deviations.from_target = Eigen::RowVector3d(0.9, 0.2, 0.8);
    made_.deviations.noise_m = 1e-4;
    made_.miss.reached = false;
    made_.miss.markers = {{"middle", 5e-4}};
    made_.miss.worst_s = 0.15;
    made_.miss.noise_levels = 7.0;
    const report::Json file = json();
    EXPECT_EQ(file["std_noise_m"], 1e-4);
    EXPECT_FALSE(file.contains("std"));
    EXPECT_EQ(file["signals"][0]["std"], report::Json({0.1, nullptr, 0.2}));
    EXPECT_EQ(file["signals"][0]["from_markers"], report::Json({0.9, 0.2, 0.8}));
    EXPECT_EQ(file["reached"], false);
    EXPECT_EQ(file["missed"]["markers"][0]["name"], "middle");
    EXPECT_EQ(file["missed"]["worst_s"], 0.15);
    EXPECT_EQ(file["missed"]["noise_levels"], 7.0);
}

/// What is written is where a resumed search begins, to the last bit.
TEST_F(OptimizeOutput, ResumesWithTheSameValues) {
    ASSERT_EQ(refused(json()), "");
    const auto read = read_optimization(folder_.path(), setup_, made_.problem);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->values, made_.fit.values);
    EXPECT_EQ(read->evaluations, 15);
}

TEST_F(OptimizeOutput, RefusesToResumeAnotherSearch) {
    const auto changed = [&](const std::string& key, const report::Json& value) {
        report::Json file = json();
        file[key] = value;
        return refused(file);
    };
    EXPECT_THAT(changed("schema", "optimize/2"), StartsWith("is not of the form optimize/1"));
    EXPECT_THAT(changed("trial", "other"), StartsWith("is of another trial than swing"));
    EXPECT_THAT(changed("frequency_Hz", 20.0), StartsWith("has signals with other knots"));
    EXPECT_THAT(changed("interpolation", "hold"), StartsWith("has signals with other knots"));
    EXPECT_THAT(changed("signals", report::Json::array()), StartsWith("has other signals"));
    EXPECT_THAT(changed("signals", 3), StartsWith("has other signals"));
    report::Json file = json();
    file["signals"][0]["name"] = "down";
    EXPECT_THAT(refused(file), StartsWith("has other signals"));
    file = json();
    file["signals"][0]["values"].push_back(1.0);
    EXPECT_THAT(refused(file), StartsWith("has signals with other knots"));
    file = json();
    file["signals"][0]["values"][1] = "1.0";
    EXPECT_THAT(refused(file), StartsWith("has a value that is no number"));
    EXPECT_THAT(refused(file), HasSubstr("without --resume it starts again"));
    std::filesystem::remove(folder_.path() / "optimize.json");
    const auto missing = read_optimization(folder_.path(), setup_, made_.problem);
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().what, StartsWith("there is nothing to resume"));
}

TEST_F(OptimizeOutput, WritesALinearSignalKnotByKnot) {
    ASSERT_TRUE(write_actuation(folder_.path(), setup_, made_));
    const auto table = measurement::read_actuation_csv(folder_.path() / "swing_actuation.csv");
    ASSERT_TRUE(table) << table.error().text();
    EXPECT_THAT(table->muscles, ElementsAre("up"));
    EXPECT_THAT(table->time_s, ElementsAre(0.0, 0.1, 0.2));
    EXPECT_EQ(table->values, made_.fit.values);
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "swing.csv"));
}

/// A held signal jumps: two rows per knot, so that what reads the file sees the same steps.
TEST_F(OptimizeOutput, WritesAHeldSignalAsJumps) {
    made_.problem.sought.hold = true;
    made_.fit.values = Eigen::RowVector2d(0.9, 0.7);
    ASSERT_TRUE(write_actuation(folder_.path(), setup_, made_));
    const auto table = measurement::read_actuation_csv(folder_.path() / "swing_actuation.csv");
    ASSERT_TRUE(table) << table.error().text();
    ASSERT_EQ(table->time_s.size(), 4);
    EXPECT_THAT(table->time_s, ElementsAre(0.0, 0.0, 0.1, 0.1));
    EXPECT_THAT(table->values.row(0), ElementsAre(1.0, 0.9, 0.9, 0.7));
}

/// Pressures and tensions have their own columns and units.
TEST(OptimizeOutputOfCommands, IsInTheirUnits) {
    const test::Folder folder("optimize_output_commands");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        e.tendons.push_back(test::upper_tendon());
        e.tendons.back().name = "cable";
        e.trials.pop_back();
        e.trials[0].actuation_steps = {{"upper", 4000.0}, {"cable", 1.0}};
    });
    calibration::Optimization made;
    calibration::OptimizeSettings settings;
    settings.frequency_Hz = 10.0;
    const Result<inverse::ActuationProblem> problem = calibration::actuation_problem(setup, settings);
    ASSERT_TRUE(problem) << problem.error().text();
    made.problem = *problem;
    made.fit.values = (Eigen::Matrix2d() << 0.0, 4000.0, 0.0, 0.5).finished();
    made.fit.first.status = made.fit.best.status = dynamics::RunStatus::complete;
    made.before = made.after = test::run_missed_by(setup, {{1e-4, 2e-4, 3e-4}});
    const report::Json signals = optimize_json(setup, made, {})["signals"];
    EXPECT_EQ(signals[0]["quantity"], "pressure");
    EXPECT_EQ(signals[0]["unit"], "Pa");
    EXPECT_EQ(signals[0]["upper"], 6000.0);
    EXPECT_EQ(signals[1]["name"], "cable");
    EXPECT_EQ(signals[1]["unit"], "N");
    ASSERT_TRUE(write_actuation(folder.path(), setup, made));
    const auto table = measurement::read_actuation_csv(folder.path() / "swing_actuation.csv");
    ASSERT_TRUE(table) << table.error().text();
    EXPECT_THAT(table->muscles, ElementsAre("upper_Pa", "cable_N"));
    EXPECT_EQ(table->values, made.fit.values);
    const std::string page = report::html(optimize_report(setup, made, {}));
    for (const char* text : {"pressure [Pa]", "tension [N]", "upper 18000 Pa", "At 0 chambers and tendons are at rest"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(OptimizeOutput, NamesOneFilePerTrial) {
    EXPECT_THAT(actuation_files("out", setup_.experiment),
                ElementsAre(std::filesystem::path("out/swing_actuation.csv"),
                            std::filesystem::path("out/swing_again_actuation.csv")));
}

}  // namespace
}  // namespace myo::results
