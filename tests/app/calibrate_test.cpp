#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/experiment_calls.hpp"
#include "measurement/trace_csv.hpp"
#include "support/shared_data.hpp"

namespace myo::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Calibrate, WritesEveryKeyOfTheContractAndAPage) {
    const Folder folder("calibrate");
    write_small_experiment(folder, 0.3);
    const ProgramRun run = run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out")}));
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json_of(folder, "calibrate");
    EXPECT_EQ(j.at("schema"), "calibrate/1");
    EXPECT_EQ(j.at("converged"), true);
    for (const char* name : {"youngs_modulus_Pa", "damping_s"})
        for (const char* key : {"value", "std", "start"})
            EXPECT_GT(j.at("parameters").at(name).at(key).get<double>(), 0.0) << name << key;
    EXPECT_EQ(j["parameters"]["youngs_modulus_Pa"]["start"], 2e4);
    EXPECT_LT(j.at("rms_after_m").get<double>(), j.at("rms_before_m").get<double>());
    EXPECT_GT(j.at("evaluations").get<int>(), 1);
    EXPECT_GT(j.at("seconds").get<double>(), 0.0);
    ASSERT_EQ(j.at("trials").size(), 2u);
    EXPECT_EQ(j["trials"][1]["role"], "validate");
    // Both trials have the same trace, and one of them was fitted.
    EXPECT_NEAR(j["trials"][0]["rms_after_m"].get<double>(), j["rms_after_m"].get<double>(), 1e-12);
    EXPECT_NEAR(j["validation_rms_after_m"].get<double>(), j["rms_after_m"].get<double>(), 1e-9);
    EXPECT_DOUBLE_EQ(j["noise_m"]["tip"].get<double>(), 1e-4);
    const std::string page = content_of(folder.path() / "out/report.html");
    for (const char* text : {"small block", "<svg", "kPa", "drop again", "predicted", "calibrate/1"})
        EXPECT_THAT(page, HasSubstr(text));
    for (const char* text : {"http://www.example", "src=", "NaN", "nan,"})
        EXPECT_EQ(page.find(text), std::string::npos) << text;
    EXPECT_TRUE(folder.has("out/drop.csv") && folder.has("out/drop_again.csv"));
    expect_clean(folder);
}

TEST(Calibrate, RefusesToFitOnlyWhatIsExact) {
    const Folder folder("calibrate_exact");
    write_small_experiment(folder, 0.3);
    const ProgramRun run = run_program(
        call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--parameters", "youngs_modulus"},
             {"--set", "material.youngs_modulus_tolerance=0"}));
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("nothing is left to fit"));
}

/// Runs with a slip in a unit may take for ever: it is said before the first of them, and not again.
TEST(Calibrate, LogsEveryEvaluationAndResumeGoesOnFromTheLast) {
    const Folder folder("calibrate_resume");
    write_small_experiment(folder, 0.3);
    ProgramRun run = run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resume"}));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("nothing to resume"));
    ASSERT_EQ(run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--quiet"})).status, 0);
    const json first = json_of(folder, "calibrate");
    ASSERT_EQ(first.at("history").size(), first.at("evaluations").get<std::size_t>());
    double least = 1e300;
    for (const json& evaluation : first["history"]) {
        EXPECT_EQ(evaluation.at("values").size(), 2u);
        EXPECT_GT(evaluation.at("seconds").get<double>(), 0.0);
        least = std::min(least, evaluation.at("cost").get<double>());
    }
    EXPECT_EQ(first["starts"][0].at("cost_after").get<double>(), least);
    ASSERT_EQ(
        run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resume", "--quiet"})).status,
        0);
    const json second = json_of(folder, "calibrate");
    for (const char* name : {"youngs_modulus_Pa", "damping_s"})
        EXPECT_EQ(second["parameters"][name]["start"], first["parameters"][name]["value"]) << name;
    EXPECT_NEAR(second["history"][0].at("cost").get<double>() / least, 1.0, 1e-7);  // Newton starts elsewhere
    EXPECT_LE(second["starts"][0].at("cost_after").get<double>(), least * (1.0 + 1e-7));
    EXPECT_EQ(second.at("evaluations_in_all").get<int>(),
              first.at("evaluations").get<int>() + second.at("evaluations").get<int>());
    EXPECT_NEAR(second.at("rms_before_m").get<double>() / first.at("rms_before_m").get<double>(), 1.0, 1e-6)
        << "before is still with the declared values";
    run = run_program(
        call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resume", "--parameters", "damping"}));
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("other parameters"));
}

TEST(Calibrate, SeveralStartsAreRepeatedByTheirSeed) {
    const Folder folder("calibrate_starts");
    write_small_experiment(folder, 0.3);
    const std::vector<std::string> words = call(
        {"calibrate", folder.str("exp"), "--out", folder.str("out"), "--starts", "3", "--seed", "7"});
    const ProgramRun run = run_program(words);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("start 3: "));
    const json first = json_of(folder, "calibrate");
    ASSERT_EQ(first.at("starts").size(), 3u);
    EXPECT_EQ(first.at("seed"), 7);
    EXPECT_EQ(first.at("history").size(), first.at("evaluations").get<std::size_t>());
    EXPECT_EQ(first["starts"][0].at("start")[0], 2e4);
    const json* best = &first["starts"][0];
    for (const json& start : first["starts"]) {
        EXPECT_GE(start.at("start")[0].get<double>(), 1.4e4);
        EXPECT_LE(start.at("start")[0].get<double>(), 2.6e4);
        EXPECT_LT(start.at("cost_after").get<double>(), start.at("cost_before").get<double>());
        EXPECT_NE(&start == &first["starts"][0], start.at("start")[0] != 2e4);
        if (start.at("cost_after") < best->at("cost_after")) best = &start;
    }
    EXPECT_EQ(first["parameters"]["youngs_modulus_Pa"]["value"], best->at("values")[0]);
    EXPECT_THAT(content_of(folder.path() / "out/report.html"), HasSubstr("Cost after"));
    ASSERT_EQ(run_program(words).status, 0);
    EXPECT_EQ(json_of(folder, "calibrate").at("starts"), first.at("starts"));
}

