#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/abandonable.hpp"
#include "base/cancellation.hpp"
#include "base/stopwatch.hpp"
#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"

namespace myo::setup {
namespace {

/// A person who cancels waits at most this long.
constexpr double max_s = 1.0;

/// The tables of this body of a quarter of a million unknowns take several seconds.
TEST(CancelledSetup, LeavesTheBodyAtOnceAndGivesItsMemoryBack) {
    const Result<experiment::Experiment> beam = experiment::read_experiment(std::string(MYOLOOP_SOURCE_DIR) +
                                                                            "/assets/examples/silicone_beam");
    ASSERT_TRUE(beam) << beam.error().text();
    SetupSettings settings;
    settings.mesh.resolution_m = 0.00095;
    std::atomic<bool> cancel{false};
    const Progress progress({}, &cancel);
    const CancellationScope scope(&progress);
    std::atomic<bool> ended{false};
    double cancelled_s = 0.0;
    const Stopwatch watch;
    std::thread person([&] {
        while (!ended && watch.seconds() < 1.5) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        cancelled_s = watch.seconds();
        cancel = true;
    });
    const Result<setup::Setup> prepared = prepare_setup(*beam, settings, progress);
    const double ended_s = watch.seconds();
    ended = true;
    person.join();
    ASSERT_FALSE(prepared) << "the set-up was complete before it was cancelled";
    EXPECT_LT(ended_s - cancelled_s, max_s);
    // What was left ends by itself.
    for (int i = 0; i < 6000 && abandoned_calls() > 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(abandoned_calls(), 0);
}

}  // namespace
}  // namespace myo::setup
