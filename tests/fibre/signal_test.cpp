#include <gtest/gtest.h>

#include "fibre/signal.hpp"

namespace myo {
namespace {

TEST(Signal, IsLinearBetweenKnotsAndConstantOutside) {
    const Signal s{{1.0, 2.0, 4.0}, {10.0, 20.0, 0.0}};
    EXPECT_EQ(s.value(-5.0), 10.0);
    EXPECT_EQ(s.value(1.0), 10.0);
    EXPECT_DOUBLE_EQ(s.value(1.25), 12.5);
    EXPECT_EQ(s.value(2.0), 20.0);
    EXPECT_DOUBLE_EQ(s.value(3.5), 5.0);
    EXPECT_EQ(s.value(4.0), 0.0);
    EXPECT_EQ(s.value(9.0), 0.0);
    for (const double t : {-1.0, 1.0, 1.3, 2.0, 3.0, 4.0, 8.0}) EXPECT_DOUBLE_EQ(s.value_before(t), s.value(t));
    EXPECT_TRUE(s.jumps().empty());
}

TEST(Signal, JumpsAreContinuousFromTheRight) {
    const Signal step = Signal::step(0.5, 1.0, 0.8);
    EXPECT_EQ(step.value(0.5), 0.8);
    EXPECT_EQ(step.value_before(0.5), 1.0);
    EXPECT_EQ(step.value(0.499), 1.0);
    EXPECT_EQ(step.value(0.501), 0.8);
    EXPECT_EQ(step.jumps(), std::vector<double>{0.5});

    const Signal saw{{0.0, 1.0, 1.0, 2.0, 2.0, 3.0}, {0.0, 2.0, 5.0, 5.0, 5.0, 1.0}};
    EXPECT_EQ(saw.value_before(1.0), 2.0);
    EXPECT_EQ(saw.value(1.0), 5.0);
    EXPECT_DOUBLE_EQ(saw.value(0.75), 1.5);
    EXPECT_DOUBLE_EQ(saw.value(2.5), 3.0);
    EXPECT_EQ(saw.jumps(), std::vector<double>{1.0});   // two equal values at 2 are no jump
    EXPECT_EQ(Signal::constant(0.7).value(3.0), 0.7);
}

}  // namespace
}  // namespace myo
