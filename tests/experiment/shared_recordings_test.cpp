#include "experiment/shared_recordings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/experiment_folder.hpp"
#include "support/swung_beam.hpp"

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing_support::replaced;

/// The pairs of the swung beam, whose second trial names `second` and has `more` in it.
std::vector<SharedRecording> shared_with(const std::string& second, const std::string& content,
                                         const std::string& more = "", const std::string& more_first = "") {
    const test::Folder folder("shared_recordings");
    folder.write("swing.csv", "one");
    folder.write(second, content);
    std::string toml = test::swung_beam_toml();
    toml = replaced(toml, "role = \"validate\"\ntrace = \"swing.csv\"",
                    "role = \"validate\"\n" + more + "trace = \"" + second + "\"");
    toml = replaced(toml, "role = \"fit\"\n", "role = \"fit\"\n" + more_first);
    folder.write("experiment.toml", toml);
    const Result<Experiment> experiment = read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    const std::vector<SharedRecording> shared = shared_recordings(*experiment);
    for (const SharedRecording& pair : shared)
        EXPECT_THAT(shared_recording_sentence(*experiment, pair),
                    HasSubstr("trial[1].trace: " + second + " of the validate trial swing again"));
    return shared;
}

TEST(SharedRecordings, FindTheSameFileAndTheSameContent) {
    for (const char* second : {"swing.csv", "copy.csv"}) {
        const std::vector<SharedRecording> shared = shared_with(second, "one");
        ASSERT_EQ(shared.size(), 1u) << second;
        EXPECT_EQ(shared[0].fit, 0u);
        EXPECT_EQ(shared[0].validate, 1u);
    }
    EXPECT_TRUE(shared_with("copy.csv", "two").empty());
    EXPECT_TRUE(shared_with("copy.csv", "other").empty());
}

/// The first half of a recording to fit, the second one to predict.
TEST(SharedRecordings, TwoPartsOfOneRecordingAreTwo) {
    EXPECT_TRUE(shared_with("swing.csv", "one", "start_s = 2.0\n", "end_s = 2.0\n").empty());
    EXPECT_EQ(shared_with("swing.csv", "one", "start_s = 2.0\n", "end_s = 2.5\n").size(), 1u);
}

}  // namespace
}  // namespace myo::experiment
