#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace myo::measurement {

/// A file consists of blocks of this size [bytes]. Source: c3d.org, "The C3D file format".
struct C3dFormat {
    std::size_t block_size = 512;
};
inline constexpr C3dFormat c3d_format;

/// Number format of a C3D file, named after the processor. The values are the codes in the file.
enum class C3dProcessor : std::uint8_t { intel = 84, dec = 85, sgi = 86 };

/// Bytes of a C3D file, decoded in the number format of one processor.
///
/// Offsets count from the start of the file. The caller checks the range with holds(); the reads only assert it.
/// The bytes are not copied and must outlive the object.
class C3dWords {
public:
    C3dWords(std::string_view bytes, C3dProcessor processor) : bytes_(bytes), processor_(processor) {}

    std::size_t size() const { return bytes_.size(); }
    /// Whether `count` bytes from `offset` lie within the file. Safe against integer overflow.
    bool holds(std::size_t offset, std::size_t count) const {
        return offset <= bytes_.size() && count <= bytes_.size() - offset;
    }
    /// `count` bytes as text.
    std::string_view text(std::size_t offset, std::size_t count) const;
    /// Unsigned byte.
    std::uint8_t byte(std::size_t offset) const;
    /// Byte as two's complement.
    std::int8_t signed_byte(std::size_t offset) const { return static_cast<std::int8_t>(byte(offset)); }
    /// Unsigned 16-bit word.
    std::uint16_t word(std::size_t offset) const;
    /// 16-bit word as two's complement.
    std::int16_t signed_word(std::size_t offset) const { return static_cast<std::int16_t>(word(offset)); }
    /// 32-bit float; NaN for the reserved operand of the DEC format.
    double real(std::size_t offset) const;

private:
    std::string_view bytes_;
    C3dProcessor processor_;
};

/// Processor of a code byte; nullopt if the code is not one of the three of the format.
std::optional<C3dProcessor> c3d_processor(std::uint8_t code);

}  // namespace myo::measurement
