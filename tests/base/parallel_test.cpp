#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace myo {
namespace {

TEST(ParallelTasks, RunEachIndexOnceOnAnyNumberOfThreads) {
    for (const int threads : {-1, 0, 1, 2, 3, 8, 50})
        for (const int count : {-1, 0, 1, 2, 7, 1000}) {
            std::vector<std::atomic<int>> runs(static_cast<std::size_t>(std::max(count, 0)));
            parallel_tasks(count, threads, [&](int i) { ++runs[static_cast<std::size_t>(i)]; });
            EXPECT_TRUE(std::all_of(runs.begin(), runs.end(), [](const auto& n) { return n == 1; }))
                << threads << " " << count;
        }
}

TEST(ParallelTasks, UseThreadsOfTheirOwn) {
    std::set<std::thread::id> seen;
    std::mutex mutex;
    // On a busy machine a helper may come too late for all tasks of a call.
    for (int attempt = 0; attempt < 50 && seen.size() < 2; ++attempt) {
        seen.clear();
        parallel_tasks(8, 4, [&](int) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));  // long enough for every helper to get a task
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        });
        EXPECT_LE(seen.size(), 4u);
    }
    EXPECT_GT(seen.size(), 1u);
    seen.clear();
    parallel_tasks(8, 1, [&](int) { seen.insert(std::this_thread::get_id()); });
    EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST(ParallelTasks, RethrowTheLowestIndexAndStillRunTheRest) {
    for (const int threads : {1, 2, 8}) {
        std::atomic<int> runs{0};
        try {
            parallel_tasks(100, threads, [&](int i) {
                ++runs;
                // The lowest failure comes last in time.
                if (i == 13) std::this_thread::sleep_for(std::chrono::milliseconds(30));
                if (i == 13 || i == 14 || i == 90) throw std::runtime_error(std::to_string(i));
            });
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "13");
        }
        EXPECT_EQ(runs, 100);
    }
}

TEST(HardwareThreads, AreAtLeastOne) { EXPECT_GE(hardware_threads(), 1); }

}  // namespace
}  // namespace myo
