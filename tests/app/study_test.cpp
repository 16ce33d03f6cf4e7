#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "measurement/trace_csv.hpp"
#include "support/shared_data.hpp"

namespace myo::test {
namespace {

using ::testing::HasSubstr;
using nlohmann::json;
namespace fs = std::filesystem;

const std::vector<std::string> coarse{"--resolution", "0.01"};

std::vector<std::string> call(std::vector<std::string> words, const std::vector<std::string>& more = coarse) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The parsed result of a command that wrote to "out".
json json_of(const Folder& folder, const std::string& command) { return json::parse(content_of(folder.path() / "out" / (command + ".json"))); }

/// A command on this experiment, interrupted as soon as a text stands in its progress.
ProgramRun interrupted(const Folder& folder, const std::string& command, const std::string& resolution, const std::string& when) {
    return run_program({command, folder.str("exp"), "--out", folder.str("out"), "--resolution", resolution, "--json-progress"}, when);
}

/// No null and no NaN anywhere, and no temporary file left.
void expect_clean(const Folder& folder) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path())) {
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
        if (entry.path().extension() != ".json") continue;
        const std::string text = content_of(entry.path());
        EXPECT_EQ(text.find("null"), std::string::npos) << entry.path();
        EXPECT_TRUE(json::accept(text)) << entry.path();
    }
}

/// What --json-progress has written among the warnings.
std::vector<json> progress_events(const ProgramRun& run) {
    std::vector<json> events;
    std::istringstream lines(run.err);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("myoloop: ", 0) == 0) continue;
        events.push_back(json::parse(line));
        EXPECT_EQ(events.back().at("event"), "progress");
    }
    return events;
}

