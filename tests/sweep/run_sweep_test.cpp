#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "app/sweep_texts.hpp"
#include "base/files.hpp"
#include "base/folder_lock.hpp"
#include "sweep/run_sweep.hpp"
#include "sweep/sweep_table.hpp"

// Cases are run by a script here that behaves as its option --mode says, so that every end of a command occurs.

namespace myo::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;
using sweep::CaseState;

const char* const script = R"(#!/bin/bash
folder=$2
echo "$(basename -- "$folder") $*" >>"$(dirname -- "$0")/calls"
words="$*"
mode=${words#*--mode }
case ${mode%% *} in
  converges) echo '{"converged": true, "reached": true, "rms_after_m": 0.002}' >"$folder/optimize.json" ;;
  ends_early) echo '{"converged": false, "rms_after_m": 0.003}' >"$folder/optimize.json"
              echo "myoloop: the search did not converge" >&2; exit 1 ;;
  fails) echo "myoloop: warning: careful" >&2; echo "myoloop: no memory" >&2; echo "other" >&2; exit 1 ;;
  says_nothing) exit 3 ;;
  no_report) ;;
  other_form) echo '[1, 2]' >"$folder/optimize.json" ;;
  is_killed) kill -9 $$ ;;
  is_stopped) exit 130 ;;
  waits) echo half >"$folder/.part"; trap 'exit 130' TERM; while :; do sleep 0.01; done ;;
esac
)";

/// A sweep over modes, prepared to run by the script.
struct FakeSweep {
    Folder folder;
    sweep::PreparedSweep prepared;
    sweep::SweepRun run;

    FakeSweep(const std::string& name, const std::string& modes) : folder(name) {
        write_sweep(folder, sweep_head("optimize") + axis("--mode", modes));
        folder.write("bin/run", script);
        fs::permissions(folder.path() / "bin/run", fs::perms::owner_all);
        const Result<sweep::Sweep> read = sweep::read_sweep(folder.path() / "sweep.toml");
        const auto any = [](const std::string&, const std::vector<std::string>&) { return Result<void>(); };
        prepared = *sweep::prepare_sweep(*read, any, "0.1");
        run.program = folder.path() / "bin/run";
        run.grace_s = 10.0;
    }

    fs::path out() const { return folder.path() / "out"; }
    Result<void> work(const Progress& progress = {}) const { return sweep::run_sweep(prepared, out(), run, progress); }
    std::vector<CaseState> states() const {
        std::vector<CaseState> list;
        for (const sweep::SweepRow& row : sweep::sweep_table(prepared, out()).rows) list.push_back(row.state);
        return list;
    }
    /// Lines of the script's calls.
    std::vector<std::string> calls() const {
        std::vector<std::string> list;
        std::ifstream lines(folder.path() / "bin/calls");
        for (std::string line; std::getline(lines, line);) list.push_back(line);
        return list;
    }
};

TEST(RunSweep, EveryEndOfACommandHasItsStateAndMessage) {
    FakeSweep fake("sweep_ends", R"(["converges", "ends_early", "fails", "says_nothing", "no_report", "other_form",
                                     "is_killed", "is_stopped"])");
    fake.run.jobs = 3;
    ASSERT_TRUE(fake.work());
    const sweep::SweepTable table = sweep::sweep_table(fake.prepared, fake.out());
    EXPECT_THAT(fake.states(),
                ElementsAre(CaseState::done, CaseState::unconverged, CaseState::failed, CaseState::failed,
                            CaseState::failed, CaseState::failed, CaseState::failed, CaseState::not_run));
    EXPECT_EQ(table.rows[0].result.verdict, "reached");
    for (const std::size_t row : {0u, 1u}) {
        const sweep::CaseNumber* const rms = table.rows[row].find("rms of the target");
        ASSERT_NE(rms, nullptr);
        EXPECT_EQ(rms->value, row == 0 ? 0.002 : 0.003);
    }
    EXPECT_EQ(table.rows[1].message, "the search did not converge");
    EXPECT_EQ(table.rows[2].message, "no memory");
    EXPECT_EQ(table.rows[3].message, "exit status 3");
    EXPECT_THAT(table.rows[4].message, HasSubstr("optimize.json: file not found"));
    EXPECT_THAT(table.rows[5].message, HasSubstr("optimize.json: is no report"));
    EXPECT_THAT(table.rows[6].message, HasSubstr("ended by signal 9"));
    EXPECT_EQ(table.missing(), 1);
    EXPECT_EQ(fake.calls().size(), 8u);
    // One thread, and the folder of the case for both.
    const std::string folder = sweep::case_folder(fake.out(), 1).string();
    EXPECT_THAT(fake.calls(), ::testing::Contains("0001 optimize " + folder +
                                                  " --resolution 0.01 --mode converges --threads 1 --out " + folder));
}

