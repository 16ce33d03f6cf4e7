#pragma once

#include <Eigen/Core>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstddef>
#include <experimental/simd>
#include <limits>

namespace myo {

/// As many numbers as the processor handles at once: one lane per cell. Formulas are templates over double and Pack, so that
/// the vectorised kernel and the tests of single points run the same code.
using Pack = std::experimental::native_simd<double>;
using PackMask = Pack::mask_type;
inline constexpr int pack_width = static_cast<int>(Pack::size());

inline Pack load_pack(const double* lanes) { return Pack(lanes, std::experimental::element_aligned); }

/// J^(-1/3), not a number for J <= 0.
inline double inverse_cube_root(double J) { return J > 0.0 ? 1.0 / std::cbrt(J) : std::numeric_limits<double>::quiet_NaN(); }

/// From a guess on the exponent's bits (5 % off), five Newton steps on y^-3 = J, which square the error.
inline Pack inverse_cube_root(const Pack& J) {
    const Pack y0([&](auto lane) {
        const auto high = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(static_cast<double>(J[lane])) >> 32);
        return std::bit_cast<double>(static_cast<std::uint64_t>(0x553ef0ffu - high / 3u) << 32);
    });
    Pack y = y0;
    for (int step = 0; step < 5; ++step) y *= (4.0 - J * y * y * y) * (1.0 / 3.0);
    std::experimental::where(!(J > 0.0), y) = std::numeric_limits<double>::quiet_NaN();
    return y;
}

/// ln J, not a number for J < 0.
inline double logarithm(double J) { return std::log(J); }
inline Pack logarithm(const Pack& J) { return std::experimental::log(J); }

}  // namespace myo

namespace Eigen {

/// Packs as scalars of small fixed-size matrices.
template <>
struct NumTraits<myo::Pack> : GenericNumTraits<myo::Pack> {
    using Real = myo::Pack;
    using NonInteger = myo::Pack;
    using Nested = myo::Pack;
    using Literal = double;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};

}  // namespace Eigen
