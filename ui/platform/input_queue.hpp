#pragma once

#include <imgui.h>

#include <deque>
#include <variant>

namespace myo::ui::platform {

/// Keys for which Dear ImGui 1.86 has no name, numbered after ImGuiKey. Shortcuts use them; KeyPressed carries either
/// kind.
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
    key_f1,
    key_count
};

/// Modifier keys that were held down when an event happened.
struct Modifiers {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
};

// Input events, as the window's callbacks or a test create them. Coordinates are in pixels, origin at the upper left.
struct MouseMoved {
    float x = 0.0f, y = 0.0f;  // [pixels] from the upper left corner of the window
};
/// A mouse button went down or up at the last reported position.
struct MouseButton {
    int button = 0;  // 0 left, 1 right, 2 middle, as in ImGui
    bool down = false;
    Modifiers modifiers;
};
/// The wheel was turned. Horizontal wheels report x.
struct MouseWheel {
    float x = 0.0f, y = 0.0f;  // [notches]; y > 0: away from the user
};
/// A key went down or up.
struct KeyPressed {
    int key = 0;  // ImGuiKey or ExtraKey
    bool down = false;
    Modifiers modifiers;
};
/// One character of text input, after keyboard layout and dead keys.
struct TextTyped {
    unsigned character = 0;  // Unicode code point
};

using InputEvent = std::variant<MouseMoved, MouseButton, MouseWheel, KeyPressed, TextTyped>;

/// Receives all user input for the interface, from the window's callbacks or from a test, and distributes it over
/// frames.
///
/// Dear ImGui 1.86 reads input as plain state once per frame, so events that fall into one slow frame would hide each
/// other: a click shorter than a frame is lost, and a press after a jump of the mouse acts on the item that was hovered
/// before. Therefore a frame gets at most one change of a button or key, never together with a mouse move before it,
/// and no text together with a key.
///
/// Used on the UI thread only.
class InputQueue {
public:
    void push(const InputEvent& event) { events_.push_back(event); }
    bool empty() const { return events_.empty(); }

    /// Writes as many queued events as the rules allow into ImGui's input state; the rest stays for later frames. Call
    /// it just before ImGui::NewFrame().
    void apply_to_next_frame(ImGuiIO& io);

private:
    std::deque<InputEvent> events_;  // oldest first
};

/// Decides whether the next frame has to be drawn, so that an idle window draws nothing.
///
/// Each event asks for three more frames, because a click takes three to show its effect. While `animating`, every
/// frame is drawn. Not drawing is safe: the window keeps its last image.
class FramePacer {
public:
    /// Call it for each input event and each wake-up from a background job.
    void event_arrived() { frames_left_ = 3; }
    /// Call it after each drawn frame.
    void frame_drawn() { frames_left_ = frames_left_ > 0 ? frames_left_ - 1 : 0; }
    /// @param animating  something changes without input, such as a playing trial
    bool must_draw(bool animating) const { return animating || frames_left_ > 0; }

private:
    int frames_left_ = 3;  // the first frames after the start count as requested
};

}  // namespace myo::ui::platform
