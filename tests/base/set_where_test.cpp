#include "base/set_where.hpp"

#include <gtest/gtest.h>

namespace myo {
namespace {

/// Lanes 1, 2, ... of which those above the limit are set to 100.
template <typename T, int lanes>
void expect_set_above(int limit) {
    using Simd = std::experimental::simd<T, std::experimental::simd_abi::deduce_t<T, lanes>>;
    T numbers[lanes];
    for (int lane = 0; lane < lanes; ++lane) numbers[lane] = static_cast<T>(lane + 1);
    Simd x(numbers, std::experimental::element_aligned);
    set_where(x > static_cast<T>(limit), x, static_cast<T>(100));
    for (int lane = 0; lane < lanes; ++lane)
        EXPECT_EQ(static_cast<T>(x[static_cast<std::size_t>(lane)]),
                  lane + 1 > limit ? T(100) : static_cast<T>(lane + 1))
            << lane << " of " << lanes;
}

/// Vectors of every width that the processor has, shorter ones, and several registers.
TEST(SetWhere, SetsTheLanesOfTheMaskAlone) {
    for (const int limit : {0, 1, 3, 100}) {
        expect_set_above<double, 1>(limit);
        expect_set_above<double, 2>(limit);
        expect_set_above<double, 4>(limit);
        expect_set_above<double, 6>(limit);
        expect_set_above<double, 8>(limit);
        expect_set_above<float, 4>(limit);
        expect_set_above<float, 8>(limit);
        expect_set_above<float, 16>(limit);
        expect_set_above<float, 32>(limit);
    }
}

}  // namespace
}  // namespace myo
