#include <gtest/gtest.h>

#include "fibre/signal.hpp"

namespace myo::fibre {
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
    EXPECT_EQ(saw.jumps(), (std::vector<double>{1.0, 2.0}));  // a jump by zero is one
    EXPECT_EQ(Signal::constant(0.7).value(3.0), 0.7);
}

TEST(Signal, WeightsAreTheDerivativeWithRespectToTheKnots) {
    const Signal saw{{0.0, 1.0, 1.0, 2.0, 2.0, 3.0}, {0.0, 2.0, 5.0, 5.0, 5.0, 1.0}};
    for (const bool before : {false, true})
        for (const double t : {-1.0, 0.0, 0.3, 1.0, 1.6, 2.0, 2.2, 3.0, 5.0}) {
            const Signal::Weights w = saw.weights(t, before);
            for (std::size_t k = 0; k < saw.values.size(); ++k) {
                Signal changed = saw;
                changed.values[k] += 1.0;
                const double change = before ? changed.value_before(t) - saw.value_before(t)
                                             : changed.value(t) - saw.value(t);
                const double weight = (k == w.left ? w.of_left : 0.0) + (k == w.right ? w.of_right : 0.0);
                EXPECT_NEAR(change, weight, 1e-14) << "t " << t << " knot " << k;
            }
        }
}

TEST(Signal, HeldSamplesLastUntilTheNext) {
    const Signal held = Signal::held({0.0, 0.05, 0.1}, {1.0, 1.2, 0.9});
    EXPECT_EQ(held.value(0.02), 1.0);
    EXPECT_EQ(held.value_before(0.05), 1.0);
    EXPECT_EQ(held.value(0.05), 1.2);
    EXPECT_EQ(held.value(0.3), 0.9);
    EXPECT_EQ(held.jumps(), (std::vector<double>{0.05, 0.1}));
    EXPECT_EQ(held_sample_gradient({1.0, 2.0, 4.0, 8.0, 16.0}), (std::vector<double>{3.0, 12.0, 16.0}));
}

}  // namespace
}  // namespace myo::fibre