TEST(Simulate, WritesEveryKeyOfTheContract) {
    const Folder folder("simulate");
    write_small_experiment(folder);
    const ProgramRun run = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--threads", "1", "--seed", "7"}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("damping 3 ms (assumed"));
    EXPECT_THAT(run.out, HasSubstr("drop again"));
    const json j = json_of(folder, "simulate");
    EXPECT_EQ(j.at("schema"), "simulate/1");
    EXPECT_EQ(j.at("element"), "hex8");
    EXPECT_EQ(j.at("elements"), 4 * 2 * 2);
    EXPECT_EQ(j.at("integrator"), "tr_bdf2");
    // Half a sampling interval or a whole part of it, as the vibration asks for.
    const double parts = 0.01 / j.at("dt_s").get<double>();
    EXPECT_NEAR(parts, std::round(parts), 1e-9);
    EXPECT_GE(parts, 2.0);
    EXPECT_EQ(j.at("seed"), 7);
    for (const char* key : {"dofs", "steps", "forward_s", "setup_s", "iterations_mean", "peak_memory_bytes"}) EXPECT_GT(j.at(key).get<double>(), 0.0) << key;
    ASSERT_EQ(j.at("trials").size(), 2u);
    const json& trial = j["trials"][0];
    EXPECT_EQ(trial.at("name"), "drop");
    const double tip = trial.at("markers").at("tip").at("rms_m"), middle = trial["markers"].at("middle").at("rms_m");
    EXPECT_NEAR(trial.at("rms_m").get<double>(), std::sqrt(0.5 * (tip * tip + middle * middle)), 1e-12);
    EXPECT_EQ(trial["markers"]["tip"].at("steady_state_m").size(), 3u);
    EXPECT_EQ(trial["markers"]["tip"]["steady_state_m"], j["trials"][1]["markers"]["tip"]["steady_state_m"]);
    expect_clean(folder);
}

TEST(Simulate, TracesAreAtTheSampleTimesAndMatchTheirScore) {
    const Folder folder("traces");
    write_small_experiment(folder);
    ASSERT_EQ(run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--trial", "drop again", "--quiet"})).status, 0);
    EXPECT_FALSE(folder.has("out/drop.csv"));
    const Result<Recording> measured = read_trace_csv(folder.path() / "exp/drop.csv"), simulated = read_trace_csv(folder.path() / "out/drop_again.csv");
    ASSERT_TRUE(measured && simulated);
    EXPECT_EQ(simulated->labels, measured->labels);
    EXPECT_EQ(simulated->time_s, measured->time_s);
    EXPECT_NEAR(simulated->tracks[0](2, 0), 0.02, 1e-12);   // it starts at rest
    double sum = 0.0;
    for (std::size_t m = 0; m < 2; ++m) sum += (simulated->tracks[m] - measured->tracks[m]).squaredNorm();
    const json j = json_of(folder, "simulate");
    ASSERT_EQ(j["trials"].size(), 1u);
    EXPECT_NEAR(j["trials"][0]["rms_m"].get<double>(), std::sqrt(sum / 66.0), 1e-12);
}

TEST(Simulate, OptionsReachTheModel) {
    const Folder folder("options");
    write_small_experiment(folder);
    const auto simulated = [&](const std::vector<std::string>& more) {
        EXPECT_EQ(run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--quiet"}, more)).status, 0);
        return json_of(folder, "simulate");
    };
    const double plain = simulated(coarse)["trials"][0]["rms_m"];
    const json tet = simulated({"--resolution", "0.01", "--element", "tet10", "--integrator", "implicit_euler", "--dt", "0.002", "--material", "corotational"});
    EXPECT_EQ(tet["element"], "tet10");
    EXPECT_EQ(tet["integrator"], "implicit_euler");
    EXPECT_EQ(tet["material"], "corotational");
    EXPECT_DOUBLE_EQ(tet["dt_s"].get<double>(), 0.002);
    const json stiff = simulated({"--resolution", "0.01", "--set", "material.youngs_modulus_Pa=2e6", "--set", "material.damping_s=0.001"});
    EXPECT_EQ(stiff["values"]["youngs_modulus_Pa"], 2e6);
    EXPECT_EQ(stiff["values"]["damping_declared"], true);
    EXPECT_GT(std::abs(stiff["trials"][0]["rms_m"].get<double>() - plain), 1e-4);
    EXPECT_NE(simulated({"--resolution", "0.01", "--velocity-force", "-20"})["trials"][0]["rms_m"].get<double>(), plain);
}

TEST(Simulate, TellsWhatTheTimeStepDoesBeforeTheRun) {
    const Folder folder("integration");
    write_small_experiment(folder);
    const auto simulated = [&](const std::vector<std::string>& more, std::string& warnings) {
        const ProgramRun run = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01"}, more));
        EXPECT_EQ(run.status, 0) << run.err;
        warnings = run.err;
        return json_of(folder, "simulate");
    };
    std::string warnings;
    const json plain = simulated({"--dt", "0.01"}, warnings);
    EXPECT_GT(plain["first_frequency_Hz"].get<double>(), 1.0);
    EXPECT_LT(plain["numerical_damping_ratio"].get<double>(), 0.01);
    EXPECT_FALSE(plain.contains("critical_velocity_force_1_s"));
    EXPECT_FALSE(plain.contains("spectral_radius"));
    EXPECT_EQ(warnings.find("Λ"), std::string::npos) << warnings;

    const json euler = simulated({"--dt", "0.01", "--integrator", "implicit_euler", "--set", "material.damping_s=0.0001"}, warnings);
    EXPECT_GT(euler["numerical_damping_ratio"].get<double>(), 10.0 * plain["numerical_damping_ratio"].get<double>());
    EXPECT_NE(warnings.find("damps the first vibration"), std::string::npos) << warnings;

    const json pushed = simulated({"--dt", "0.01", "--velocity-force", "90"}, warnings);
    EXPECT_LT(pushed["critical_velocity_force_1_s"].get<double>(), 90.0);
    EXPECT_NE(warnings.find("Λ_crit"), std::string::npos) << warnings;

    const json alpha = simulated({"--dt", "0.01", "--integrator", "generalized_alpha", "--spectral-radius", "0.8"}, warnings);
    EXPECT_EQ(alpha["spectral_radius"], 0.8);
    EXPECT_NE(alpha["trials"][0]["rms_m"], simulated({"--dt", "0.01", "--integrator", "generalized_alpha"}, warnings)["trials"][0]["rms_m"]);
}

TEST(Simulate, AsPublishedIsOneOptionAndOthersChangeItsParts) {
    const Folder folder("published");
    write_small_experiment(folder);
    const auto simulated = [&](const std::vector<std::string>& more) {
        EXPECT_EQ(run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--quiet", "--resolution", "0.009"}, more)).status, 0);
        return json_of(folder, "simulate");
    };
    const json honest = simulated({});
    EXPECT_EQ(honest.at("as_published"), false);
    EXPECT_EQ(honest.at("mass"), "consistent");
    EXPECT_EQ(honest.at("voxels"), "fitted");
    const json published = simulated({"--as-published"});
    EXPECT_EQ(published.at("as_published"), true);
    EXPECT_EQ(published.at("element"), "hex8_full");
    EXPECT_EQ(published.at("material"), "projective_corotational");
    EXPECT_EQ(published.at("integrator"), "implicit_euler");
    EXPECT_EQ(published.at("mass"), "equal_vertices");
    EXPECT_EQ(published.at("voxels"), "truncated");
    EXPECT_EQ(published.at("elements"), 4 * 2 * 2);
    EXPECT_EQ(published.at("values").at("damping_s"), 0.0);
    EXPECT_THAT(published.at("warnings").dump(), HasSubstr("36 x 18 x 18 mm instead of 40 x 20 x 20"));
    EXPECT_THAT(published.at("warnings").dump(), HasSubstr("weighs 281 %"));
    // Before or after it, an option of its own goes before what it sets.
    for (const auto& order : {std::vector<std::string>{"--mass", "consistent", "--integrator", "bdf2", "--as-published"},
                              std::vector<std::string>{"--as-published", "--mass", "consistent", "--integrator", "bdf2"}}) {
        const json mixed = simulated(order);
        EXPECT_EQ(mixed.at("as_published"), true);
        EXPECT_EQ(mixed.at("mass"), "consistent");
        EXPECT_EQ(mixed.at("integrator"), "bdf2");
        EXPECT_EQ(mixed.at("voxels"), "truncated");
        EXPECT_NE(mixed["trials"][0]["rms_m"], published["trials"][0]["rms_m"]);
    }
}

TEST(Simulate, OneAndFourThreadsAgree) {
    const Folder folder("threads");
    write_small_experiment(folder);
    for (const char* threads : {"1", "4"})
        ASSERT_EQ(run_program(call({"simulate", folder.str("exp"), "--out", folder.str(std::string("out") + threads), "--threads", threads, "--quiet"})).status, 0);
    const Result<Recording> one = read_trace_csv(folder.path() / "out1/drop.csv"), four = read_trace_csv(folder.path() / "out4/drop.csv");
    ASSERT_TRUE(one && four);
    EXPECT_LT((one->tracks[0] - four->tracks[0]).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Simulate, SeriesNamesEveryFrame) {
    const Folder folder("series");
    write_small_experiment(folder);
    ASSERT_EQ(run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--vtu", "--trial", "drop",
                                "--dt", "0.005", "--quiet"}))
                  .status,
              0);
    const std::string collection = content_of(folder.path() / "out/drop.pvd");
    int frames = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path() / "out/drop_frames")) {
        EXPECT_THAT(collection, HasSubstr("drop_frames/" + entry.path().filename().string()));
        ++frames;
    }
    EXPECT_EQ(frames, 27);   // the start and 26 steps of 5 ms: 0.1 s and three sampling intervals
    expect_clean(folder);
}

