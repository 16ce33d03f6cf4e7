#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/experiment_calls.hpp"

// myoloop power and myoloop propose, from call to files.

namespace myo::test {
namespace {

using ::testing::HasSubstr;

TEST(Power, WritesItsMap) {
    const Folder folder("power_command");
    write_small_experiment(folder);
    const ProgramRun run = run_program(call({"power", folder.str("exp"), "--out", folder.str("out"), "--json",
                                             folder.str("map.json"), "--effects", "quadratic_drag,linear_drag"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("probability of detection"));
    EXPECT_THAT(run.out, HasSubstr("quadratic_drag"));
    const nlohmann::json map = json_of(folder, "power");
    EXPECT_EQ(map.at("schema"), "power/1");
    EXPECT_EQ(map.at("effects").size(), 2u);
    EXPECT_EQ(content_of(folder.path() / "map.json"), content_of(folder.path() / "out/power.json"));
    EXPECT_TRUE(folder.has("out/power.html"));
    expect_clean(folder);
}

TEST(Power, NeedsNoFolderForResults) {
    const Folder folder("power_alone");
    write_small_experiment(folder);
    const ProgramRun run = run_program(call({"power", folder.str("exp"), "--effects", "quadratic_drag"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_FALSE(folder.has("out"));
}

TEST(Propose, WritesATrialThatTheProgramRuns) {
    const Folder folder("propose_command");
    write_small_experiment(folder);
    const ProgramRun run = run_program(call({"propose", folder.str("exp"), "--out", folder.str("out"), "--between",
                                             "linear_drag", "--between", "point_mass", "--limits", "force_N=0.01"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("[[trial]]"));
    const nlohmann::json proposal = json_of(folder, "proposal");
    EXPECT_EQ(proposal.at("next_experiment").at("trial"), content_of(folder.path() / "out/next_trial.toml"));
    EXPECT_TRUE(folder.has("out/proposal.html"));
    expect_clean(folder);
    folder.write("exp/experiment.toml", small_toml() + content_of(folder.path() / "out/next_trial.toml"));
    EXPECT_EQ(run_program(call({"simulate", folder.str("exp"), "--out", folder.str("run")})).status, 0);
}

/// Trials are tried in memory: TMPDIR may lead nowhere.
TEST(Propose, NeedsNoTemporaryFolder) {
    const Folder folder("propose_no_tmpdir");
    write_small_experiment(folder);
    const std::string program = (std::filesystem::path(MYOLOOP_BINARY_DIR) / "myoloop").string();
    const std::string command = "TMPDIR='" + folder.str("nowhere") + "' '" + program + "' propose '" +
                                folder.str("exp") + "' --out '" + folder.str("out") +
                                "' --between linear_drag --between point_mass --limits force_N=0.01 --resolution 0.01" +
                                " >'" + folder.str("said") + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << content_of(folder.path() / "said");
    EXPECT_TRUE(folder.has("out/next_trial.toml"));
}

struct WrongPlan {
    std::vector<std::string> arguments;
    std::vector<std::string> expected;
};

class WrongPlans : public ::testing::TestWithParam<WrongPlan> {};

TEST_P(WrongPlans, AreTurnedDownInOneSentence) {
    const Folder folder("wrong_plan");
    write_small_experiment(folder);
    std::vector<std::string> arguments;
    for (const std::string& word : GetParam().arguments)
        arguments.push_back(word == "EXP"            ? folder.str("exp")
                            : word == "EXP/drop.csv" ? folder.str("exp/drop.csv")
                                                     : word);
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    for (const std::string& text : GetParam().expected) EXPECT_THAT(run.err, HasSubstr(text));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongPlans,
    ::testing::Values(
        WrongPlan{{"power"}, {"experiment folder"}}, WrongPlan{{"power", "nowhere"}, {"nowhere"}},
        WrongPlan{{"power", "EXP", "--effects", "linear_drg"}, {"--effects", "did you mean 'linear_drag'"}},
        WrongPlan{{"power", "EXP", "--numerical-error", "-1"}, {"--numerical-error", "positive"}},
        WrongPlan{{"power", "EXP", "--json", "EXP/drop.csv"}, {"--json", "drop.csv"}},
        WrongPlan{{"propose", "EXP"}, {"--between", "--report"}},
        WrongPlan{{"propose", "EXP", "--between", "linear_drag"}, {"--between", "twice"}},
        WrongPlan{{"propose", "EXP", "--between", "linear_drag", "--between", "linear_drag"}, {"--between", "same"}},
        WrongPlan{{"propose", "EXP", "--between", "magic", "--between", "none"}, {"--between", "magic"}},
        WrongPlan{{"propose", "EXP", "--between", "none", "--between", "linear_drag", "--limits", "force=1"},
                  {"--limits", "force_N"}},
        WrongPlan{{"propose", "EXP", "--between", "none", "--between", "linear_drag", "--limits", "force_N=x"},
                  {"--limits", "positive number"}},
        WrongPlan{{"propose", "EXP", "--report", "EXP/drop.csv"}, {"drop.csv"}},
        WrongPlan{{"propose", "EXP", "--report", "nowhere.json"}, {"nowhere.json"}}));

}  // namespace
}  // namespace myo::test
