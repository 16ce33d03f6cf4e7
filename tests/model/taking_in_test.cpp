#include "model/taking_in.hpp"

#include <gtest/gtest.h>

namespace myo::model {
namespace {

TEST(TakingIn, FollowsTheCommand) {
    const TakingIn sense({{0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, 3.0, 3.0, 2.0, 2.5}});
    EXPECT_EQ(sense.at(-1.0, false), 1.0) << "the first sense is to take in";
    EXPECT_EQ(sense.at(0.5, false), 1.0);
    EXPECT_EQ(sense.at(1.5, false), 1.0) << "a constant command keeps the sense";
    EXPECT_EQ(sense.at(2.0, true), 1.0);
    EXPECT_EQ(sense.at(2.0, false), -1.0);
    EXPECT_EQ(sense.at(3.5, false), 1.0);
    EXPECT_EQ(sense.turns(), (std::vector<double>{2.0, 3.0}));
}

TEST(TakingIn, DoesNotFollowNoise) {
    const TakingIn sense({{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.5, 0.495, 1.0, 0.995}});
    EXPECT_TRUE(sense.turns().empty()) << "reversals of less than a hundredth of the range";
    // Small steps down add up to a reversal.
    const TakingIn falling({{0.0, 1.0, 2.0, 3.0}, {0.0, 1.0, 0.995, 0.985}});
    EXPECT_EQ(falling.turns(), std::vector<double>{2.0});
}

TEST(TakingIn, TurnsAtJumps) {
    const TakingIn sense({{0.0, 1.0, 1.0, 2.0}, {0.0, 2.0, 1.0, 1.0}});
    EXPECT_EQ(sense.at(1.0, true), 1.0);
    EXPECT_EQ(sense.at(1.0, false), -1.0);
    EXPECT_EQ(sense.at(1.5, false), -1.0);
    EXPECT_TRUE(TakingIn(fibre::Signal::constant(3.0)).turns().empty());
}

}  // namespace
}  // namespace myo::model
