#include "results/output_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/made_calibration.hpp"
#include "support/swung_beam.hpp"

namespace myo::results {
namespace {

using testing::ElementsAre;

/// Settings of a fit of these parameters.
calibration::CalibrationSettings fitting(std::vector<std::string> names) {
    calibration::CalibrationSettings settings;
    settings.names = std::move(names);
    return settings;
}

class OutputJson : public testing::Test {
protected:
    OutputJson()
        : folder_("output_json"), setup_(test::swung_beam(folder_, 0.1)), made_(test::made_calibration(setup_)) {
        facts_.version = "1.2.3";
        facts_.command = {"myoloop", "calibrate", "x"};
        facts_.setup_s = 0.125;
        facts_.peak_memory_bytes = 4096;
    }

    report::Json calibrated() const { return calibrate_json(setup_, made_, facts_); }

    test::Folder folder_;
    setup::Setup setup_;
    calibration::Calibration made_;
    RunFacts facts_;
};

TEST_F(OutputJson, DeviationIsTheRootOfTheSumOfSquares) {
    const report::Json json = calibrated();
    const report::Json& modulus = json["parameters"]["youngs_modulus_Pa"];
    EXPECT_EQ(modulus["value"], 2.5e5);
    EXPECT_EQ(modulus["start"], 2.6e5);
    EXPECT_EQ(modulus["unit"], "Pa");
    // 300, 400 and 1200: 1300.
    EXPECT_NEAR(modulus["std"].get<double>(), 1300.0, 1e-9);
    EXPECT_EQ(modulus["std_noise"], 300.0);
    EXPECT_EQ(modulus["std_mesh"], 400.0);
    EXPECT_EQ(modulus["std_step"], 1200.0);
    EXPECT_FALSE(modulus.contains("at_bound"));
    const report::Json& damping = json["parameters"]["damping_s"];
    EXPECT_EQ(damping["std"], 1e-4);
    EXPECT_EQ(damping["std_mesh"], 0.0);
}

TEST_F(OutputJson, UnknownPartsAreNullAndLeftOut) {
    made_.numerical.mesh.resize(0);
    const report::Json json = calibrated();
    const report::Json& modulus = json["parameters"]["youngs_modulus_Pa"];
    EXPECT_TRUE(modulus["std_mesh"].is_null());
    EXPECT_NEAR(modulus["std"].get<double>(), std::hypot(300.0, 1200.0), 1e-9);
}

TEST_F(OutputJson, UndeterminedValueHasAReasonAndNoDeviation) {
    made_.fit.deviations(1) = std::nan("");
    made_.fit.undetermined = {{{1}, 0, {}}};
    const report::Json damping = calibrated()["parameters"]["damping_s"];
    EXPECT_TRUE(damping["std"].is_null());
    EXPECT_EQ(damping["reason"], "it has no influence on the data");
}

TEST_F(OutputJson, ValueAtItsBoundIsMarked) {
    const inverse::Parameter& modulus = made_.parameters[0].parameter;
    made_.fit.values(0) = modulus.upper;
    EXPECT_EQ(calibrated()["parameters"]["youngs_modulus_Pa"]["at_bound"], "upper");
    made_.fit.values(0) = modulus.lower;
    EXPECT_EQ(calibrated()["parameters"]["youngs_modulus_Pa"]["at_bound"], "lower");
}

TEST_F(OutputJson, CountsEvaluationsOfThisFitAndOfAll) {
    made_.starts.push_back(made_.starts.front());
    made_.starts.push_back({inverse::FitStatus::failed, "it broke", made_.fit.start, {}, 0.0, 0.0, {}});
    made_.settings.starts = 3;
    made_.settings.seed = 42;
    const report::Json json = calibrated();
    EXPECT_EQ(json["schema"], "calibrate/1");
    EXPECT_EQ(json["evaluations"], 4);
    EXPECT_EQ(json["evaluations_in_all"], 9);
    EXPECT_EQ(json["seed"], 42);
    EXPECT_EQ(json["history"].size(), 4u);
    EXPECT_EQ(json["history"][3]["start"], 2);
    EXPECT_EQ(json["history"][1]["cost"], 2.0);
    EXPECT_EQ(json["history"][1]["values"], report::Json({2.5e5, 0.004}));
    ASSERT_EQ(json["starts"].size(), 3u);
    EXPECT_EQ(json["starts"][0]["cost_before"], 80.0);
    EXPECT_EQ(json["starts"][2]["ended"], "failed");
    EXPECT_EQ(json["starts"][2]["message"], "it broke");
    EXPECT_FALSE(json["starts"][2].contains("cost_after"));
}

TEST_F(OutputJson, ComparesBeforeAndAfter) {
    const report::Json json = calibrated();
    // A miss of 3 mm along one of three axes: 3 / sqrt(3) mm.
    EXPECT_NEAR(json["rms_before_m"].get<double>(), 3e-3 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(json["rms_after_m"].get<double>(), 3e-4 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(json["validation_rms_before_m"].get<double>(), 6e-3 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(json["validation_rms_after_m"].get<double>(), 6e-4 / std::sqrt(3.0), 1e-15);
    ASSERT_EQ(json["trials"].size(), 2u);
    const report::Json& trial = json["trials"][0];
    EXPECT_EQ(trial["name"], "swing");
    EXPECT_EQ(trial["role"], "fit");
    EXPECT_EQ(json["trials"][1]["role"], "validate");
    EXPECT_EQ(trial["rms_m"], trial["rms_after_m"]);
    EXPECT_NEAR(trial["markers"]["tip_left"]["steady_error_m"].get<double>(), 3e-4, 1e-15);
    EXPECT_NEAR(trial["markers"]["tip_left"]["steady_state_m"][2].get<double>(), 0.03 + 3e-4, 1e-15);
    EXPECT_EQ(trial["markers"]["tip_left"]["steady_measured_m"], report::Json({0.1, 0.0, 0.03}));
    EXPECT_EQ(json["correlation"]["matrix"][0][1], -0.257);
    EXPECT_THAT(json["correlation"]["parameters"].get<std::vector<std::string>>(),
                ElementsAre("youngs_modulus_Pa", "damping_s"));
    EXPECT_EQ(json["values"]["youngs_modulus_Pa"], 2.5e5);
    EXPECT_EQ(json["values"]["damping_s"], 0.004);
    EXPECT_EQ(json["noise_m"]["middle"], 1e-4);
    EXPECT_EQ(json["noise_declared"], true);
}

TEST_F(OutputJson, FailedTrialHasNullsAndAReason) {
    made_.after = test::with_failure(setup_, made_.after, 1, "it became unstable");
    const report::Json json = calibrated();
    EXPECT_TRUE(json["validation_rms_after_m"].is_null());
    EXPECT_FALSE(json["rms_after_m"].is_null());
    const report::Json& trial = json["trials"][1];
    EXPECT_TRUE(trial["rms_m"].is_null());
    EXPECT_TRUE(trial["markers"].empty());
    EXPECT_EQ(trial["failure_after"], "it became unstable");
    EXPECT_FALSE(trial.contains("failure_before"));
}

TEST_F(OutputJson, WarningsOfTheSetupComeFirst) {
    setup_.warnings = {"one"};
    made_.warnings = {"two", "three"};
    EXPECT_EQ(calibrated()["warnings"], report::Json({"one", "two", "three"}));
}

TEST_F(OutputJson, StatesSizeAndProgram) {
    const report::Json json = calibrated();
    EXPECT_EQ(json["dofs"].get<Eigen::Index>(), 3 * setup_.mesh.mesh.node_count());
    EXPECT_EQ(json["elements"].get<Eigen::Index>(), setup_.mesh.mesh.cell_count());
    EXPECT_EQ(json["element"], "hex8");
    EXPECT_EQ(json["layers"], 2);
    EXPECT_NEAR(json["layers_across_m"].get<double>(), 0.03, 1e-12);
    EXPECT_EQ(json["integrator"], "tr_bdf2");
    EXPECT_EQ(json["dt_s"], setup_.trials.front().options.h_s);
    EXPECT_FALSE(json.contains("spectral_radius"));
    setup_.settings.integrator = dynamics::Integrator::generalized_alpha;
    EXPECT_EQ(setup_size_json(setup_)["spectral_radius"], 0.5);
    EXPECT_EQ(json["version"], "1.2.3");
    EXPECT_EQ(json["command"], report::Json({"myoloop", "calibrate", "x"}));
    EXPECT_EQ(json["setup_s"], 0.125);
    EXPECT_EQ(json["peak_memory_bytes"], 4096);
}

/// The file is read by scripts and by --resume: what is written must be read again to the last bit.
TEST_F(OutputJson, ReadsBackExactly) {
    made_.fit.values(0) = 250123.45678901234;
    made_.fit.deviations(1) = 1.0 / 3e4;
    const std::filesystem::path file = folder_.path() / "calibrate.json";
    const report::Json json = calibrated();
    ASSERT_TRUE(report::write_json(file, json));
    const Result<report::Json> read = report::read_json(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, json);
    EXPECT_EQ((*read)["parameters"]["youngs_modulus_Pa"]["value"].get<double>(), 250123.45678901234);
    const Result<calibration::EarlierCalibration> earlier = calibration::read_calibration(
        folder_.path(), setup_, fitting({"youngs_modulus", "damping"}));
    ASSERT_TRUE(earlier) << earlier.error().text();
    EXPECT_EQ(earlier->values.at("youngs_modulus_Pa"), 250123.45678901234);
    EXPECT_EQ(earlier->values.at("damping_s"), 0.004);
    EXPECT_EQ(earlier->evaluations, 7);
}

TEST_F(OutputJson, ResumedFitMustHaveTheSameParameters) {
    ASSERT_TRUE(report::write_json(folder_.path() / "calibrate.json", calibrated()));
    const auto refused = [&](const calibration::CalibrationSettings& settings) {
        const auto earlier = calibration::read_calibration(folder_.path(), setup_, settings);
        return earlier ? std::string() : earlier.error().what;
    };
    EXPECT_THAT(refused(fitting({"youngs_modulus"})), testing::StartsWith("has other parameters"));
    report::Json json = calibrated();
    json["parameters"]["damping_s"]["value"] = nullptr;
    ASSERT_TRUE(report::write_json(folder_.path() / "calibrate.json", json));
    EXPECT_THAT(refused(fitting({"youngs_modulus", "damping"})),
                testing::StartsWith("has no number as the value of damping_s"));
    std::filesystem::remove(folder_.path() / "calibrate.json");
    EXPECT_NE(refused(fitting({"youngs_modulus", "damping"})), "");
}

TEST_F(OutputJson, OfASimulationCountsStepsOfCompletedTrials) {
    prediction::SetupRun run = made_.before;
    run.seconds = 0.5;
    const report::Json whole = simulate_json(setup_, run, facts_);
    EXPECT_EQ(whole["schema"], "simulate/1");
    // Five steps and ten iterations in each of two trials.
    EXPECT_EQ(whole["steps"], 10);
    EXPECT_EQ(whole["iterations_mean"], 2.0);
    EXPECT_EQ(whole["forward_s"], 0.5);
    EXPECT_FALSE(whole.contains("failure"));
    EXPECT_EQ(whole["trials"][0]["steps"], 5);
    const report::Json part = simulate_json(setup_, test::with_failure(setup_, run, 0, "no equilibrium"), facts_);
    EXPECT_EQ(part["steps"], 5);
    ASSERT_EQ(part["trials"].size(), 1u);
    EXPECT_EQ(part["trials"][0]["name"], "swing again");
    EXPECT_EQ(part["failure"], "trial swing: no equilibrium");
}

TEST(EndingWord, IsOneOfFive) {
    using inverse::FitStatus;
    std::vector<std::string> words;
    for (const FitStatus status :
         {FitStatus::not_run, FitStatus::converged, FitStatus::not_converged, FitStatus::cancelled, FitStatus::failed})
        words.emplace_back(ending_word(status));
    EXPECT_THAT(words, ElementsAre("not_run", "converged", "not_converged", "stopped", "failed"));
}

}  // namespace
}  // namespace myo::results
