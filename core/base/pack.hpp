#pragma once

#include <Eigen/Core>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <limits>
#include <numbers>

#include "base/set_where.hpp"

namespace myo {

/// One SIMD register of doubles; each lane holds the value of one cell.
///
/// Formulas are templates over double and Pack, so that the vectorised kernel and the single-point tests run the same
/// code.
using Pack = std::experimental::native_simd<double>;
using PackMask = Pack::mask_type;
inline constexpr int pack_width = static_cast<int>(Pack::size());  // lanes per register

/// Loads pack_width consecutive numbers; no alignment required.
inline Pack load_pack(const double* lanes) { return Pack(lanes, std::experimental::element_aligned); }

/// J^(-1/3); NaN for J <= 0.
inline double inverse_cube_root(double J) {
    return J > 0.0 ? 1.0 / std::cbrt(J) : std::numeric_limits<double>::quiet_NaN();
}

/// Bit patterns of all lanes, for the logarithm and the inverse cube root below.
using PackBits = std::experimental::rebind_simd_t<std::uint64_t, Pack>;
static_assert(sizeof(PackBits) == sizeof(Pack));
inline PackBits bits_of(const Pack& x) { return std::bit_cast<PackBits>(x); }
inline Pack pack_of_bits(const PackBits& bits) { return std::bit_cast<Pack>(bits); }

/// J^(-1/3) per lane; NaN for J <= 0.
///
/// The initial value comes from integer arithmetic on the bits (multiplication of the upper half by 2^32 / 3 divides
/// exponent and mantissa by three; relative error 3.5 %). Two iterations of fourth order on y^-3 = J follow: with e = 1
/// - J y^3 the root is y (1 + e/3 + 2 e^2/9 + 14 e^3/81 + ...).
inline Pack inverse_cube_root(const Pack& J) {
    const PackBits third = ((bits_of(J) >> 32) * PackBits(0x55555556u)) >> 32;
    Pack y = pack_of_bits((PackBits(0x553ef0ffu) - third) << 32);
    for (int step = 0; step < 2; ++step) {
        const Pack e = 1.0 - J * y * y * y;
        y += y * e * (1.0 / 3.0 + e * (2.0 / 9.0 + (14.0 / 81.0) * e));
    }
    set_where(!(J > 0.0), y, std::numeric_limits<double>::quiet_NaN());
    return y;
}

/// ln J; NaN for J < 0.
inline double logarithm(double J) { return std::log(J); }

/// ln J per lane; -inf for 0 and NaN for J < 0. The standard library evaluates lane by lane, this series does not.
///
/// J = 2^k m with m within a factor sqrt(2) of 1, and f = (m - 1) / (m + 1): ln J = k ln 2 + 2 (f + f^3/3 + f^5/5 +
/// ...).
inline Pack logarithm(const Pack& J) {
    const PackBits bits = bits_of(J);
    Pack m = pack_of_bits((bits & PackBits(0x000fffffffffffffull)) | PackBits(0x3ff0000000000000ull));
    // Converts the exponent to floating point without a lane-wise conversion: its bits become the mantissa of 2^52 +
    // exponent, and the constant is subtracted.
    Pack k = pack_of_bits((bits >> 52) | PackBits(0x4330000000000000ull)) - (4503599627370496.0 + 1023.0);
    const PackMask large = m > std::numbers::sqrt2;
    set_where(large, m, 0.5 * m);
    set_where(large, k, k + 1.0);
    const Pack f = (m - 1.0) / (m + 1.0), f2 = f * f;
    Pack sum = 1.0 / 21.0;
    for (int n = 19; n > 0; n -= 2) sum = sum * f2 + 1.0 / n;
    Pack result = k * std::numbers::ln2 + 2.0 * f * sum;
    set_where(J == 0.0, result, -std::numeric_limits<double>::infinity());
    set_where(!(J >= 0.0), result, std::numeric_limits<double>::quiet_NaN());
    set_where(J == std::numeric_limits<double>::infinity(), result, J);
    return result;
}

}  // namespace myo

namespace Eigen {

/// Registers Pack as a scalar type, so that Eigen's small fixed-size matrices can hold one cell per lane.
template <>
struct NumTraits<myo::Pack> : GenericNumTraits<myo::Pack> {
    using Real = myo::Pack;
    using NonInteger = myo::Pack;
    using Nested = myo::Pack;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 0,
        ReadCost = 1,
        AddCost = 1,
        MulCost = 1
    };
};

}  // namespace Eigen
