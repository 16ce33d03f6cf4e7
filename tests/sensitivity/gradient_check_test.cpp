#include "sensitivity/gradient_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace myo::sensitivity {
namespace {

/// The loss is 1 and known to 1e-10; the differences were taken over 1e-3, so that derivatives below 1e-7 are noise.
GradientCheckRow compared(double adjoint, double difference) {
    GradientCheckRow row{"row", adjoint, difference};
    compare(row, 1e-3, 1.0, 1e-10);
    return row;
}

TEST(GradientCheckRow, IsComparedWhereTheLossFeelsTheParameter) {
    EXPECT_TRUE(compared(2.0, 2.0002).has_influence);
    EXPECT_NEAR(compared(2.0, 2.0002).relative_error, 1e-4, 1e-7);
    EXPECT_TRUE(compared(0.0, 1e-6).has_influence);
    EXPECT_EQ(compared(0.0, 1e-6).relative_error, 1.0) << "an adjoint that misses an influence";
}

TEST(GradientCheckRow, IsNotComparedBelowTheNoiseOfTheLoss) {
    EXPECT_FALSE(compared(0.0, 0.0).has_influence);
    EXPECT_FALSE(compared(0.0, 1e-8).has_influence);
    EXPECT_EQ(compared(0.0, 1e-8).relative_error, 0.0);
}

TEST(GradientCheckRow, WithoutANumberIsNoAgreement) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(compared(none, none).has_influence);
    EXPECT_TRUE(std::isinf(compared(none, none).relative_error));
    EXPECT_TRUE(std::isinf(compared(none, 1.0).relative_error));
    GradientCheck check;
    check.rows = {compared(1.0, 1.0), compared(none, 1.0)};
    EXPECT_TRUE(std::isinf(check.worst_error()));
}

}  // namespace
}  // namespace myo::sensitivity
