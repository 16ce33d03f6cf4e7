#pragma once

#include <imgui.h>

#include <deque>
#include <variant>

namespace myo::ui::platform {

/// Keys that Dear ImGui 1.86 has no name for, numbered after its own.
enum ExtraKey {
    key_b = ImGuiKey_COUNT,
    key_d,
    key_e,
    key_f,
    key_k,
    key_m,
    key_o,
    key_p,
    key_q,
    key_r,
    key_s,
    key_0,
    key_1,
    key_2,
    key_3,
    key_4,
    key_plus,
    key_minus,
    key_count
};

struct Modifiers {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
};

struct MouseMoved {
    float x = 0.0f, y = 0.0f;
};  // [pixels] from the upper left corner
struct MouseButton {
    int button = 0;
    bool down = false;
    Modifiers modifiers;
};
struct MouseWheel {
    float x = 0.0f, y = 0.0f;
};  // [notches]
struct KeyPressed {
    int key = 0;
    bool down = false;
    Modifiers modifiers;
};  // ImGuiKey or ExtraKey
struct TextTyped {
    unsigned character = 0;
};

using InputEvent = std::variant<MouseMoved, MouseButton, MouseWheel, KeyPressed, TextTyped>;

/// The one way by which input reaches the interface, fed by a window's callbacks or by a test.
///
/// Dear ImGui 1.86 takes input as plain state per frame, so events that fall into one slow frame would hide each other:
/// a click shorter than a frame is lost, a press after a jump of the mouse lands on what was hovered before. Therefore
/// at most one button or key changes per frame, never in the frame of a move, and text never comes in the frame of a
/// key.
class InputQueue {
public:
    void push(const InputEvent& event) { events_.push_back(event); }
    bool empty() const { return events_.empty(); }

    /// Hands as many events as the rules allow to the coming frame.
    void apply_to_next_frame(ImGuiIO& io);

private:
    std::deque<InputEvent> events_;
};

/// Decides when to draw: while events come in, three frames more (a click takes three to show its effect), and as long
/// as something moves by itself.
class FramePacer {
public:
    void event_arrived() { frames_left_ = 3; }
    void frame_drawn() { frames_left_ = frames_left_ > 0 ? frames_left_ - 1 : 0; }
    bool must_draw(bool animating) const { return animating || frames_left_ > 0; }

private:
    int frames_left_ = 3;
};

}  // namespace myo::ui::platform
