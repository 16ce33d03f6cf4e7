#include "base/folder_lock.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "base/files.hpp"
#include "support/folder.hpp"

namespace myo {
namespace {

TEST(FolderLock, ASecondRunIsRefusedWhileTheFirstHoldsIt) {
    const test::Folder folder("folder_lock");
    std::optional<Result<FolderLock>> first(FolderLock::take(folder.path()));
    ASSERT_TRUE(*first);
    EXPECT_EQ(read_file(folder.path() / ".myoloop.lock").value(), std::to_string(::getpid()) + "\n");
    const Result<FolderLock> second = FolderLock::take(folder.path());
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().text(), folder.path().string() + " is used by another run of myoloop, process " +
                                         std::to_string(::getpid()) + "; wait for it or choose another folder");
    EXPECT_TRUE(folder.has(".myoloop.lock"));
    first.reset();
    EXPECT_FALSE(folder.has(".myoloop.lock"));
    EXPECT_TRUE(FolderLock::take(folder.path()));
}

TEST(FolderLock, WhatAKilledRunLeftIsTakenOver) {
    const test::Folder folder("folder_lock_stale");
    const pid_t child = ::fork();
    if (child == 0) {
        const Result<FolderLock> held = FolderLock::take(folder.path());
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(folder.has(".myoloop.lock"));
    {
        const Result<FolderLock> lock = FolderLock::take(folder.path());
        ASSERT_TRUE(lock);
        EXPECT_EQ(read_file(folder.path() / ".myoloop.lock").value(), std::to_string(::getpid()) + "\n");
    }
    // An id that is in use again is no sign of a run.
    folder.write(".myoloop.lock", std::to_string(::getppid()) + "\n");
    EXPECT_TRUE(FolderLock::take(folder.path()));
}

TEST(FolderLock, AFileThatIsTakenIsNoErrorForWorkThatCanBeLeft) {
    const test::Folder folder("folder_lock_free");
    std::optional<Result<FolderLock>> first(FolderLock::take_file(folder.path() / "case"));
    ASSERT_TRUE(*first);
    const Result<std::optional<FolderLock>> taken = FolderLock::take_file_if_free(folder.path() / "case");
    ASSERT_TRUE(taken) << taken.error().text();
    EXPECT_FALSE(*taken);
    first.reset();
    const Result<std::optional<FolderLock>> freed = FolderLock::take_file_if_free(folder.path() / "case");
    ASSERT_TRUE(freed) << freed.error().text();
    EXPECT_TRUE(*freed);
    EXPECT_EQ(FolderLock::take_file_if_free(folder.path() / "nowhere/case").error().text(),
              folder.str("nowhere/.case.lock") + ": cannot be made: No such file or directory");
}

}  // namespace
}  // namespace myo
