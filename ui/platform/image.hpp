#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "platform/item_rectangles.hpp"

namespace myo::ui::platform {

/// An 8-bit RGBA image, stored row by row from the top, 4 bytes per pixel.
struct Image {
    int width = 0;                   // [pixels]
    int height = 0;                  // [pixels]
    std::vector<std::uint8_t> rgba;  // 4 x width x height bytes

    /// Red, green and blue (0 to 255) of the pixel at column x, row y, counted from the upper left corner. No bounds
    /// check.
    std::array<int, 3> color(int x, int y) const {
        const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x));
        return {rgba[i], rgba[i + 1], rgba[i + 2]};
    }
};

/// Reads the lower left width x height pixels of a framebuffer of the current context; 0 is the framebuffer of the
/// window. Waits for the GPU.
///
/// @param transparent  the framebuffer was cleared to transparent black and blended over: its colours are divided by
///                     their opacity, as image files want them. Otherwise alpha is set to opaque
Image read_frame(int width, int height, unsigned framebuffer = 0, bool transparent = false);

/// Returns the part of an image inside a rectangle [pixels, origin at the upper left], cut off at the image's edges.
/// May be empty.
Image cropped(const Image& image, const Rectangle& part);

/// Writes an image as PNG. Error: the file cannot be written, or the image cannot be encoded.
Result<void> write_png(const Image& image, const std::filesystem::path& path);

}  // namespace myo::ui::platform
