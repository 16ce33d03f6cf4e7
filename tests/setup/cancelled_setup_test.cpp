#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/abandonable.hpp"
#include "base/cancellation.hpp"
#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"

namespace myo::setup {
namespace {

/// Cancelled as soon as the body is meshed: its tables are left to end by themselves. tests/cancel_times.py measures
/// how long a person waits.
TEST(CancelledSetup, LeavesTheTablesOfTheBody) {
    const Result<experiment::Experiment> beam = experiment::read_experiment(std::string(MYOLOOP_SOURCE_DIR) +
                                                                            "/assets/examples/silicone_beam");
    ASSERT_TRUE(beam) << beam.error().text();
    SetupSettings settings;
    settings.mesh.resolution_m = 0.002;
    const Result<setup::Setup> whole = prepare_setup(*beam, settings);
    ASSERT_TRUE(whole) << whole.error().text();
    std::atomic<bool> cancel{true};
    const Progress progress({}, &cancel);
    const CancellationScope scope(&progress);
    const Result<setup::Setup> left = prepare_setup(*beam, settings, progress, &whole->mesh);
    ASSERT_FALSE(left);
    EXPECT_THAT(left.error().what, testing::HasSubstr("before the body was made"));
    for (int i = 0; i < 6000 && abandoned_calls() > 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(abandoned_calls(), 0);
}

}  // namespace
}  // namespace myo::setup
