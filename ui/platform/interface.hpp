#pragma once

#include <filesystem>
#include <memory>

#include "base/result.hpp"
#include "platform/fonts.hpp"
#include "platform/imgui_renderer.hpp"
#include "platform/input_queue.hpp"
#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"

struct ImGuiContext;

namespace myo::ui::platform {

/// Dear ImGui with its fonts, theme, input and renderer. One per process and OpenGL context.
class Interface {
public:
    /// Needs a current context with loaded functions.
    static Result<Interface> make(ThemeName theme, float scale);

    /// Starts a frame: applies input, clears the list of items.
    /// @param seconds  since the last frame
    void begin_frame(int width, int height, float seconds);
    /// Lays out what was submitted; draw() then puts it into the default framebuffer.
    void end_frame();
    void draw() const;

    /// Takes effect at the start of the next frame.
    void set_theme(ThemeName name, float scale);

    const Theme& theme() const { return theme_; }
    InputQueue& input() { return *input_; }
    ItemRectangles& items() { return *items_; }

private:
    struct DestroyContext {
        void operator()(ImGuiContext* context) const;
    };
    void rebuild();

    std::unique_ptr<ImGuiContext, DestroyContext> context_;
    ImguiRenderer renderer_;
    Theme theme_;
    bool rebuild_ = true;
    std::unique_ptr<InputQueue> input_ = std::make_unique<InputQueue>();  // on the heap: callbacks keep its address
    std::unique_ptr<ItemRectangles> items_ = std::make_unique<ItemRectangles>();
};

}  // namespace myo::ui::platform
