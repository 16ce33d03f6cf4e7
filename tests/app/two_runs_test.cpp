#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "base/folder_lock.hpp"

// Two runs never write into one folder at once.

namespace myo::test {
namespace {

using ::testing::HasSubstr;

bool is_locked(const Folder& folder) { return folder.has("out/.myoloop.lock"); }

TEST(TwoRuns, TheSecondIsRefusedByEveryCommand) {
    const Folder folder("two_runs");
    write_small_experiment(folder);
    std::filesystem::create_directories(folder.path() / "out");
    {
        const Result<FolderLock> lock = FolderLock::take(folder.path() / "out");
        ASSERT_TRUE(lock);
        for (const char* const command : {"simulate", "calibrate", "optimize", "diagnose", "reproduce"}) {
            const std::string subject = command == std::string("reproduce") ? "beam-static" : folder.str("exp");
            const ProgramRun run = run_program({command, subject, "--out", folder.str("out")});
            EXPECT_EQ(run.status, 2) << run.err;
            EXPECT_EQ(count_lines(run.err), 1) << run.err;
            EXPECT_THAT(run.err,
                        HasSubstr("--out: " + folder.str("out") + " is used by another run of myoloop, process "));
        }
        EXPECT_TRUE(is_locked(folder));
    }
    EXPECT_EQ(run_program({"simulate", folder.str("exp"), "--out", folder.str("out"), "--quiet"}).status, 0);
    EXPECT_FALSE(is_locked(folder));
}

TEST(TwoRuns, AFailedOrStoppedRunLeavesNoLock) {
    const Folder folder("two_runs_failed");
    write_small_experiment(folder);
    EXPECT_EQ(run_program({"optimize", folder.str("exp"), "--out", folder.str("out")}).status,
              2);  // it has no muscles
    EXPECT_FALSE(is_locked(folder));
    write_small_experiment(folder, 4.0);
    const ProgramRun stopped = run_program(
        {"simulate", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.004", "--json-progress"},
        "\"event\"");
    EXPECT_EQ(stopped.status, 130) << stopped.err;
    EXPECT_FALSE(is_locked(folder));
}

}  // namespace
}  // namespace myo::test
