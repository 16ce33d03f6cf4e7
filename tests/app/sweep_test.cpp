#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/sweep_calls.hpp"

namespace myo::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

// A trial of 50 ms is enough to tell cases apart.
constexpr double end_s = 0.05;
const std::string two_moduli = axis("material.youngs_modulus_Pa", "[2.0e4, 3.0e4]");
const std::string two_meshes = axis("--element", "[\"hex8\", \"tet10\"]");

/// What a command says of the case with these values, called by hand.
json by_hand(const Folder& folder, const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> words{command, folder.str("exp"), "--out", folder.str("hand"), "--resolution",
                                   "0.01",  "--threads",       "1",     "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(words).status, 0);
    return json_at(folder, ("hand/" + command + ".json").c_str());
}

TEST(Sweep, AGridGivesTheNumbersOfTheCommandByHand) {
    const Folder folder("sweep_grid");
    write_sweep(folder, sweep_head() + two_moduli + two_meshes, end_s);
    const ProgramRun run = run_sweep(folder);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("4 cases: 4 done"));
    const json rows = sweep_rows(folder);
    ASSERT_EQ(rows.size(), 4u);
    std::size_t at = 0;
    // The last axis changes fastest.
    for (const double modulus : {2.0e4, 3.0e4})
        for (const char* element : {"hex8", "tet10"}) {
            const json& row = rows[at++];
            EXPECT_EQ(row.at("values").at("material.youngs_modulus_Pa"), modulus);
            EXPECT_EQ(row.at("values").at("--element"), element);
            const json hand = by_hand(
                folder, "simulate",
                {"--set", "material.youngs_modulus_Pa=" + std::to_string(modulus), "--element", element});
            for (const json& trial : hand.at("trials")) {
                const std::string name = trial.at("name");
                EXPECT_EQ(number_of(row, "rms of " + name), trial.at("rms_m").get<double>());
                EXPECT_EQ(number_of(row, "tip z at rest in " + name),
                          trial.at("markers").at("tip").at("steady_state_m").at(2).get<double>());
            }
        }
    EXPECT_NE(number_of(rows[0], "rms of drop"), number_of(rows[1], "rms of drop"));
    EXPECT_NE(number_of(rows[0], "rms of drop"), number_of(rows[2], "rms of drop"));
    const std::string csv = content_of(folder.path() / "out/sweep.csv"),
                      page = content_of(folder.path() / "out/sweep.html");
    EXPECT_EQ(count_lines(csv), 5);
    EXPECT_THAT(csv, HasSubstr("case,material.youngs_modulus_Pa,--element,state,verdict,rms of drop [m],"));
    EXPECT_THAT(csv, HasSubstr("\n2,20000,tet10,done,,"));
    EXPECT_THAT(page, HasSubstr("material.youngs modulus [kPa]"));
    EXPECT_THAT(page, HasSubstr("rms of drop [mm]"));
}

TEST(Sweep, FinishedCasesAreNotRepeated) {
    const Folder folder("sweep_again");
    write_sweep(folder, sweep_head() + two_moduli, end_s);
    ASSERT_EQ(run_sweep(folder).status, 0);
    const fs::path first = folder.path() / "out/cases/0001", second = folder.path() / "out/cases/0002";
    const auto time_of = [](const fs::path& case_folder) { return fs::last_write_time(case_folder / "case.json"); };
    const auto first_time = time_of(first), second_time = time_of(second);
    fs::remove_all(second);
    const ProgramRun again = run_sweep(folder);
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(time_of(first), first_time);
    EXPECT_NE(time_of(second), second_time);
    EXPECT_THAT(again.out, HasSubstr("\n2 cases: 2 done"));
    EXPECT_THAT(again.out, Not(HasSubstr("= 20000  done")));
    EXPECT_THAT(run_sweep(folder, {"--list"}).out, HasSubstr("= 20000  done"));
}

TEST(Sweep, CasesOfOtherDataAreRefusedOrReplaced) {
    const Folder folder("sweep_changed");
    write_sweep(folder, sweep_head() + axis("material.youngs_modulus_Pa", "[2.0e4]"), end_s);
    ASSERT_EQ(run_sweep(folder).status, 0);
    const double before = number_of(sweep_rows(folder)[0], "rms of drop");
    folder.write("exp/drop.csv", small_trace(0.04));
    const ProgramRun refused = run_sweep(folder);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("0001: was run with other values, options, data"));
    EXPECT_EQ(number_of(sweep_rows(folder)[0], "rms of drop"), before);
    EXPECT_EQ(run_sweep(folder, {"--replace"}).status, 0);
    EXPECT_NE(number_of(sweep_rows(folder)[0], "rms of drop"), before);
}

TEST(Sweep, AFailedCaseIsARow) {
    const Folder folder("sweep_failed");
    write_sweep(folder, sweep_head() + axis("--trial", "[\"nowhere\", \"drop\"]"), end_s);
    const ProgramRun run = run_sweep(folder, {"--jobs", "1"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("2 cases: 1 done, 1 failed"));
    const json rows = sweep_rows(folder);
    EXPECT_EQ(rows[0].at("state"), "failed");
    EXPECT_THAT(rows[0].at("message").get<std::string>(), HasSubstr("--trial: no trial 'nowhere'"));
    EXPECT_EQ(rows[1].at("state"), "done");
    EXPECT_FALSE(rows[1].at("numbers").empty());
    // It is repeated on request only.
    EXPECT_THAT(run_sweep(folder).out, Not(HasSubstr("--trial = ")));
    EXPECT_THAT(run_sweep(folder, {"--retry"}).out, HasSubstr("--trial = nowhere  failed"));
}

TEST(Sweep, IsAFailureWhereEveryCaseFails) {
    const Folder folder("sweep_all_failed");
    write_sweep(folder, sweep_head() + axis("--trial", "[\"nowhere\"]"));
    const ProgramRun run = run_sweep(folder);
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("every case failed"));
}

