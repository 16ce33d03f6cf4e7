#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "platform/item_rectangles.hpp"

namespace myo::ui::platform {

/// Pixels, 8-bit RGBA, row by row from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    std::array<int, 3> color(int x, int y) const {
        const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x));
        return {rgba[i], rgba[i + 1], rgba[i + 2]};
    }
};

/// A framebuffer of the current context, 0 being that of the window; opaque.
Image read_frame(int width, int height, unsigned framebuffer = 0);

/// The part of a picture inside a rectangle [pixels].
Image cropped(const Image& image, const Rectangle& part);

/// Error: cannot be written.
Result<void> write_png(const Image& image, const std::filesystem::path& path);

}  // namespace myo::ui::platform
