#include "sweep/case_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>

#include "base/files.hpp"
#include "base/folder_lock.hpp"
#include "support/folder.hpp"

// The folder of a case: its marker, what is kept in it and what a run may remove.

namespace myo::sweep::case_folder_test {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr CaseState every_state[] = {CaseState::not_run,     CaseState::running, CaseState::done,
                                     CaseState::unconverged, CaseState::failed,  CaseState::stopped};

/// A command that lists its arguments and ends as `ending` says.
fs::path command_that(const test::Folder& folder, const std::string& ending) {
    folder.write("bin/run", "#!/bin/bash\nfolder=$2\necho \"$*\" >\"$0.calls\"\n" + ending + "\n");
    fs::permissions(folder.path() / "bin/run", fs::perms::owner_all);
    return folder.path() / "bin/run";
}

/// A diagnosis of one case in "case" whose declaration names a file of "exp".
struct OneCase {
    test::Folder folder;
    CaseRunner runner;
    SweepCase one{.number = 3, .text = "trace = \"drop.csv\"\n", .options = {"--seed", "4"}, .fingerprint = 0xabc};

    OneCase(const std::string& name, const std::string& ending) : folder(name) {
        runner = {command_that(folder, ending), CaseCommand::diagnose, folder.path() / "exp", 5.0};
    }
    fs::path place() const { return folder.path() / "case"; }
    std::string content(const std::string& file) const { return *read_file(place() / file); }
    std::string calls() const { return *read_file(folder.path() / "bin/run.calls"); }
    Result<CaseMarker> work(const Progress& progress = {}) const { return run_case(runner, one, place(), progress); }
};

TEST(CaseFolder, NamesSortByNumberAndGrowBeyondFourDigits) {
    EXPECT_EQ(case_folder("out", 7), fs::path("out/cases/0007"));
    EXPECT_EQ(case_folder("out", 9999), fs::path("out/cases/9999"));
    EXPECT_EQ(case_folder("out", 10000), fs::path("out/cases/10000"));
}

TEST(CaseFolder, AFingerprintIsSixteenDigitsWhateverItsSize) {
    EXPECT_EQ(fingerprint_text({.fingerprint = 0}), "0000000000000000");
    EXPECT_EQ(fingerprint_text({.fingerprint = 0xabc}), "0000000000000abc");
    EXPECT_EQ(fingerprint_text({.fingerprint = 0xfedcba9876543210ULL}), "fedcba9876543210");
}

TEST(CaseFolder, StatesHaveWordsOfTheirOwnAndThreeOfThemAreEnds) {
    std::set<std::string> words;
    for (const CaseState state : every_state) words.insert(to_string(state));
    EXPECT_EQ(words.size(), std::size(every_state));
    EXPECT_FALSE(words.contains(""));
    for (const CaseState state : every_state)
        EXPECT_EQ(has_ended(state),
                  state == CaseState::done || state == CaseState::unconverged || state == CaseState::failed)
            << to_string(state);
}

TEST(CaseFolder, AMarkerIsReadInEveryState) {
    const test::Folder folder("markers");
    for (const CaseState state : every_state) {
        folder.write("case.json", "{\"fingerprint\": \"12ab\", \"state\": \"" + to_string(state) +
                                      "\", \"message\": \"why\", \"seconds\": 2.5}");
        const std::optional<CaseMarker> marker = read_marker(folder.path());
        ASSERT_TRUE(marker);
        EXPECT_EQ(marker->state, state) << to_string(state);
        EXPECT_EQ(marker->fingerprint, "12ab");
        EXPECT_EQ(marker->message, "why");
        EXPECT_EQ(marker->seconds, 2.5);
    }
}

/// A marker is read while another program writes it, or a later version of this one: nothing in it ends the sweep.
TEST(CaseFolder, AMarkerThatIsNoneCountsAsNotRun) {
    const test::Folder folder("odd_markers");
    EXPECT_FALSE(read_marker(folder.path()));
    for (const char* text : {"", "{\"state\": ", "[]", "3", "null", "\"done\""}) {
        folder.write("case.json", text);
        EXPECT_FALSE(read_marker(folder.path())) << text;
    }
    for (const char* text : {"{}", "{\"state\": \"finished\"}", "{\"state\": 2, \"seconds\": \"1\", \"message\": []}",
                             "{\"fingerprint\": null}"}) {
        folder.write("case.json", text);
        const std::optional<CaseMarker> marker = read_marker(folder.path());
        ASSERT_TRUE(marker) << text;
        EXPECT_EQ(marker->state, CaseState::not_run) << text;
        EXPECT_EQ(marker->fingerprint + marker->message, "") << text;
        EXPECT_EQ(marker->seconds, 0.0) << text;
    }
}

TEST(CaseFolder, ARunLeavesItsMarkerExperimentAndWords) {
    const OneCase c("case_done", "echo found; echo 'myoloop: note' >&2");
    const Result<CaseMarker> marker = c.work();
    ASSERT_TRUE(marker) << marker.error().text();
    EXPECT_EQ(marker->state, CaseState::done);
    EXPECT_EQ(marker->message, "");
    EXPECT_GT(marker->seconds, 0.0);
    const std::optional<CaseMarker> written = read_marker(c.place());
    ASSERT_TRUE(written);
    EXPECT_EQ(written->state, CaseState::done);
    EXPECT_EQ(written->fingerprint, "0000000000000abc");
    EXPECT_EQ(written->seconds, marker->seconds);
    EXPECT_EQ(c.content("experiment.toml"), "trace = \"../exp/drop.csv\"\n");
    EXPECT_EQ(c.content("output.txt"), "found\n");
    EXPECT_EQ(c.content("messages.txt"), "myoloop: note\n");
    EXPECT_EQ(c.calls(), "diagnose " + c.place().string() + " --seed 4 --threads 1 --out " + c.place().string() + "\n");
}

/// Warnings precede the complaint, and what follows it on standard error is of a library.
TEST(CaseFolder, TheMessageOfAFailureIsTheLastComplaint) {
    const OneCase c("case_complains",
                    "echo 'myoloop: first' >&2; echo 'myoloop: second: why' >&2\n"
                    "echo 'myoloop: warning: loud' >&2; echo 'abort' >&2; exit 1");
    const Result<CaseMarker> marker = c.work();
    ASSERT_TRUE(marker);
    EXPECT_EQ(marker->state, CaseState::failed);
    EXPECT_EQ(marker->message, "second: why");
    EXPECT_EQ(read_marker(c.place())->message, "second: why");
}

TEST(CaseFolder, AProgramThatIsNotThereIsAFailureWithItsReason) {
    OneCase c("case_without_program", "");
    c.runner.program = c.folder.path() / "bin/nothing";
    const Result<CaseMarker> marker = c.work();
    ASSERT_TRUE(marker);
    EXPECT_EQ(marker->state, CaseState::failed);
    EXPECT_THAT(marker->message, HasSubstr("could not be started: No such file or directory"));
}

TEST(CaseFolder, FilesOfOthersAreNeverRemoved) {
    const OneCase c("case_of_others", "");
    c.folder.write("case/thesis.tex", "mine");
    const Result<CaseMarker> marker = c.work();
    ASSERT_FALSE(marker);
    EXPECT_THAT(marker.error().text(), HasSubstr(c.place().string() + ": holds files that no sweep wrote"));
    EXPECT_EQ(c.content("thesis.tex"), "mine");
    EXPECT_FALSE(c.folder.has("bin/run.calls"));
}

TEST(CaseFolder, AFileInThePlaceOfTheFolderIsNotReplaced) {
    const OneCase c("case_is_a_file", "");
    c.folder.write("case", "mine");
    const Result<CaseMarker> marker = c.work();
    ASSERT_FALSE(marker);
    EXPECT_EQ(marker.error().text(), c.place().string() + ": is no folder");
    EXPECT_EQ(*read_file(c.place()), "mine");
}

/// A folder in the place of the lock stands for a folder that this user cannot write.
TEST(CaseFolder, AFolderThatCannotBeLockedIsAnErrorAndNotAtWork) {
    const OneCase c("case_unlockable", "");
    c.folder.write("case/case.json", "{}");
    c.folder.write("case/.myoloop.lock/file", "");
    const Result<CaseMarker> marker = c.work();
    ASSERT_FALSE(marker);
    EXPECT_THAT(marker.error().text(), HasSubstr(".myoloop.lock: cannot be made: Is a directory"));
}

TEST(CaseFolder, WhatAnEarlierRunLeftIsRemovedBeforeButItsFits) {
    const OneCase c("case_again", "ls -A \"$folder\"");
    c.folder.write("case/case.json", "{}");
    c.folder.write("case/report.json", "old");
    c.folder.write("case/drop/frame.vtu", "old");
    ASSERT_TRUE(c.work());
    EXPECT_FALSE(c.folder.has("case/drop"));
    EXPECT_THAT(c.content("output.txt"), Not(HasSubstr("report.json")));
    EXPECT_THAT(c.calls(), Not(HasSubstr("--resume")));
    c.folder.write("case/diagnose_fits.json", "fits");
    ASSERT_TRUE(c.work());
    EXPECT_THAT(c.content("output.txt"), HasSubstr("diagnose_fits.json"));
    EXPECT_EQ(c.content("diagnose_fits.json"), "fits");
    EXPECT_THAT(c.calls(), HasSubstr(" --resume\n"));
}

/// Status 130 is an interrupt of the command alone, from the terminal or the queue.
TEST(CaseFolder, AfterAnInterruptOnlyFitsStay) {
    const OneCase without("case_stopped", "echo half >\"$folder/report.json\"; exit 130");
    const Result<CaseMarker> gone = without.work();
    ASSERT_TRUE(gone);
    EXPECT_EQ(gone->state, CaseState::stopped);
    EXPECT_EQ(gone->message, "");
    EXPECT_FALSE(fs::exists(without.place()));
    const OneCase with("case_stopped_fits", "echo fits >\"$folder/diagnose_fits.json\"; echo >\"$folder/x\"; exit 130");
    const Result<CaseMarker> kept = with.work();
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->state, CaseState::stopped);
    EXPECT_FALSE(with.folder.has("case/x"));
    EXPECT_EQ(with.content("diagnose_fits.json"), "fits\n");
    // The marker stays with them, so that the folder is known as one of a sweep and is run again.
    EXPECT_FALSE(has_ended(read_marker(with.place())->state));
}

TEST(CaseFolder, ACaseInWhichAProcessWorksIsLeftAlone) {
    const OneCase c("case_at_work", "");
    c.folder.write("case/case.json", "{}");
    const Result<FolderLock> other = FolderLock::take(c.place());
    ASSERT_TRUE(other);
    const Result<CaseMarker> marker = c.work();
    ASSERT_TRUE(marker);
    EXPECT_EQ(marker->state, CaseState::running);
    EXPECT_EQ(c.content("case.json"), "{}");
    EXPECT_FALSE(c.folder.has("bin/run.calls"));
}

TEST(CaseFolder, ACancelledCommandIsStopped) {
    const OneCase c("case_cancelled", "trap 'exit 130' TERM; while :; do sleep 0.005; done");
    std::atomic<bool> cancel{true};
    const Result<CaseMarker> marker = c.work(Progress({}, &cancel));
    ASSERT_TRUE(marker);
    EXPECT_EQ(marker->state, CaseState::stopped);
    EXPECT_FALSE(fs::exists(c.place()));
}

}  // namespace
}  // namespace myo::sweep::case_folder_test