TEST(Sweep, FittedValuesHaveTheirDeviations) {
    const Folder folder("sweep_fit");
    write_sweep(folder, sweep_head("calibrate") + axis("material.poissons_ratio", "[0.45]") + "[[vary]]\n" +
                            "key = \"trial.drop again.role\"\nvalues = [\"validate\"]\ntogether = true\n");
    const ProgramRun run = run_sweep(folder);
    ASSERT_EQ(run.status, 0) << run.err;
    const json hand = by_hand(folder, "calibrate", {}), row = sweep_rows(folder)[0];
    ASSERT_FALSE(hand.at("parameters").empty());
    for (const auto& [name, parameter] : hand.at("parameters").items()) {
        EXPECT_EQ(number_of(row, name), parameter.at("value").get<double>());
        EXPECT_EQ(row.at("numbers").at(name).at("std"), parameter.at("std"));
        EXPECT_EQ(row.at("numbers").at(name).at("unit"), parameter.at("unit"));
    }
    EXPECT_EQ(number_of(row, "rms of the fit"), hand.at("rms_after_m").get<double>());
    EXPECT_EQ(number_of(row, "rms of the validation trials"), hand.at("validation_rms_after_m").get<double>());
    EXPECT_EQ(row.at("verdict"), "converged");
}

TEST(Sweep, WhatTheCommandDoesNotTakeIsRefusedBeforeAnyCase) {
    const Folder folder("sweep_refused");
    const auto refused = [&](const std::string& name, const std::string& values) {
        write_sweep(folder, sweep_head() + axis(name, values));
        const ProgramRun run = run_sweep(folder);
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        EXPECT_FALSE(folder.has("out"));
        return run.err;
    };
    EXPECT_THAT(refused("--resolutoin", "[0.01]"), HasSubstr("sweep.toml:5: case 1 (--resolutoin = 0.01): unknown "
                                                             "option '--resolutoin' is not known; did you mean "
                                                             "'--resolution'"));
    EXPECT_THAT(refused("--dt", "[0.001, \"fast\"]"), HasSubstr(":5: case 2 (--dt = fast): --dt: 'fast' is not a"));
    EXPECT_THAT(refused("material.youngs_modulus_Pa", "[]"), HasSubstr("vary[0].values: holds no value"));
}

TEST(Sweep, SharesOfSeveralProcessesMakeOneTable) {
    const Folder folder("sweep_shares");
    write_sweep(folder, sweep_head() + axis("material.youngs_modulus_Pa", "[2.0e4, 3.0e4, 4.0e4]"), end_s);
    EXPECT_THAT(run_sweep(folder, {"--share", "1/2"}).out, HasSubstr("3 cases: 1 done, 2 not run yet"));
    EXPECT_EQ(sweep_rows(folder)[0].at("state"), "not run");
    EXPECT_THAT(run_sweep(folder, {"--share", "2/2"}).out, HasSubstr("3 cases: 3 done"));
    fs::remove(folder.path() / "out/sweep.json");
    EXPECT_THAT(run_sweep(folder, {"--collect"}).out, HasSubstr("3 cases: 3 done"));
    EXPECT_TRUE(folder.has("out/sweep.json"));
}

TEST(Sweep, FoldersOfCasesNeverReplaceForeignFiles) {
    const Folder folder("foreign_case");
    write_sweep(folder, sweep_head() + two_moduli);
    folder.write("out/cases/0001/thesis.txt", "years of work");
    const ProgramRun run = run_sweep(folder, {"--jobs", "1"});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("0001: holds files that no sweep wrote"));
    EXPECT_TRUE(folder.has("out/cases/0001/thesis.txt"));
}

TEST(Sweep, AStoppedOneLeavesWholeCasesOnlyAndContinues) {
    const Folder folder("sweep_stopped");
    // The second case takes long, and is at work when the first has ended.
    write_sweep(
        folder,
        "schema = \"sweep/1\"\nexperiment = \"exp\"\ncommand = \"simulate\"\n" + axis("--resolution", "[0.01, 0.0025]"),
        0.4);
    const ProgramRun stopped = run_sweep(folder, {"--jobs", "2", "--json-progress"}, "\"done\":1.0");
    EXPECT_EQ(stopped.status, 130) << stopped.err;
    EXPECT_LT(stopped.seconds_after_signal, 5.0);
    EXPECT_THAT(stopped.err, HasSubstr("stopped; finished cases are kept"));
    EXPECT_TRUE(folder.has("out/cases/0001/simulate.json"));
    EXPECT_FALSE(folder.has("out/cases/0002"));
    EXPECT_FALSE(folder.has("out/sweep.csv"));
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path() / "out"))
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
    const ProgramRun again = run_sweep(folder);
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_THAT(again.out, Not(HasSubstr("--resolution = 0.01  done")));
    EXPECT_THAT(again.out, HasSubstr("2 cases: 2 done"));
}

}  // namespace
}  // namespace myo::test
