#include "platform/image.hpp"

#include <stb_image_write.h>

#include <algorithm>
#include <string>

#include "base/files.hpp"
#include "platform/gl.hpp"

namespace myo::ui::platform {

Image read_frame(int width, int height, unsigned framebuffer, bool transparent) {
    Image image{width, height, {}};
    const std::size_t row = static_cast<std::size_t>(width) * 4;
    // OpenGL returns the lowest row first; image files start at the top.
    std::vector<std::uint8_t> bottom_up(row * static_cast<std::size_t>(height));
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bottom_up.data());
    image.rgba.reserve(bottom_up.size());
    for (std::size_t y = static_cast<std::size_t>(height); y-- > 0;) {
        const auto first = bottom_up.begin() + static_cast<std::ptrdiff_t>(y * row);
        image.rgba.insert(image.rgba.end(), first, first + static_cast<std::ptrdiff_t>(row));
    }
    if (transparent) {
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
            const int alpha = image.rgba[i + 3];
            for (std::size_t k = i; alpha > 0 && k < i + 3; ++k)
                image.rgba[k] = static_cast<std::uint8_t>(std::min(255, (image.rgba[k] * 255 + alpha / 2) / alpha));
        }
        return image;
    }
    // Blending leaves arbitrary alpha values in the framebuffer, but the window itself is opaque.
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
}

Image cropped(const Image& image, const Rectangle& part) {
    const int left = std::clamp(static_cast<int>(part.lowest.x), 0, image.width),
              top = std::clamp(static_cast<int>(part.lowest.y), 0, image.height);
    Image inner{std::clamp(static_cast<int>(part.highest.x), left, image.width) - left,
                std::clamp(static_cast<int>(part.highest.y), top, image.height) - top,
                {}};
    for (int y = top; y < top + inner.height; ++y) {
        const auto row = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + left);
        inner.rgba.insert(inner.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(inner.width));
    }
    return inner;
}

Result<void> write_png(const Image& image, const std::filesystem::path& path) {
    std::string bytes;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(), image.width * 4) == 0) {
        return Error{"the picture cannot be packed as PNG", path.string()};
    }
    return write_file(path, bytes);
}

}  // namespace myo::ui::platform
