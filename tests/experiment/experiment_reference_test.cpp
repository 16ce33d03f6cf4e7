#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.hpp"
#include "effect/catalogue.hpp"
#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"

namespace myo::experiment {
namespace {

using testing::HasSubstr;

std::string reference() {
    return *read_file(std::filesystem::path(MYOLOOP_SOURCE_DIR) / "assets/manual/experiment.md");
}

TEST(ExperimentReference, BeginsWithAnExampleThatIsRead) {
    const std::string text = reference();
    const std::size_t first = text.find("```toml\n") + 8, end = text.find("```", first);
    ASSERT_LT(end, text.size());
    const test::Folder folder("reference");
    folder.write("experiment.toml", text.substr(first, end - first));
    folder.write("gravity_release.csv", "-");
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->markers.on_body.size(), 5u);
}

TEST(ExperimentReference, HasEveryEffectWithItsParameters) {
    const std::string text = reference();
    for (const std::string& id : effect::effect_ids()) {
        const std::size_t row = text.find("| `" + id + "` |");
        ASSERT_NE(row, std::string::npos) << id;
        for (const effect::EffectParameterEntry& parameter : effect::find_effect(id)->parameters)
            EXPECT_THAT(text.substr(row, text.find('\n', row) - row), HasSubstr("`" + parameter.name + "`")) << id;
    }
}

}  // namespace
}  // namespace myo::experiment
