#include <gtest/gtest.h>

#include <csignal>

#include "base/child_process.hpp"
#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "support/folder.hpp"

namespace myo::test {
namespace {

ChildCall shell(const std::string& script) { return {.program = "/bin/sh", .arguments = {"-c", script}}; }
bool never() { return false; }

TEST(ChildProcess, KeepsWhatTheChildPrintsAndItsStatus) {
    const Folder folder("child_output");
    ChildCall call = shell("echo said; echo complained >&2; exit 7");
    call.output = folder.path() / "out";
    call.messages = folder.path() / "err";
    folder.write("out", "an earlier and longer text");
    const ChildEnd end = run_child(call, never);
    EXPECT_EQ(end.how, ChildEnd::How::exited);
    EXPECT_EQ(end.code, 7);
    EXPECT_EQ(*read_file(call.output), "said\n");
    EXPECT_EQ(*read_file(call.messages), "complained\n");
}

TEST(ChildProcess, TellsSignalsTimeLimitsAndMissingPrograms) {
    const ChildEnd killed = run_child(shell("kill -9 $$"), never);
    EXPECT_EQ(killed.how, ChildEnd::How::signalled);
    EXPECT_EQ(killed.code, SIGKILL);
    ChildCall slow = shell("sleep 60");
    slow.time_limit_s = 0.05;
    EXPECT_EQ(run_child(slow, never).how, ChildEnd::How::timed_out);
    EXPECT_EQ(run_child({.program = "/no/such/program"}, never).how, ChildEnd::How::not_started);
}

TEST(ChildProcess, ACancelledChildMayTidyUpWithinItsGrace) {
    const Folder folder("child_grace");
    ChildCall call = shell("trap 'echo tidied; exit 0' TERM; echo ready; while :; do sleep 0.01; done");
    call.output = folder.path() / "out";
    call.grace_s = 20.0;
    const auto ready = [&] {
        const Result<std::string> text = read_file(call.output);
        return text && !text->empty();
    };
    EXPECT_EQ(run_child(call, ready).how, ChildEnd::How::cancelled);
    EXPECT_EQ(*read_file(call.output), "ready\ntidied\n");
}

TEST(ChildProcess, AChildHearsWhatItsParentBlocks) {
    const Folder folder("child_mask");
    sigset_t termination;
    sigemptyset(&termination);
    sigaddset(&termination, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &termination, nullptr);
    ChildCall call = shell("kill -TERM $$; sleep 60");
    call.time_limit_s = 20.0;
    const ChildEnd end = run_child(call, never);
    pthread_sigmask(SIG_UNBLOCK, &termination, nullptr);
    EXPECT_EQ(end.how, ChildEnd::How::signalled);
    EXPECT_EQ(end.code, SIGTERM);
}

TEST(ChildProcess, ADeafChildIsKilledAfterItsGrace) {
    const Folder folder("child_deaf");
    ChildCall call = shell("trap '' TERM; echo ready; while :; do sleep 0.01; done");
    call.output = folder.path() / "out";
    call.grace_s = 0.1;
    const auto ready = [&] {
        const Result<std::string> text = read_file(call.output);
        return text && !text->empty();
    };
    const Stopwatch watch;
    EXPECT_EQ(run_child(call, ready).how, ChildEnd::How::cancelled);
    EXPECT_GE(watch.seconds(), 0.1);
    EXPECT_LT(watch.seconds(), 10.0);
}

}  // namespace
}  // namespace myo::test
