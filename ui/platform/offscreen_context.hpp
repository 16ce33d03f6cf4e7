#pragma once

#include <memory>

#include "base/result.hpp"

namespace myo::ui::platform {

/// An OpenGL context without a display (OSMesa, software), current from its making until its end.
class OffscreenContext {
public:
    /// @param width, height  of the default framebuffer [pixels]
    /// Error: Mesa cannot make a 3.3 core context.
    static Result<OffscreenContext> make(int width, int height);

    int width() const;
    int height() const;

    /// Gives the default framebuffer another size; its content is lost.
    Result<void> resize(int width, int height);

private:
    struct Content;
    struct Destroy {
        void operator()(Content* content) const;
    };
    std::unique_ptr<Content, Destroy> content_;
};

}  // namespace myo::ui::platform
