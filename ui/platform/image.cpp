#include "platform/image.hpp"

#include <stb_image_write.h>

#include <algorithm>
#include <string>

#include "base/files.hpp"
#include "platform/gl.hpp"

namespace myo {

Image read_frame(int width, int height, unsigned framebuffer) {
    Image image{width, height, {}};
    const std::size_t row = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> bottom_up(row * static_cast<std::size_t>(height));
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bottom_up.data());
    image.rgba.reserve(bottom_up.size());
    for (std::size_t y = static_cast<std::size_t>(height); y-- > 0;) {
        const auto first = bottom_up.begin() + static_cast<std::ptrdiff_t>(y * row);
        image.rgba.insert(image.rgba.end(), first, first + static_cast<std::ptrdiff_t>(row));
    }
    // A window is opaque whatever blending left in its alpha.
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
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

}  // namespace myo
