#include "platform/input_queue.hpp"

namespace myo::ui::platform {
namespace {

void set_modifiers(ImGuiIO& io, const Modifiers& modifiers) {
    io.KeyCtrl = modifiers.ctrl;
    io.KeyShift = modifiers.shift;
    io.KeyAlt = modifiers.alt;
}

// Kinds of events that the frame being filled has received so far.
struct Taken {
    bool move = false;
    bool wheel = false;
    bool change = false;  // a button or key went up or down
    bool text = false;
};

/// Whether an event may go into the same frame as those already taken. The rules are documented at InputQueue.
bool may_follow(const InputEvent& event, const Taken& taken) {
    if (taken.change) return false;
    if (std::holds_alternative<MouseMoved>(event)) return !taken.wheel;
    if (std::holds_alternative<MouseButton>(event)) return !taken.move && !taken.wheel && !taken.text;
    if (std::holds_alternative<KeyPressed>(event)) return !taken.text;
    return true;
}

/// Writes one event into ImGui's input state. Unknown buttons and keys are ignored.
void take(const InputEvent& event, ImGuiIO& io, Taken& taken) {
    if (const auto* move = std::get_if<MouseMoved>(&event)) {
        io.MousePos = ImVec2(move->x, move->y);
        taken.move = true;
    } else if (const auto* button = std::get_if<MouseButton>(&event)) {
        if (button->button >= 0 && button->button < ImGuiMouseButton_COUNT) io.MouseDown[button->button] = button->down;
        set_modifiers(io, button->modifiers);
        taken.change = true;
    } else if (const auto* wheel = std::get_if<MouseWheel>(&event)) {
        io.MouseWheelH += wheel->x;
        io.MouseWheel += wheel->y;
        taken.wheel = true;
    } else if (const auto* key = std::get_if<KeyPressed>(&event)) {
        if (key->key >= 0 && key->key < key_count) io.KeysDown[key->key] = key->down;
        set_modifiers(io, key->modifiers);
        taken.change = true;
    } else if (const auto* text = std::get_if<TextTyped>(&event)) {
        io.AddInputCharacter(text->character);
        taken.text = true;
    }
}

}  // namespace

void InputQueue::apply_to_next_frame(ImGuiIO& io) {
    Taken taken;
    while (!events_.empty() && may_follow(events_.front(), taken)) {
        take(events_.front(), io, taken);
        events_.pop_front();
    }
}

}  // namespace myo::ui::platform
