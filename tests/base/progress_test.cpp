#include "base/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

#include "base/parallel.hpp"
#include "base/throttle.hpp"

namespace myo {
namespace {

TEST(Progress, DefaultListensToNobody) {
    const Progress quiet;
    quiet.report({"fit", 1, 2, "evaluations", ""});
    EXPECT_FALSE(quiet.cancelled());
}

TEST(Progress, CopiesShareSinkAndCancelFlag) {
    std::atomic<bool> cancel{false};
    std::vector<double> done;
    const Progress owner([&](const ProgressEvent& event) { done.push_back(event.done); }, &cancel);
    const Progress handed_out = owner;
    handed_out.report({"fit", 1, 3, "steps", ""});
    owner.report({"fit", 2, 3, "steps", ""});
    EXPECT_EQ(done, (std::vector<double>{1, 2}));
    cancel = true;
    EXPECT_TRUE(owner.cancelled() && handed_out.cancelled());
}

TEST(Throttle, LetsOneOfManyThreadsThroughAtATime) {
    Throttle throttle;
    const auto passed = [&] {
        std::atomic<int> count{0};
        parallel_tasks(8, 4, [&](int) { count += throttle.ready() ? 1 : 0; });
        return count.load();
    };
    EXPECT_EQ(passed(), 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(101));
    EXPECT_EQ(passed(), 1);
}

}  // namespace
}  // namespace myo
