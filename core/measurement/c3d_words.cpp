#include "measurement/c3d_words.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace myo::measurement {
namespace {

// VAX F format: sign, 8 exponent bits with bias 128, mantissa 0.1f. Exponent 0 means zero, or the reserved operand if
// the sign is set.
double vax_real(std::uint32_t pattern) {
    const bool negative = (pattern >> 31U) != 0;
    const int exponent = static_cast<int>((pattern >> 23U) & 0xFFU);
    if (exponent == 0) return negative ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    const double mantissa = static_cast<double>((pattern & 0x7FFFFFU) | 0x800000U);
    const double magnitude = std::ldexp(mantissa, exponent - 128 - 24);
    return negative ? -magnitude : magnitude;
}

}  // namespace

std::string_view C3dWords::text(std::size_t offset, std::size_t count) const {
    assert(holds(offset, count));
    return bytes_.substr(offset, count);
}

std::uint8_t C3dWords::byte(std::size_t offset) const {
    assert(holds(offset, 1));
    return static_cast<std::uint8_t>(bytes_[offset]);
}

std::uint16_t C3dWords::word(std::size_t offset) const {
    // DEC and Intel store the low byte first, SGI the high byte.
    const unsigned first = byte(offset);
    const unsigned second = byte(offset + 1);
    const unsigned value = processor_ == C3dProcessor::sgi ? (first << 8U | second) : (second << 8U | first);
    return static_cast<std::uint16_t>(value);
}

double C3dWords::real(std::size_t offset) const {
    // A float is two 16-bit words, whose order depends on the processor.
    const std::uint32_t first = word(offset);
    const std::uint32_t second = word(offset + 2);
    switch (processor_) {
        case C3dProcessor::intel: return static_cast<double>(std::bit_cast<float>(second << 16U | first));
        case C3dProcessor::sgi: return static_cast<double>(std::bit_cast<float>(first << 16U | second));
        case C3dProcessor::dec: return vax_real(first << 16U | second);  // the word with sign and exponent comes first
    }
    assert(false);
    return 0.0;
}

std::optional<C3dProcessor> c3d_processor(std::uint8_t code) {
    if (code < 84 || code > 86) return std::nullopt;
    return static_cast<C3dProcessor>(code);
}

}  // namespace myo::measurement