TEST(RunSweep, OnlyWhatHasNotEndedIsRunAgain) {
    FakeSweep fake("sweep_resumes", R"(["converges", "ends_early", "fails", "is_stopped"])");
    ASSERT_TRUE(fake.work());
    ASSERT_TRUE(fake.work());
    ASSERT_EQ(fake.calls().size(), 5u);
    EXPECT_THAT(fake.calls()[4], HasSubstr("0004 optimize"));
    fake.run.retry = true;
    ASSERT_TRUE(fake.work());
    ASSERT_EQ(fake.calls().size(), 7u);
    EXPECT_THAT(fake.calls()[5], HasSubstr("0003 optimize"));
}

TEST(RunSweep, ACaseOfAProcessThatWasKilledIsRunAgain) {
    const FakeSweep fake("sweep_killed", R"(["converges"])");
    // What such a process leaves: a marker without an end, half a report.
    const fs::path folder = sweep::case_folder(fake.out(), 1);
    ASSERT_TRUE(write_file(
        folder / "case.json",
        "{\"fingerprint\": \"" + sweep::fingerprint_text(fake.prepared.cases[0]) + "\", \"state\": \"running\"}"));
    ASSERT_TRUE(write_file(folder / "optimize.json", "{\"conv"));
    ASSERT_TRUE(write_file(folder / "trial.csv", "half"));
    EXPECT_THAT(fake.states(), ElementsAre(CaseState::not_run));
    ASSERT_TRUE(fake.work());
    EXPECT_THAT(fake.states(), ElementsAre(CaseState::done));
    EXPECT_FALSE(fs::exists(folder / "trial.csv"));
}

TEST(RunSweep, CasesThatAnotherProcessRunsAreLeftToIt) {
    const FakeSweep fake("sweep_locked", R"(["converges", "converges "])");
    fs::create_directories(fake.out() / "cases");
    {
        const Result<FolderLock> other = FolderLock::take_file(sweep::case_folder(fake.out(), 1));
        ASSERT_TRUE(other);
        ASSERT_TRUE(fake.work());
        ASSERT_EQ(fake.calls().size(), 1u);
        EXPECT_THAT(fake.calls()[0], HasSubstr("0002 optimize"));
    }
    // A command may outlive its sweep: it holds the lock of its folder.
    fs::create_directories(sweep::case_folder(fake.out(), 1));
    {
        const Result<FolderLock> orphan = FolderLock::take(sweep::case_folder(fake.out(), 1));
        ASSERT_TRUE(orphan);
        ASSERT_TRUE(fake.work());
        EXPECT_EQ(fake.calls().size(), 1u);
    }
    ASSERT_TRUE(fake.work());
    EXPECT_EQ(fake.calls().size(), 2u);
}

/// A folder in the place of the lock stands for one that this user cannot write.
TEST(RunSweep, ACaseThatCannotBeLockedEndsTheSweepWithItsReason) {
    const FakeSweep fake("sweep_unlockable", R"(["converges", "converges "])");
    fs::create_directories(fake.out() / "cases/.0001.lock");
    const Result<void> worked = fake.work();
    ASSERT_FALSE(worked);
    EXPECT_THAT(worked.error().text(), HasSubstr("cases/.0001.lock: cannot be made: Is a directory"));
    EXPECT_THAT(fake.calls(), ::testing::IsEmpty());
}

TEST(RunSweep, TwoAtOnceRunEveryCaseOnce) {
    const FakeSweep fake("sweep_twice",
                         R"(["converges", "fails", "converges x", "ends_early", "fails x", "no_report"])");
    std::thread other([&] { EXPECT_TRUE(fake.work()); });
    EXPECT_TRUE(fake.work());
    other.join();
    EXPECT_EQ(fake.calls().size(), 6u);
    EXPECT_EQ(sweep::sweep_table(fake.prepared, fake.out()).missing(), 0);
}

TEST(RunSweep, AStopEndsTheCasesAtWorkAndRemovesThem) {
    FakeSweep fake("sweep_stop", R"(["waits", "waits x", "waits y"])");
    fake.run.jobs = 2;
    std::atomic<bool> stop{false};
    std::thread user([&] {
        while (fake.calls().size() < 2u) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        stop = true;
    });
    EXPECT_TRUE(fake.work(Progress({}, &stop)));
    user.join();
    EXPECT_EQ(fake.calls().size(), 2u);
    EXPECT_TRUE(fs::is_empty(fake.out() / "cases"));
    EXPECT_EQ(sweep::sweep_table(fake.prepared, fake.out()).missing(), 3);
}

}  // namespace
}  // namespace myo::test
