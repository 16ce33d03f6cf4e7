#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "platform/imgui_renderer.hpp"
#include "platform/theme.hpp"

struct ImGuiContext;

namespace myo::ui::platform {

/// Draws lines and labels over off-screen images of any size, with fonts rasterised for the scale of that image. Used
/// for exported images and videos, whose resolution differs from the window's.
class PictureCanvas {
public:
    /// Creates the canvas. Requires a current OpenGL context with loaded functions.
    ///
    /// @param scale  of text and line widths, 1 as in the window at scale 1
    /// @param letters  further letters of names, as in load_fonts()
    /// Error: a shader does not compile.
    static Result<PictureCanvas> make(ThemeName theme, float scale, const std::vector<ImWchar>& letters = {});

    /// Callback that draws the annotations. Coordinates are pixels from the upper left corner of the image. Of the
    /// theme's fonts only `small` is set.
    using Drawing = std::function<void(ImDrawList&, const Theme&)>;
    /// Runs `drawing` and renders its result over the content of `framebuffer`, whose size is width x height [pixels].
    void draw(GLuint framebuffer, int width, int height, const Drawing& drawing) const;

private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const;
    };

    std::unique_ptr<ImGuiContext, DestroyContext> context_;  // separate: the window's context may be within a frame
    ImguiRenderer renderer_;
    Theme theme_;
};

}  // namespace myo::ui::platform
