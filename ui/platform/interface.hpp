#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "platform/fonts.hpp"
#include "platform/imgui_renderer.hpp"
#include "platform/input_queue.hpp"
#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"

struct ImGuiContext;

namespace myo::ui::platform {

/// Owns Dear ImGui's context, fonts, theme, input queue and renderer. One per process and OpenGL context; used on the
/// UI thread only.
///
/// A frame is begin_frame(), the panels, end_frame(), draw().
class Interface {
public:
    /// Creates the interface. Requires a current OpenGL context with loaded functions.
    ///
    /// @param scale  of text and controls; 1 = default size
    /// Error: a shader does not compile.
    static Result<Interface> make(ThemeName theme, float scale);

    /// Starts a frame: rebuilds fonts if the theme changed, applies queued input and clears the recorded item
    /// rectangles.
    ///
    /// @param width, height  size of the window's framebuffer [pixels]
    /// @param seconds  time since the last frame
    void begin_frame(int width, int height, float seconds);
    /// Ends the frame and generates ImGui's draw lists.
    void end_frame();
    /// Draws the lists into the default framebuffer, over what is there. Call it after end_frame().
    void draw() const;

    /// Changes theme and scale from the next frame on; fonts and their texture are rebuilt then. The scale is limited
    /// to 0.75 … 3.
    void set_theme(ThemeName name, float scale);
    /// Loads the letters of a text that the fonts lack, from the next frame on: names in other scripts. Quick if there
    /// are none.
    void need_letters(const std::string& text);

    /// The letters that need_letters() has asked for, as ranges of ImGui.
    const std::vector<ImWchar>& letters() const { return letters_; }
    /// Whether no font has some of them: they are drawn as U+FFFD.
    bool lacks_letters() const { return lacks_letters_; }

    const Theme& theme() const { return theme_; }
    InputQueue& input() { return *input_; }
    ItemRectangles& items() { return *items_; }

private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const;
    };
    /// Applies the theme to ImGui's style and rebuilds the fonts. Not within a frame, as ImGui must not draw with old
    /// fonts.
    void rebuild();

    std::unique_ptr<ImGuiContext, DestroyContext> context_;
    ImguiRenderer renderer_;
    Theme theme_;
    std::vector<ImWchar> letters_;  // loaded in addition, as ranges of one, ended by 0
    bool lacks_letters_ = false;    // see lacks_letters()
    bool rebuild_ = true;           // the theme changed since the last frame
    std::unique_ptr<InputQueue> input_ = std::make_unique<InputQueue>();  // on the heap: callbacks keep its address
    // on the heap: panels keep its address
    std::unique_ptr<ItemRectangles> items_ = std::make_unique<ItemRectangles>();
};

}  // namespace myo::ui::platform
