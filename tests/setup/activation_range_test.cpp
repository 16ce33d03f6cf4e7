#include "setup/activation_range.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/experiment_folder.hpp"
#include "support/muscle_beam.hpp"

namespace myo::setup {
namespace {

using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing_support::replaced;

const std::string good_signal = "time_s,up\n0,1\n0.2,0.8\n";

TEST(ActivationRange, AFileThatReachesZeroIsRefusedAtItsLine) {
    const test::Folder folder("activation");
    for (const char* low : {"0", "-1"}) {
        const Result<setup::Setup> setup = test::muscle_beam_setup(
            folder, test::muscle_beam_toml(), "time_s,up\n0,1\n0.1,0.9\n0.2," + std::string(low) + "\n");
        ASSERT_FALSE(setup);
        EXPECT_THAT(setup.error().what,
                    StartsWith("trial[0].actuation: muscle up has the activation " + std::string(low)));
        EXPECT_THAT(setup.error().what, HasSubstr("1 is passive"));
        EXPECT_THAT(setup.error().where, EndsWith("s.csv:4"));
    }
    EXPECT_TRUE(test::muscle_beam_setup(folder, test::muscle_beam_toml(), "time_s,up\n0,1\n0.2,0.01\n"));
}

TEST(ActivationRange, AStepAndASignalOfTheMuscleAreRefused) {
    const test::Folder folder("activation");
    const std::string stepped = replaced(test::muscle_beam_toml(), "actuation = \"s.csv\"",
                                         "actuation_step = { up = 0.0 }");
    const Result<setup::Setup> step = test::muscle_beam_setup(folder, stepped, good_signal);
    ASSERT_FALSE(step);
    EXPECT_THAT(step.error().what, StartsWith("trial[0].actuation_step.up: muscle up has the activation 0,"));
    EXPECT_THAT(step.error().where,
                EndsWith("experiment.toml:" + std::to_string(testing_support::line_of(stepped, "actuation_step"))));

    const std::string own = replaced(replaced(test::muscle_beam_toml(), "actuation = \"s.csv\"\n", ""), "stiffness_Pa",
                                     "signal = \"s.csv\"\nstiffness_Pa");
    const Result<setup::Setup> signal = test::muscle_beam_setup(folder, own, "time_s,up\n0,1\n0.2,-0.5\n");
    ASSERT_FALSE(signal);
    EXPECT_THAT(signal.error().what, StartsWith("muscle[0].signal: muscle up has the activation -0.5"));
    EXPECT_THAT(signal.error().where, EndsWith("s.csv:3"));
}

/// Published formulations have springs that push, and a follower is what its leader makes of it.
TEST(ActivationRange, PublishedSetUpsAndFollowersKeepTheirRangeWithANote) {
    const test::Folder folder("activation");
    const Result<setup::Setup> published = test::muscle_beam_setup(
        folder, test::muscle_beam_toml(), "time_s,up\n0,1\n0.2,-0.5\n", 0.0, 1.0, published_settings());
    ASSERT_TRUE(published) << published.error().text();
    EXPECT_THAT(published->warnings,
                Contains(HasSubstr("muscle[0]: the activation of up falls to -0.5, as published")));

    std::string toml = test::muscle_beam_toml();
    toml.insert(toml.find("[markers]"),
                "[[muscle]]\nname = \"down\"\nbox_m = [[0.0, 0.0, 0.0], [0.1, 0.03, 0.01]]\nfibre = [1, 0, "
                "0]\nstiffness_Pa = 8e4\nfollows = { muscle = \"up\", ratio = -4.0 }\n");
    const Result<setup::Setup> following = test::muscle_beam_setup(folder, toml, "time_s,up\n0,1\n0.2,1.5\n");
    ASSERT_TRUE(following) << following.error().text();
    EXPECT_THAT(following->warnings,
                Contains(HasSubstr("muscle[1]: the activation of down falls to -1, for it follows up")));
}

}  // namespace
}  // namespace myo::setup
