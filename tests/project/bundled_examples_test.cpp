#include <gtest/gtest.h>

#include <filesystem>

#include "project/read_experiment.hpp"
#include "project/study.hpp"

namespace myo {
namespace {

TEST(BundledExamples, AreReadAndMeshed) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(MYOLOOP_SOURCE_DIR "/assets/examples")) {
        if (!entry.is_directory()) continue;
        SCOPED_TRACE(entry.path());
        const Result<Experiment> experiment = read_experiment(entry.path());
        ASSERT_TRUE(experiment) << experiment.error().text();
        const Result<Study> study = prepare_study(*experiment, {});
        ASSERT_TRUE(study) << study.error().text();
        EXPECT_EQ(study->trials.size(), experiment->trials.size());
        ++count;
    }
    EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace myo
