#pragma once

#include <memory>

#include "base/result.hpp"

namespace myo::ui::platform {

/// An OpenGL 3.3 context without a display, rendered in software by OSMesa. Used by tests and by the command-line image
/// export. It is current on the creating thread from make() until its destruction.
class OffscreenContext {
public:
    /// Creates the context, makes it current and loads the functions of gl.hpp.
    ///
    /// @param width, height  size of the default framebuffer [pixels], 1 to 16384
    /// Error: Mesa cannot create a 3.3 core context, or the size is out of range.
    static Result<OffscreenContext> make(int width, int height);

    // Size of the default framebuffer [pixels].
    int width() const;
    int height() const;

    /// Changes the size [pixels] of the default framebuffer; its content is lost. Error: the size is out of range.
    Result<void> resize(int width, int height);

private:
    struct Content;
    struct Destroy {
        void operator()(Content* content) const;
    };
    std::unique_ptr<Content, Destroy> content_;
};

}  // namespace myo::ui::platform
