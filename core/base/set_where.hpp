#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>

namespace myo {

/// x = value in the lanes of the mask, in place of std::experimental::where(): under clang, libstdc++'s blend by the
/// bit masks of AVX-512 takes all lanes or none (bits/simd_x86.h of GCC 12, _S_blend_avx512(), says so in a comment).
template <typename T, typename Abi>
void set_where(const std::experimental::simd_mask<T, Abi>& mask, std::experimental::simd<T, Abi>& x,
               const std::type_identity_t<std::experimental::simd<T, Abi>>& value) {
#if defined(__clang__) && defined(__AVX512F__)
    constexpr int lanes = static_cast<int>(std::experimental::simd<T, Abi>::size());
    using Mask = std::experimental::simd_mask<T, Abi>;
    if constexpr (sizeof(Mask) <= 2 && sizeof(std::experimental::simd<T, Abi>) == lanes * sizeof(T)) {
        using Bits = std::conditional_t<sizeof(Mask) == 1, std::uint8_t, std::uint16_t>;
        using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
        using Values [[gnu::vector_size(lanes * sizeof(T))]] = T;
        using Integers [[gnu::vector_size(lanes * sizeof(T))]] = Integer;
        Integers chosen{};
        for (int lane = 0; lane < lanes; ++lane) chosen[lane] = Integer{1} << lane;
        chosen = (chosen & static_cast<Integer>(std::bit_cast<Bits>(mask))) != 0;
        const auto blended = chosen ? std::bit_cast<Values>(value) : std::bit_cast<Values>(x);
        x = std::bit_cast<std::experimental::simd<T, Abi>>(blended);
    } else {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (mask[lane]) x[lane] = value[lane];
    }
#else
    std::experimental::where(mask, x) = value;
#endif
}

}  // namespace myo
