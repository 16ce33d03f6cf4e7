#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/json_at.hpp"
#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "support/experiment_folder.hpp"

// `myoloop optimize --seek`: the body as what is sought.

namespace myo::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing_support::replaced;

const std::string contraction = "time_s,upper\n0,1\n0.1,0.9\n0.4,0.9\n";

/// The muscled block whose upper fibres are turned by 20 degrees makes the trace; the experiment says they are not.
void write_turned_experiment(const Folder& folder) {
    std::string trace = "time_s,tip_x_m,tip_y_m,tip_z_m,middle_x_m,middle_y_m,middle_z_m\n";
    for (int k = 0; k <= 40; ++k) trace += std::to_string(0.01 * k) + ",0.04,0.01,0.02,0.02,0.01,0.02\n";
    const double angle = 20.0 * std::numbers::pi / 180.0;
    folder.write("made/experiment.toml", replaced(muscled_toml(), "fibre = [1.0, 0.0, 0.0]",
                                                  "fibre = [" + std::to_string(std::cos(angle)) + ", " +
                                                      std::to_string(std::sin(angle)) + ", 0.0]"));
    folder.write("made/signals.csv", contraction);
    folder.write("made/wave.csv", trace);
    const ProgramRun run = run_program({"simulate", folder.str("made"), "--out", folder.str("exp"), "--resolution",
                                        "0.01", "--dt", "0.005", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
    folder.write("exp/experiment.toml", muscled_toml());
    folder.write("exp/signals.csv", contraction);
}

ProgramRun seek(const Folder& folder, const std::string& what, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{
        "optimize", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01", "--dt",
        "0.005",    "--seek",          what};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
}

TEST(OptimizeDesign, WritesAnExperimentThatReproducesTheRun) {
    const Folder folder("optimize_design");
    write_turned_experiment(folder);
    ProgramRun run = seek(folder, "direction:upper,modulus");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("fibre direction of upper: turned by"));
    EXPECT_THAT(run.out, HasSubstr("Young's modulus of the body: from"));
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_LT(j.at("rms_after_m").get<double>(), 0.05 * j.at("rms_before_m").get<double>());
    EXPECT_EQ(j.at("seek"), json::parse(R"(["direction:upper", "modulus"])"));
    ASSERT_EQ(j.at("design").at("items").size(), 2u);
    const std::vector<double> fibre = j["design"]["items"][0].at("fibre");
    EXPECT_NEAR(std::abs(fibre[1] / fibre[0]), std::tan(20.0 * std::numbers::pi / 180.0), 0.02);
    EXPECT_TRUE(j.at("signals").empty());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/wave_actuation.csv")) << "no signal was sought";
    EXPECT_EQ(content_of(folder.path() / "out/optimize.json").find("null"), std::string::npos);
    const std::string page = content_of(folder.path() / "out/report.html");
    for (const char* text : {"Body", "fibre direction of upper", "experiment_optimized.toml"})
        EXPECT_THAT(page, HasSubstr(text));
    EXPECT_EQ(page.find("NaN"), std::string::npos);

    run = run_program({"simulate", folder.str("out/experiment_optimized.toml"), "--out", folder.str("again"),
                       "--resolution", "0.01", "--dt", "0.005", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(json_at(folder, "again/simulate.json")["trials"][0]["rms_m"].get<double>(),
                j.at("rms_after_m").get<double>(), 1e-7);
    // It goes on where it stopped: nothing is left to gain.
    run = seek(folder, "direction:upper,modulus", {"--resume"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_LE(json_at(folder, "out/optimize.json").at("rms_after_m").get<double>(),
              1.001 * j.at("rms_after_m").get<double>());
    EXPECT_GT(json_at(folder, "out/optimize.json").at("evaluations_in_all").get<int>(),
              j.at("evaluations_in_all").get<int>());
    EXPECT_EQ(seek(folder, "modulus", {"--resume"}).status, 2) << "another search";
}

TEST(OptimizeDesign, SignalsAndBodyAreSoughtTogether) {
    const Folder folder("optimize_both");
    write_turned_experiment(folder);
    folder.write("exp/signals.csv", "time_s,upper\n0,1\n");
    const ProgramRun run = seek(folder, "signals,direction:upper");
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json_at(folder, "out/optimize.json");
    EXPECT_LT(j.at("rms_after_m").get<double>(), 0.05 * j.at("rms_before_m").get<double>());
    EXPECT_EQ(j.at("signals").size(), 1u);
    const ProgramRun again = run_program({"simulate", folder.str("out/experiment_optimized.toml"), "--out",
                                          folder.str("again"), "--resolution", "0.01", "--dt", "0.005", "--quiet"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_NEAR(json_at(folder, "again/simulate.json")["trials"][0]["rms_m"].get<double>(),
                j.at("rms_after_m").get<double>(), 1e-6);
}

TEST(OptimizeDesign, RefusesWhatIsNotThere) {
    const Folder folder("optimize_refused");
    write_turned_experiment(folder);
    for (const auto& [what, words] :
         std::vector<std::pair<std::string, std::string>>{{"direction:tail", "no muscle is called \"tail\""},
                                                          {"weights:upper", "is not painted"},
                                                          {"modulus:tip", "no part is called \"tip\""},
                                                          {"fibres", "is none of signals"}}) {
        const ProgramRun run = seek(folder, what);
        EXPECT_EQ(run.status, 2) << what;
        EXPECT_THAT(run.err, HasSubstr(words));
        EXPECT_THAT(run.err, HasSubstr("--seek"));
    }
}

}  // namespace
}  // namespace myo::test
