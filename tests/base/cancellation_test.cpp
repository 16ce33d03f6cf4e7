#include "base/cancellation.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

#include "base/abandonable.hpp"
#include "base/parallel.hpp"

namespace myo {
namespace {

TEST(Cancellation, IsSeenInsideItsScopeOnly) {
    std::atomic<bool> stop{true};
    const Progress progress({}, &stop);
    EXPECT_FALSE(cancellation_requested());
    {
        const CancellationScope scope(&progress);
        EXPECT_TRUE(cancellation_requested());
        {
            const CancellationScope none(nullptr);
            EXPECT_FALSE(cancellation_requested());
        }
        stop = false;
        EXPECT_FALSE(cancellation_requested());
    }
    stop = true;
    EXPECT_FALSE(cancellation_requested());
}

TEST(Cancellation, ReachesTheThreadsOfATask) {
    std::atomic<bool> stop{true};
    const Progress progress({}, &stop);
    const CancellationScope scope(&progress);
    std::atomic<int> seen{0};
    parallel_tasks(4, 2, [&](int) {
        parallel_ranges(8, 1, [&](int first, int end) {
            if (cancellation_requested()) seen += end - first;
        });
    });
    EXPECT_EQ(seen, 32);
}

TEST(Abandonable, RunsOnThisThreadOutsideOfAScope) {
    std::thread::id ran;
    EXPECT_TRUE(run_abandonable([&] { ran = std::this_thread::get_id(); }));
    EXPECT_EQ(ran, std::this_thread::get_id());
}

TEST(Abandonable, WaitsForTheWorkAndPassesItsFailureOn) {
    std::atomic<bool> stop{false};
    const Progress progress({}, &stop);
    const CancellationScope scope(&progress);
    const auto result = std::make_shared<int>(0);
    EXPECT_TRUE(run_abandonable([result] { *result = 7; }));
    EXPECT_EQ(*result, 7);
    EXPECT_THROW(run_abandonable([] { throw std::runtime_error("no memory"); }), std::runtime_error);
}

/// The caller leaves while the work still runs; the work ends later, and what it owns is freed before it is no longer
/// counted.
TEST(Abandonable, IsLeftWhereTheTaskIsCancelled) {
    std::atomic<bool> stop{true};
    const Progress progress({}, &stop);
    const CancellationScope scope(&progress);
    const auto go_on = std::make_shared<std::atomic<bool>>(false);
    const auto owned = std::make_shared<int>(1);
    EXPECT_FALSE(run_abandonable([go_on, owned] {
        while (!*go_on) std::this_thread::yield();
    }));
    EXPECT_EQ(abandoned_calls(), 1);
    EXPECT_EQ(owned.use_count(), 2);
    *go_on = true;
    while (abandoned_calls() > 0) std::this_thread::yield();
    EXPECT_EQ(owned.use_count(), 1);
}

}  // namespace
}  // namespace myo
