#pragma once

#include <functional>
#include <memory>

#include "base/result.hpp"
#include "platform/imgui_renderer.hpp"
#include "platform/theme.hpp"

struct ImGuiContext;

namespace myo::ui::platform {

/// Draws lines and labels over pictures that are not the window, with letters made for their size.
class PictureCanvas {
public:
    /// Needs a current context with loaded functions.
    /// @param scale  of text and lines
    static Result<PictureCanvas> make(ThemeName theme, float scale);

    /// What is drawn, in pixels from the upper left corner; of the theme's fonts it has the small one.
    using Drawing = std::function<void(ImDrawList&, const Theme&)>;
    void draw(GLuint framebuffer, int width, int height, const Drawing& drawing) const;

private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const;
    };

    std::unique_ptr<ImGuiContext, DestroyContext> context_;  // of its own: the window's may be in the middle of a frame
    ImguiRenderer renderer_;
    Theme theme_;
};

}  // namespace myo::ui::platform