TEST(Calibrate, FitsOnlyWhatIsNamed) {
    const Folder folder("parameters");
    write_small_experiment(folder);
    ASSERT_EQ(run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--parameters",
                                "youngs_modulus", "--quiet"}))
                  .status,
              0);
    const json j = json_of(folder, "calibrate");
    EXPECT_TRUE(j["parameters"].contains("youngs_modulus_Pa"));
    EXPECT_FALSE(j["parameters"].contains("damping_s"));
}

TEST(Calibrate, CtrlCInTheFirstEvaluationWritesNothing) {
    const Folder folder("interrupt_fit");
    write_small_experiment(folder, 2.0);
    const ProgramRun run = interrupted(folder, "calibrate", "0.004", "\"fit\"");
    EXPECT_EQ(run.status, 130);
    EXPECT_LT(run.seconds_after_signal, 2.0);
    EXPECT_THAT(run.err, HasSubstr("nothing was written"));
    EXPECT_FALSE(folder.has("out/calibrate.json"));
    EXPECT_FALSE(folder.has("out/report.html"));
}

TEST(Calibrate, CtrlCKeepsTheBestValuesSoFar) {
    const Folder folder("interrupt_kept");
    write_small_experiment(folder, 2.0);
    const ProgramRun run = interrupted(folder, "calibrate", "0.004", "\"task\":\"fit\",\"done\":2.");
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_LT(run.seconds_after_signal, 5.0);  // it writes a page, and runs nothing more
    EXPECT_THAT(run.err, HasSubstr("stopped before the fit converged"));
    EXPECT_THAT(run.err, HasSubstr("written to"));
    const json j = json_of(folder, "calibrate");
    EXPECT_EQ(j.at("converged"), false);
    EXPECT_EQ(j.at("stopped"), true);
    EXPECT_GE(j.at("evaluations").get<int>(), 1);
    EXPECT_LE(j.at("rms_after_m").get<double>(), j.at("rms_before_m").get<double>());
    EXPECT_GT(j["parameters"]["youngs_modulus_Pa"].at("std").get<double>(), 0.0);
    EXPECT_GT(j["trials"][0].at("rms_after_m").get<double>(), 0.0);
    EXPECT_TRUE(j["trials"][1].at("rms_after_m").is_null());
    EXPECT_THAT(j["trials"][1].at("failure_after"), HasSubstr("stopped"));
    const std::string page = content_of(folder.path() / "out/report.html");
    EXPECT_THAT(page, HasSubstr("The user stopped the fit before it converged"));
    EXPECT_EQ(page.find("nan"), std::string::npos);
    EXPECT_TRUE(folder.has("out/drop.csv"));
    EXPECT_FALSE(folder.has("out/drop_again.csv"));
}

TEST(Calibrate, ProgressMovesWithinAnEvaluation) {
    const Folder folder("fit_progress");
    write_small_experiment(folder, 2.0);
    const ProgramRun run = run_program({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resolution",
                                        "0.005", "--json-progress", "--parameters", "youngs_modulus"});
    ASSERT_EQ(run.status, 0) << run.err;
    double last = 0.0;
    int inside = 0;
    for (const json& event : progress_events(run)) {
        if (event.at("task") != "fit") continue;
        const double done = event.at("done");
        EXPECT_GE(done, last);
        last = done;
        inside += done != std::floor(done) ? 1 : 0;
    }
    const json j = json_of(folder, "calibrate");
    EXPECT_EQ(last, j.at("evaluations").get<double>());
    EXPECT_GE(inside, 1);
    EXPECT_LE(inside, 10.0 * j.at("seconds").get<double>() + 1.0);
}

TEST(Calibrate, KeepsTheFitWhenAPredictionFails) {
    const Folder folder("failed_prediction");
    write_small_experiment(folder);
    // No block of rubber carries this.
    folder.write("exp/experiment.toml", small_toml() +
                                            "load = [{kind = \"force\", box_m = [[0.039, -0.001, -0.001], [0.041, "
                                            "0.021, 0.021]], force_N = [1e300, 0, 0]}]\n");
    const ProgramRun run = run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out")}));
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("the fit converged, but with its values trial drop again"));
    const json j = json_of(folder, "calibrate");
    EXPECT_EQ(j.at("converged"), true);
    EXPECT_EQ(j.at("stopped"), false);
    EXPECT_TRUE(j.at("validation_rms_after_m").is_null());
    EXPECT_NE(j["trials"][1].at("failure_before"), "");
    EXPECT_THAT(content_of(folder.path() / "out/report.html"), HasSubstr("Not run with the fitted values: "));
    EXPECT_TRUE(folder.has("out/drop.csv"));
}

}  // namespace
}  // namespace myo::test
