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

/// Limits of time are further reasons to end; the earliest of them counts, and the user's stop in any case.
TEST(Progress, EndsAtTheEarliestOfItsLimits) {
    const auto now = std::chrono::steady_clock::now();
    const auto past = now - std::chrono::seconds(1), later = now + std::chrono::hours(1);
    std::atomic<bool> cancel{false};
    const Progress owner({}, &cancel);
    EXPECT_TRUE(owner.until(past).cancelled());
    EXPECT_TRUE(owner.until(past).until(later).cancelled()) << "a later limit extends nothing";
    EXPECT_TRUE(owner.until(past).with_sink({}).cancelled());
    const Progress limited = owner.until(later);
    EXPECT_EQ(limited.end(), later);
    EXPECT_FALSE(limited.cancelled());
    EXPECT_FALSE(owner.cancelled()) << "the copy alone is limited";
    cancel = true;
    EXPECT_TRUE(limited.cancelled());
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
