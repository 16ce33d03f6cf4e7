#include "platform/offscreen_context.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include "platform/gl.hpp"

// osmesa.h includes the legacy gl.h, whose declarations clash with glcorearb.h, so the four functions in use are
// declared here.
extern "C" {
struct osmesa_context;
osmesa_context* OSMesaCreateContextAttribs(const int* attributes, osmesa_context* share);
void OSMesaDestroyContext(osmesa_context* context);
unsigned char OSMesaMakeCurrent(osmesa_context* context, void* buffer, unsigned type, int width, int height);
myo::ui::platform::gl::AnyFunction OSMesaGetProcAddress(const char* name);
}

namespace myo::ui::platform {

/// OSMesa renders into memory that the caller owns: `pixels` is the default framebuffer and must outlive the current
/// context.
struct OffscreenContext::Content {
    osmesa_context* context = nullptr;
    std::vector<unsigned char> pixels;
    int width = 0;
    int height = 0;

    bool make_current(int new_width, int new_height) {
        width = new_width;
        height = new_height;
        pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0);
        return OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height) != 0;
    }
};

void OffscreenContext::Destroy::operator()(Content* content) const {
    if (content->context != nullptr) OSMesaDestroyContext(content->context);
    delete content;
}

Result<OffscreenContext> OffscreenContext::make(int width, int height) {
    // Constants of osmesa.h: format, depth bits, profile, version.
    constexpr int format = 0x22, depth_bits = 0x30, profile = 0x33, core_profile = 0x34;
    constexpr int version_major = 0x36, version_minor = 0x37, rgba = 0x1908;
    const int attributes[] = {format,        rgba, depth_bits,    24, profile, core_profile,
                              version_major, 3,    version_minor, 3,  0};
    OffscreenContext made;
    made.content_.reset(new Content);
    made.content_->context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (made.content_->context == nullptr)
        return Error{"cannot make an OpenGL 3.3 context without a display", "OSMesa"};
    if (const auto sized = made.resize(width, height); !sized) return sized.error();
    if (const auto loaded = gl::load(OSMesaGetProcAddress); !loaded) return loaded.error();
    return made;
}

int OffscreenContext::width() const { return content_->width; }
int OffscreenContext::height() const { return content_->height; }

Result<void> OffscreenContext::resize(int width, int height) {
    // Checked here, because OSMesaMakeCurrent reports only that it failed.
    if (width < 1 || height < 1 || width > 16384 || height > 16384) {
        return Error{"a picture must be 1 to 16384 pixels wide and high, not " + std::to_string(width) + " x " +
                         std::to_string(height),
                     ""};
    }
    if (content_->make_current(width, height)) return {};
    return Error{"cannot draw at " + std::to_string(width) + " x " + std::to_string(height), "OSMesa"};
}

}  // namespace myo::ui::platform
