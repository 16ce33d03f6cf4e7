#include "planning/power_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "effect/catalogue.hpp"
#include "planning/planned_beam.hpp"
#include "planning/power_output.hpp"

// What a swung beam could show of effects.

namespace myo::planning::power_map_test {
namespace {

using ::testing::HasSubstr;

const EffectPower& power_of(const PowerMap& map, const std::string& id) {
    const auto found = std::find_if(map.effects.begin(), map.effects.end(),
                                    [&](const EffectPower& power) { return power.id == id; });
    EXPECT_NE(found, map.effects.end()) << id;
    return *found;
}

PowerSettings among(const std::vector<std::string>& ids) {
    PowerSettings settings;
    settings.only = ids;
    return settings;
}

TEST(PowerMap, NeedsNoRecording) {
    const test::Folder folder("power_planned");
    const PowerMap map = power_map(test::planned_beam(folder), {});
    ASSERT_EQ(map.failure, "");
    EXPECT_EQ(map.effects.size(), effect::effect_catalogue().size());
    EXPECT_THAT(map.trials, ::testing::ElementsAre("swing"));
    EXPECT_EQ(map.samples, 4 * 3 * 61);
    for (const EffectPower& power : map.effects) {
        EXPECT_TRUE(!power.sizes.empty() || !power.unseen.empty()) << power.id;
        for (std::size_t i = 0; i < power.sizes.size(); ++i) {
            EXPECT_GE(power.sizes[i].probability, map.alpha - 1e-9) << power.id;
            EXPECT_TRUE(std::isfinite(power.sizes[i].noncentrality)) << power.id;
        }
        EXPECT_TRUE(!power.detected || *power.detected > 0.0) << power.id;
        EXPECT_LE(power.cosine, 1.0 + 1e-9) << power.id;
    }
    EXPECT_THAT(power_of(map, "actuation_lag").unseen, HasSubstr("muscle, chamber or tendon"));
    EXPECT_THAT(power_of(map, "tendon_friction").unseen, HasSubstr("tendon"));
    EXPECT_THAT(power_of(map, "tendon_channel").unseen, HasSubstr("tendon"));
    EXPECT_EQ(power_of(map, "quadratic_drag").unseen, "");
    EXPECT_THAT(power_lines(map), HasSubstr("not to be seen in this experiment:"));
    EXPECT_EQ(power_json(map, "beam", {}).at("effects").size(), map.effects.size());
}

/// Only the samples of a recording matter, not what they show.
TEST(PowerMap, IsThatOfTheRecordedTrial) {
    const test::Folder planned("power_twin_planned"), recorded("power_twin_recorded");
    const std::vector<std::string> ids{"quadratic_drag", "linear_drag", "point_mass", "gravity_tilt"};
    const PowerMap before = power_map(test::planned_beam(planned), among(ids)),
                   after = power_map(test::swung_beam(recorded), among(ids));
    ASSERT_EQ(before.effects.size(), ids.size());
    for (std::size_t e = 0; e < ids.size(); ++e)
        for (std::size_t i = 0; i < before.effects[e].sizes.size(); ++i)
            EXPECT_NEAR(before.effects[e].sizes[i].noncentrality / after.effects[e].sizes[i].noncentrality, 1.0, 1e-6)
                << ids[e];
}

TEST(PowerMap, GrowsWithSizeAndLosesByNoise) {
    const test::Folder folder("power_grows"), noisy_folder("power_noisy");
    const std::vector<std::string> ids{"quadratic_drag", "linear_drag", "clamp_compliance"};
    setup::Setup setup = test::planned_beam(folder);
    const PowerMap map = power_map(setup, among(ids));
    setup.noise_m *= 30.0;
    const PowerMap noisy = power_map(setup, among(ids));
    for (const std::string& id : ids) {
        const EffectPower &fine = power_of(map, id), &rough = power_of(noisy, id);
        ASSERT_EQ(fine.sizes.size(), 3u);
        for (std::size_t i = 1; i < fine.sizes.size(); ++i)
            EXPECT_GT(fine.sizes[i].noncentrality, fine.sizes[i - 1].noncentrality) << id;
        EXPECT_LT(rough.sizes[1].probability, fine.sizes[1].probability + 1e-12) << id;
        EXPECT_GT(fine.kept, 0.0);
        EXPECT_LT(fine.kept, 1.0);
    }
    // An amount that is weak where it is large.
    const EffectPower& compliance = power_of(map, "clamp_compliance");
    EXPECT_GT(compliance.sizes.front().size, compliance.sizes.back().size);
    EXPECT_EQ(power_of(map, "linear_drag").confused_with, "quadratic_drag");
    EXPECT_GT(power_of(map, "linear_drag").cosine, 0.8);
}

/// The detected size is detected with the wanted probability when it is run.
TEST(PowerMap, DetectedSizeHolds) {
    const test::Folder folder("power_detected");
    const setup::Setup setup = test::planned_beam(folder);
    PowerSettings settings = among({"quadratic_drag"});
    settings.numerical_error_m = 2e-4;  // so much that the threshold lies within the range
    const EffectPower power = power_map(setup, settings).effects.front();
    ASSERT_TRUE(power.detected);
    ASSERT_FALSE(power.beyond_range);
    settings.policy.power.sizes = 9;
    const EffectPower finer = power_map(setup, settings).effects.front();
    ASSERT_TRUE(finer.detected);
    EXPECT_NEAR(*power.detected / *finer.detected, 1.0, 0.15);
}

TEST(PowerMap, IsStopped) {
    const test::Folder folder("power_stopped");
    std::atomic<bool> cancel{true};
    const PowerMap map = power_map(test::planned_beam(folder), {}, Progress({}, &cancel));
    EXPECT_TRUE(map.stopped);
    EXPECT_TRUE(map.effects.empty());
}

}  // namespace
}  // namespace myo::planning::power_map_test
