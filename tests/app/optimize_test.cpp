#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/json_at.hpp"
#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "base/text.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/text_table.hpp"
#include "support/corpus.hpp"

namespace myo::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::vector<double> wave{1.0, 0.96, 0.9, 0.93, 1.0, 1.04, 1.02, 0.97, 0.95};  // at 20 Hz

std::string signals_csv() {
    std::string text = "time_s,upper\n";
    for (std::size_t k = 0; k < wave.size(); ++k)
        text += std::to_string(0.05 * static_cast<double>(k)) + "," + std::to_string(wave[k]) + "\n";
    return text;
}

/// The muscled block, its trace made by the program itself from known signals.
void write_muscled_experiment(const Folder& folder) {
    std::string trace = "time_s,tip_x_m,tip_y_m,tip_z_m,middle_x_m,middle_y_m,middle_z_m\n";
    for (int k = 0; k <= 40; ++k) trace += std::to_string(0.01 * k) + ",0.04,0.01,0.02,0.02,0.01,0.02\n";
    folder.write("made/experiment.toml", muscled_toml());
    folder.write("made/signals.csv", signals_csv());
    folder.write("made/wave.csv", trace);
    const ProgramRun run = run_program({"simulate", folder.str("made"), "--out", folder.str("exp"), "--resolution",
                                        "0.01", "--dt", "0.005", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
    folder.write("exp/experiment.toml", muscled_toml());
    folder.write("exp/signals.csv", "time_s,upper\n0,1\n");
}

std::vector<std::string> optimize_call(const Folder& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"optimize", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Optimize, FindsTheSignalsThatMadeTheTrace) {
    const Folder folder("optimize");
    write_muscled_experiment(folder);
    const ProgramRun run = run_program(optimize_call(folder, {"--dt", "0.005"}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("signal upper: 8 values"));
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_EQ(j.at("schema"), "optimize/1");
    EXPECT_EQ(j.at("trial"), "wave");
    EXPECT_EQ(j.at("converged"), true);
    ASSERT_EQ(j.at("signals").size(), 1u);
    EXPECT_EQ(j["signals"][0].at("name"), "upper");
    for (std::size_t k = 1; k < wave.size(); ++k)
        EXPECT_NEAR(j["signals"][0].at("values")[k - 1].get<double>(), wave[k], 1e-3) << k;
    const json& std = j["signals"][0].at("std");
    ASSERT_EQ(std.size(), wave.size() - 1);
    for (const json& value : std) {
        EXPECT_GT(value.get<double>(), 0.0);
        EXPECT_LT(value.get<double>(), 1e-3);
    }
    EXPECT_GE(j.at("std_noise_m").get<double>(), 1e-6);
    EXPECT_THAT(run.out, HasSubstr("±"));
    EXPECT_EQ(j.at("muscles")[1].at("factor"), -0.5);
    EXPECT_LT(j.at("rms_after_m").get<double>(), 1e-3 * j.at("rms_before_m").get<double>());
    EXPECT_EQ(j.at("history").size(), j.at("evaluations").get<std::size_t>());
    expect_keys_of(j, "optimize/optimize.json", {".trials.[].markers"});
    EXPECT_EQ(content_of(folder.path() / "out/optimize.json").find("null"), std::string::npos);
    const std::string page = content_of(folder.path() / "out/report.html");
    for (const char* text :
         {"muscled block", "Signals", "Bands are one standard deviation", "after the fit", "optimize/1", "<svg"})
        EXPECT_THAT(page, HasSubstr(text));
    EXPECT_EQ(page.find("NaN"), std::string::npos);

    // What it wrote is an experiment's file: run with it, the trial follows the trace as well.
    const Result<measurement::ActuationTable> table = measurement::read_actuation_csv(folder.path() /
                                                                                      "out/wave_actuation.csv");
    ASSERT_TRUE(table) << table.error().text();
    EXPECT_EQ(table->muscles, std::vector<std::string>{"upper"});
    folder.write("exp/signals.csv", content_of(folder.path() / "out/wave_actuation.csv"));
    ASSERT_EQ(run_program({"simulate", folder.str("exp"), "--out", folder.str("again"), "--resolution", "0.01", "--dt",
                           "0.005", "--quiet"})
                  .status,
              0);
    EXPECT_NEAR(json_at(folder, "again/simulate.json")["trials"][0]["rms_m"].get<double>(),
                j.at("rms_after_m").get<double>(), 1e-9);
}

TEST(Optimize, HeldSignalsCanBePlayed) {
    const Folder folder("optimize_hold");
    write_muscled_experiment(folder);
    const ProgramRun run = run_program(
        optimize_call(folder, {"--hold", "--frequency", "50", "--smoothness", "0.001", "--dt", "0.005", "--quiet"}));
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_EQ(j.at("interpolation"), "hold");
    EXPECT_EQ(j.at("knot_times_s").size(), 20u);
    EXPECT_LT(j.at("rms_after_m").get<double>(), 0.1 * j.at("rms_before_m").get<double>());
    folder.write("exp/signals.csv", content_of(folder.path() / "out/wave_actuation.csv"));
    ASSERT_EQ(run_program({"simulate", folder.str("exp"), "--out", folder.str("again"), "--resolution", "0.01", "--dt",
                           "0.005", "--quiet"})
                  .status,
              0);
    const double again = json_at(folder, "again/simulate.json")["trials"][0]["rms_m"].get<double>();
    EXPECT_NEAR(again / j.at("rms_after_m").get<double>(), 1.0, 1e-6);
}

/// Makes the trace of the muscled block from these signals, and takes their record away; of markers with so much noise.
void write_unrecorded_experiment(const Folder& folder, const std::string& signals, const std::string& noise_m) {
    write_muscled_experiment(folder);
    folder.write("made/signals.csv", signals);
    const ProgramRun run = run_program({"simulate", folder.str("made"), "--out", folder.str("exp"), "--resolution",
                                        "0.01", "--dt", "0.005", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
    std::string toml = muscled_toml();
    const std::string record = "actuation = \"signals.csv\"\n", noise = "noise_m = 1e-6";
    toml.erase(toml.find(record), record.size());
    toml.replace(toml.find(noise), noise.size(), "noise_m = " + noise_m);
    folder.write("exp/experiment.toml", toml);
}

/// Changes the rows of the experiment's trace, time first.
void edit_trace(const Folder& folder, const std::function<void(double t, std::vector<double>& row)>& edit) {
    const std::string text = content_of(folder.path() / "exp/wave.csv");
    std::string edited;
    for (const measurement::TextLine& line : measurement::split_lines(text)) {
        if (edited.empty()) {
            edited = std::string(line.text) + "\n";
            continue;
        }
        std::vector<double> row;
        for (const std::string_view field : measurement::split_fields(line.text, ','))
            row.push_back(std::stod(std::string(field)));
        edit(row.front(), row);
        for (const double& number : row) edited += (&number == &row.front() ? "" : ",") + format_number(number, 12);
        edited += "\n";
    }
    folder.write("exp/wave.csv", edited);
}

TEST(Optimize, SeeksTheLevelThatWasHeldBeforeTheStart) {
    const Folder folder("optimize_level");
    write_unrecorded_experiment(folder, "time_s,upper\n0,0.9\n0.1,0.9\n0.2,0.97\n0.4,0.97\n", "1e-6");
    for (const bool hold : {false, true}) {
        const ProgramRun run = run_program(
            optimize_call(folder, hold ? std::vector<std::string>{"--hold"} : std::vector<std::string>{}));
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("before t = 0 (sought)"));
        const json j = json_at(folder, "out/optimize.json");
        EXPECT_EQ(j["signals"][0].at("before_sought"), true);
        EXPECT_NEAR(j["signals"][0].at("before").get<double>(), 0.9, 1e-3);
        EXPECT_LT(j["signals"][0].at("std")[0].get<double>(), hold ? 5e-3 : 1e-3);  // steps do not make a ramp
        EXPECT_LT(j.at("rms_after_m").get<double>(), (hold ? 0.2 : 0.001) * j.at("rms_before_m").get<double>());
    }
}

/// All markers are seen 0.4 mm too high; the frame's place is found, not a signal that lifts the body.
TEST(Optimize, SeeksAnUnknownRegistration) {
    const Folder folder("optimize_registration");
    write_unrecorded_experiment(folder, signals_csv(), "1e-6");
    std::string toml = content_of(folder.path() / "exp/experiment.toml");
    toml.insert(toml.find("[markers]"),
                "[registration]\nknown = false\nmax_translation_m = 0.001\nmax_rotation_deg = 0.01\n");
    folder.write("exp/experiment.toml", toml);
    edit_trace(folder, [](double, std::vector<double>& row) {
        for (std::size_t k = 3; k < row.size(); k += 3) row[k] += 4e-4;
    });
    const ProgramRun run = run_program(optimize_call(folder));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("registration (sought): moved by"));
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_NEAR(j.at("registration").at("translation_m")[2].get<double>(), 4e-4, 2e-5);
    EXPECT_EQ(j.at("registration").at("at_bound"), false);
    for (std::size_t k = 0; k < wave.size(); ++k)
        EXPECT_NEAR(j["signals"][0].at("values")[k].get<double>(), wave[k], 5e-3) << k;
    EXPECT_EQ(j.at("reached"), true);
}

/// A record says that the muscle was passive; the body stood elsewhere.
TEST(Optimize, NamesWhatIsNotKnownOfTheStart) {
    const Folder folder("optimize_start");
    write_unrecorded_experiment(folder, "time_s,upper\n0,0.9\n0.4,0.9\n", "1e-5");
    std::string toml = muscled_toml();
    toml.replace(toml.find("noise_m = 1e-6"), 14, "noise_m = 1e-5");
    folder.write("exp/experiment.toml", toml);
    folder.write("exp/signals.csv", "time_s,upper\n0,1\n");
    ProgramRun run = run_program(optimize_call(folder));
    EXPECT_THAT(run.err, HasSubstr("the target does not begin where the body rests: at t = 0 s its markers are"));
    EXPECT_THAT(run.err, HasSubstr("taken from the record"));
    EXPECT_EQ(json_at(folder, "out/optimize.json")["signals"][0].at("before_sought"), false);
    toml.replace(toml.find("start = \"equilibrium\""), 21, "start = \"straight\"");
    folder.write("exp/experiment.toml", toml);
    run = run_program(optimize_call(folder));
    EXPECT_THAT(run.err, HasSubstr("start = \"equilibrium\" seeks it"));
}

TEST(Optimize, SaysThatATargetIsNotReachedByHowMuchAndWhere) {
    const Folder folder("optimize_far");
    write_unrecorded_experiment(folder, "time_s,upper\n0,1\n", "1e-4");
    // The middle marker is asked to go up by 20 mm from 0.15 s to 0.25 s.
    edit_trace(folder, [](double t, std::vector<double>& row) {
        if (t > 0.145 && t < 0.255) row.back() = 0.04;
    });
    const ProgramRun run = run_program(optimize_call(folder));
    EXPECT_EQ(run.status, 0) << run.err;  // the search has done what it can
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_EQ(j.at("reached"), false);
    EXPECT_NEAR(j.at("noise_levels").get<double>(), j.at("rms_after_m").get<double>() / 1e-4, 1e-6);
    EXPECT_EQ(j.at("missed")["markers"][0].at("name"), "middle");
    EXPECT_NEAR(j.at("missed").at("from_s").get<double>(), 0.15, 0.011);
    EXPECT_NEAR(j.at("missed").at("until_s").get<double>(), 0.25, 0.011);
    for (const std::string& said : {run.err, content_of(folder.path() / "out/report.html")}) {
        EXPECT_THAT(said, HasSubstr("the target is not reached: "));
        EXPECT_THAT(said, HasSubstr("farthest off"));
        EXPECT_THAT(said, HasSubstr("middle"));
    }
    EXPECT_THAT(run.out, HasSubstr("target not reached: "));
}

/// The block swings faster than half a sampling interval resolves.
TEST(Optimize, TakesStepsThatSuitTheVibrationsItExcites) {
    const Folder folder("optimize_steps");
    write_muscled_experiment(folder);
    const ProgramRun run = run_program(optimize_call(folder));
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json_at(folder, "out/optimize.json");
    bool told = false;
    for (const json& check : j.at("checks"))
        if (check.at("id") == "step" && check.contains("figure")) {
            told = true;
            EXPECT_LE(check.at("figure").get<double>(), 1.5e-3) << check.dump();
        }
    EXPECT_TRUE(told) << j.at("checks").dump();
    EXPECT_GT(j.at("steps").get<int>(), 2 * 0.4 / 0.005);
}

TEST(Optimize, ATargetThatIsMetFromTheStartEndsAtOnce) {
    const Folder folder("optimize_met");
    write_unrecorded_experiment(folder, "time_s,upper\n0,1\n", "1e-4");
    const ProgramRun run = run_program(optimize_call(folder, {"--starts", "3"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("the target is met from the start"));
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_EQ(j.at("evaluations"), 1);
    EXPECT_EQ(j.at("converged"), true);
    EXPECT_EQ(j.at("reached"), true);
}

TEST(Optimize, CtrlCKeepsTheBestAndResumeGoesOnFromIt) {
    const Folder folder("optimize_interrupt");
    write_muscled_experiment(folder);
    // Small steps, so that there is time to stop it.
    const ProgramRun run = run_program(optimize_call(folder, {"--dt", "0.0005", "--json-progress"}), "\"done\":2.");
    ASSERT_EQ(run.status, 130) << run.err;
    EXPECT_THAT(run.err, HasSubstr("--resume"));
    const json stopped = json_at(folder, "out/optimize.json");
    EXPECT_EQ(stopped.at("stopped"), true);
    EXPECT_LE(stopped.at("loss_after_m2").get<double>(), stopped.at("loss_before_m2").get<double>());
    EXPECT_TRUE(folder.has("out/report.html") && folder.has("out/wave.csv") && folder.has("out/wave_actuation.csv"));
    EXPECT_THAT(stopped.at("std"), HasSubstr("stopped"));

    ProgramRun again = run_program(optimize_call(folder, {"--resume", "--frequency", "10"}));
    EXPECT_EQ(again.status, 2);
    EXPECT_EQ(count_lines(again.err), 1) << again.err;
    EXPECT_THAT(again.err, HasSubstr("other knots"));
    again = run_program(optimize_call(folder, {"--dt", "0.0005", "--resume", "--max-evaluations", "1", "--quiet"}));
    const json resumed = json_at(folder, "out/optimize.json");
    EXPECT_NEAR(resumed.at("loss_before_m2").get<double>() / stopped.at("loss_after_m2").get<double>(), 1.0, 1e-6);
    EXPECT_EQ(resumed.at("evaluations_in_all").get<int>(),
              stopped.at("evaluations").get<int>() + resumed.at("evaluations").get<int>());
}

TEST(Optimize, SeveralStartsAreRepeatedByTheirSeed) {
    const Folder folder("optimize_starts");
    write_muscled_experiment(folder);
    const std::vector<std::string> more{"--starts", "2", "--seed", "5", "--max-evaluations", "4", "--quiet"};
    EXPECT_EQ(run_program(optimize_call(folder, more)).status, 1);  // four are too few
    const json first = json_at(folder, "out/optimize.json");
    ASSERT_EQ(first.at("starts").size(), 2u);
    EXPECT_EQ(first.at("seed"), 5);
    EXPECT_NE(first["starts"][0].at("loss_before_m2"), first["starts"][1].at("loss_before_m2"));
    EXPECT_EQ(run_program(optimize_call(folder, more)).status, 1);
    EXPECT_EQ(json_at(folder, "out/optimize.json").at("signals"), first.at("signals"));
}

TEST(Optimize, BadCallsAreTurnedDownInOneSentence) {
    const Folder folder("optimize_bad");
    write_small_experiment(folder);
    folder.write("muscled/experiment.toml", muscled_toml());
    folder.write("muscled/signals.csv", "time_s,upper\n0,1\n");
    folder.write("muscled/wave.csv", small_trace());
    const std::vector<std::pair<std::vector<std::string>, std::string>> calls{
        {{"optimize", folder.str("exp"), "--out", folder.str("out")}, "muscle"},
        {{"optimize", folder.str("muscled")}, "--out"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--trial", "wawe"}, "did you mean 'wave'"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--frequency", "1000"}, "--frequency"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--frequency", "-1"}, "--frequency"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--smoothness", "-1"}, "--smoothness"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--lowest", "2", "--highest", "1"},
         "--lowest"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--lowest", "0"}, "--lowest"},
        {{"optimize", folder.str("muscled"), "--out", folder.str("out"), "--resume"}, "nothing to resume"},
        {{"gradcheck", folder.str("muscled"), "--trial", "wawe"}, "did you mean 'wave'"},
        {{"gradcheck", folder.str("nowhere")}, "nowhere"},
        {{"gradcheck"}, "experiment folder"},
        {{"gradcheck", folder.str("muscled"), "--steps", "0"}, "--steps"},
    };
    for (auto [words, expected] : calls) {
        if (words.size() > 1) words.insert(words.end(), {"--resolution", "0.01"});
        const ProgramRun run = run_program(words);
        EXPECT_EQ(run.status, 2) << expected;
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        EXPECT_THAT(run.err, HasSubstr(expected));
    }
    EXPECT_FALSE(folder.has("out/optimize.json"));
}

/// A planned trial of the muscled block whose tip shall be somewhere, without any recording.
std::string planned_toml() {
    std::string text = muscled_toml();
    text = text.substr(0, text.find("[[trial]]"));
    return text +
           "[[trial]]\nname = \"reach\"\nrole = \"simulate\"\nduration_s = 0.3\nstart = \"equilibrium\"\n"
           "[[trial.goal]]\nmarker = \"tip\"\nplace_m = [0.038, 0.01, 0.022]\ntime_s = 0.15\nuntil_s = 0.25\n"
           "axes = [\"z\"]\n";
}

TEST(Optimize, ReachesAGoalWithoutARecording) {
    const Folder folder("optimize_goal");
    folder.write("exp/experiment.toml", planned_toml());
    const ProgramRun run = run_program(optimize_call(folder, {"--dt", "0.005"}));
    ASSERT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr("towards 1 goal"));
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_EQ(j.at("target"), "goals");
    EXPECT_GT(j.at("rms_before_m").get<double>(), 1e-3);
    EXPECT_LT(j.at("rms_after_m").get<double>(), 0.1 * j.at("rms_before_m").get<double>());
    EXPECT_THAT(content_of(folder.path() / "out/report.html"), HasSubstr("reach the goals of trial reach"));
    // The signals that were found lead there when the trial is run with them, and stay after the goal.
    const auto found = measurement::read_actuation_csv(folder.path() / "out/reach_actuation.csv");
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_GE(found->time_s.tail(1)(0), 0.25 - 1e-9);
    const ProgramRun gradients = run_program({"gradcheck", folder.str("exp"), "--resolution", "0.01"});
    EXPECT_EQ(gradients.status, 0) << gradients.out << gradients.err;
}

TEST(Gradcheck, TakesTheGoalsOfATrial) {
    const Folder folder("gradcheck_goal");
    std::string text = planned_toml();
    text.replace(text.find("time_s = 0.15"), 13, "time_s = 0.01");
    folder.write("exp/experiment.toml", text);
    const ProgramRun run = run_program({"gradcheck", folder.str("exp"), "--resolution", "0.01", "--dt", "0.005"});
    ASSERT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr("mean square distance of the markers to the goals"));
}

TEST(Gradcheck, EveryParameterOfATrialAgreesWithDifferences) {
    const Folder folder("gradcheck");
    write_small_experiment(folder);
    write_muscled_experiment(folder);
    for (const char* integrator : {"tr_bdf2", "implicit_euler"}) {
        const ProgramRun run = run_program({"gradcheck", folder.str("exp"), "--resolution", "0.01", "--integrator",
                                            integrator, "--json", folder.str("check.json")});
        ASSERT_EQ(run.status, 0) << run.out << run.err;
        for (const char* word :
             {"Young's modulus", "stiffness of upper", "activation of lower", "initial velocities", "median"})
            EXPECT_THAT(run.out, HasSubstr(word));
        const json j = json_at(folder, "check.json");
        EXPECT_EQ(j.at("schema"), "gradcheck/1");
        EXPECT_EQ(j.at("integrator"), integrator);
        EXPECT_EQ(j.at("against_trace"), true);
        EXPECT_LE(j.at("median_relative_error").get<double>(), 1e-6);
        EXPECT_LE(j.at("worst_relative_error").get<double>(), 1e-5);
        EXPECT_GE(j.at("parameters").size(), 10u);
        for (const json& row : j["parameters"]) EXPECT_NE(row.at("adjoint").get<double>(), 0.0) << row;
    }
}

}  // namespace
}  // namespace myo::test
