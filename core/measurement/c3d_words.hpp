#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace myo::measurement {

/// The machine whose number formats a C3D file uses; the values are the file's own codes.
enum class C3dProcessor : std::uint8_t { intel = 84, dec = 85, sgi = 86 };

/// The bytes of a C3D file, read as numbers of one processor.
///
/// Offsets count from the start of the file. Every read is checked by the caller with `holds`; inside, only asserted.
class C3dWords {
public:
    C3dWords(std::string_view bytes, C3dProcessor processor) : bytes_(bytes), processor_(processor) {}

    std::size_t size() const { return bytes_.size(); }
    /// Whether `count` bytes from `offset` lie inside the file; safe against overflow.
    bool holds(std::size_t offset, std::size_t count) const {
        return offset <= bytes_.size() && count <= bytes_.size() - offset;
    }
    std::string_view text(std::size_t offset, std::size_t count) const;
    std::uint8_t byte(std::size_t offset) const;
    std::int8_t signed_byte(std::size_t offset) const { return static_cast<std::int8_t>(byte(offset)); }
    std::uint16_t word(std::size_t offset) const;
    std::int16_t signed_word(std::size_t offset) const { return static_cast<std::int16_t>(word(offset)); }
    /// 32-bit float; NaN for the reserved operand of DEC.
    double real(std::size_t offset) const;

private:
    std::string_view bytes_;
    C3dProcessor processor_;
};

/// The processor of a code byte, or nothing when the code is not one of the format's three.
std::optional<C3dProcessor> c3d_processor(std::uint8_t code);

}  // namespace myo::measurement