TEST(Simulate, ProgressIsJsonWhenAsked) {
    const Folder folder("progress");
    write_small_experiment(folder);
    const ProgramRun run = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--json-progress"}));
    ASSERT_EQ(run.status, 0);
    const std::vector<json> events = progress_events(run);
    ASSERT_FALSE(events.empty());
    for (const json& event : events) EXPECT_LE(event.at("done").get<double>(), event.at("total").get<double>());
    EXPECT_EQ(events.back()["task"], "simulate");
    EXPECT_EQ(events.back()["done"], events.back()["total"]);
    const ProgramRun quiet = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--quiet"}));
    EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST(Simulate, BrokenInputIsOneSentenceWithItsPlace) {
    const Folder folder("broken");
    write_small_experiment(folder);
    folder.write("exp/drop.csv", "time_s,tip_x_m\n\x01\x02 garbage\n");
    ProgramRun run = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out")}));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("drop.csv"));
    folder.write("exp/experiment.toml", small_toml() + "start = 1 2\n");
    run = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out")}));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("experiment.toml:"));
}

/// A clamp in mm holds the whole body: every command that runs it says so, none dies.
TEST(Simulate, AClampThatHoldsTheWholeBodyIsRefused) {
    const Folder folder("held");
    write_small_experiment(folder);
    const std::vector<std::string> held{"--set", "clamp.box_m=[[-1,-1,-1],[1,21,21]]"};
    for (const char* command : {"simulate", "calibrate", "diagnose"}) {
        const ProgramRun run = run_program(call({command, folder.str("exp"), "--out", folder.str("out")}, held));
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        EXPECT_THAT(run.err, HasSubstr("clamp.box_m: holds the whole body, nothing can move"));
    }
    EXPECT_EQ(run_program(call({"gradcheck", folder.str("exp")}, held)).status, 2);
}

/// Whole sentences, and no advice on steps and integrators to a problem of statics.
TEST(Simulate, SaysWhatHelpsWhereThereIsNoEquilibrium) {
    const Folder folder("no_equilibrium");
    write_small_experiment(folder);
    const std::vector<std::string> soft{"--resolution", "0.01",
                                        "--set",        "material.youngs_modulus_Pa=1",
                                        "--set",        "trial[0].start=equilibrium"};
    const ProgramRun run =
        run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out"), "--trial", "drop"}, soft));
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err,
                HasSubstr("no equilibrium was found under gravity, the loads and the activations at the start"));
    EXPECT_THAT(run.err, HasSubstr("(E = 1 Pa)"));
    for (const char* words : {"--dt", "--integrator", "smaller step"})
        EXPECT_EQ(run.err.find(words), std::string::npos) << run.err;
}

