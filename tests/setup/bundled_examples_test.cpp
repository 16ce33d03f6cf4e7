#include <gtest/gtest.h>

#include <filesystem>

#include "experiment/read_experiment.hpp"
#include "setup/setup.hpp"

namespace myo::setup {
namespace {

TEST(BundledExamples, AreReadAndMeshed) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(MYOLOOP_SOURCE_DIR "/assets/examples")) {
        if (!entry.is_directory()) continue;
        SCOPED_TRACE(entry.path());
        const Result<experiment::Experiment> experiment = experiment::read_experiment(entry.path());
        ASSERT_TRUE(experiment) << experiment.error().text();
        const Result<setup::Setup> setup = prepare_setup(*experiment, {});
        ASSERT_TRUE(setup) << setup.error().text();
        EXPECT_EQ(setup->trials.size(), experiment->trials.size());
        ++count;
    }
    EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace myo::setup