TEST(Simulate, CtrlCStopsAtOnceAndKeepsNothingHalf) {
    const Folder folder("interrupt");
    write_small_experiment(folder, 20.0);
    const ProgramRun run = interrupted(folder, "simulate", "0.002", "\"simulate\"");
    EXPECT_EQ(run.status, 130);
    EXPECT_LT(run.seconds_after_signal, 2.0);
    EXPECT_THAT(run.err, HasSubstr("stopped"));
    EXPECT_FALSE(folder.has("out/drop.csv"));
    EXPECT_FALSE(folder.has("out/simulate.json"));
    expect_clean(folder);
}

TEST(Calibrate, WritesEveryKeyOfTheContractAndAPage) {
    const Folder folder("calibrate");
    write_small_experiment(folder, 0.3);
    const ProgramRun run = run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out")}));
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json_of(folder, "calibrate");
    EXPECT_EQ(j.at("schema"), "calibrate/1");
    EXPECT_EQ(j.at("converged"), true);
    for (const char* name : {"youngs_modulus_Pa", "damping_s"})
        for (const char* key : {"value", "std", "start"}) EXPECT_GT(j.at("parameters").at(name).at(key).get<double>(), 0.0) << name << key;
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
    for (const char* text : {"small block", "<svg", "kPa", "drop again", "predicted", "calibrate/1"}) EXPECT_THAT(page, HasSubstr(text));
    for (const char* text : {"http://www.example", "src=", "NaN", "nan,"}) EXPECT_EQ(page.find(text), std::string::npos) << text;
    EXPECT_TRUE(folder.has("out/drop.csv") && folder.has("out/drop_again.csv"));
    expect_clean(folder);
}

TEST(Calibrate, RefusesToFitOnlyWhatIsExact) {
    const Folder folder("calibrate_exact");
    write_small_experiment(folder, 0.3);
    const ProgramRun run =
        run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--parameters", "youngs_modulus"},
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
    ASSERT_EQ(run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resume", "--quiet"})).status, 0);
    const json second = json_of(folder, "calibrate");
    for (const char* name : {"youngs_modulus_Pa", "damping_s"}) EXPECT_EQ(second["parameters"][name]["start"], first["parameters"][name]["value"]) << name;
    EXPECT_NEAR(second["history"][0].at("cost").get<double>() / least, 1.0, 1e-7);   // Newton starts elsewhere
    EXPECT_LE(second["starts"][0].at("cost_after").get<double>(), least * (1.0 + 1e-7));
    EXPECT_EQ(second.at("evaluations_in_all").get<int>(), first.at("evaluations").get<int>() + second.at("evaluations").get<int>());
    EXPECT_NEAR(second.at("rms_before_m").get<double>() / first.at("rms_before_m").get<double>(), 1.0, 1e-6) << "before is still with the declared values";
    run = run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resume", "--parameters", "damping"}));
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("other parameters"));
}

TEST(Calibrate, SeveralStartsAreRepeatedByTheirSeed) {
    const Folder folder("calibrate_starts");
    write_small_experiment(folder, 0.3);
    const std::vector<std::string> words = call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--starts", "3", "--seed", "7"});
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
    ASSERT_EQ(run_program(call({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--parameters", "youngs_modulus", "--quiet"})).status, 0);
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
    EXPECT_LT(run.seconds_after_signal, 5.0);   // it writes a page, and runs nothing more
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
    const ProgramRun run = run_program({"calibrate", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.005", "--json-progress", "--parameters", "youngs_modulus"});
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
    folder.write("exp/experiment.toml", small_toml() + "load = [{kind = \"force\", box_m = [[0.039, -0.001, -0.001], [0.041, 0.021, 0.021]], force_N = [1e300, 0, 0]}]\n");
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

TEST(Simulate, ARealExampleRuns) {
    const fs::path example = shared_data("experiments/example_none");
    if (example.empty()) GTEST_SKIP() << "skipped: no data";
    const Folder folder("example");
    const ProgramRun run = run_program(call({"simulate", example.string(), "--out", folder.str("out"), "--trial", "gravity_release"}));
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json_of(folder, "simulate");
    // The declared modulus is a data sheet's: near, not right.
    EXPECT_LT(j["trials"][0]["rms_m"].get<double>(), 2e-3);
    const Result<Recording> measured = read_trace_csv(example / "gravity_release.csv"), simulated = read_trace_csv(folder.path() / "out/gravity_release.csv");
    ASSERT_TRUE(measured && simulated);
    EXPECT_EQ(simulated->time_s, measured->time_s);
}

}  // namespace
}  // namespace myo::test
