#include "panels/drag_or_type.hpp"

#include <imgui_internal.h>

namespace myo::ui::panels {
namespace {

/// A frame of the set width that can be reached with Tab.
struct FieldItem {
    ImGuiID id;
    ImRect frame;
    bool visible;  // or active
    bool hovered = false;
};

/// Adds a frame to the layout of the window and makes it an item of ImGui.
FieldItem add_item(const char* label) {
    const ImGuiID id = ImGui::GetID(label);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImRect frame(corner, {corner.x + ImGui::CalcItemWidth(), corner.y + ImGui::GetFrameHeight()});
    ImGui::ItemSize(frame, ImGui::GetStyle().FramePadding.y);
    FieldItem item{id, frame, ImGui::ItemAdd(frame, id, &frame, ImGuiItemFlags_Inputable)};
    item.hovered = item.visible && ImGui::ItemHoverable(frame, id);
    return item;
}

/// Whether Tab has just reached the last item.
bool reached_by_tab(ImGuiID id) {
    return (ImGui::GetItemStatusFlags() & ImGuiItemStatusFlags_FocusedByTabbing) != 0 ||
           GImGui->NavActivateInputId == id;
}

/// Gives mouse and keyboard to an item that was pressed.
void take_mouse(ImGuiID id) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    ImGui::SetActiveID(id, window);
    ImGui::SetFocusID(id, window);
    ImGui::FocusWindow(window);
}

/// Background in the colour of the item's state, as ImGui's own fields have it.
void draw_frame(const FieldItem& item) {
    const ImGuiCol color = ImGui::GetActiveID() == item.id ? ImGuiCol_FrameBgActive
                           : item.hovered                  ? ImGuiCol_FrameBgHovered
                                                           : ImGuiCol_FrameBg;
    ImGui::RenderNavHighlight(item.frame, item.id);
    ImGui::RenderFrame(item.frame.Min, item.frame.Max, ImGui::GetColorU32(color), true,
                       ImGui::GetStyle().FrameRounding);
}

/// The text field at rest: the refused text where it was while it was typed.
void draw_resting(const FieldItem& item, const char* text) {
    draw_frame(item);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 from{item.frame.Min.x + padding.x, item.frame.Min.y + padding.y};
    const ImVec2 to{item.frame.Max.x - padding.x, item.frame.Max.y};
    ImGui::RenderTextClipped(from, to, text, nullptr, nullptr);
}

}  // namespace

DragOrType drag_number(const char* id, const DraggedNumber& number) {
    const FieldItem item = add_item(id);
    if (!item.visible) return DragOrType::nothing;
    const ImGuiIO& io = ImGui::GetIO();
    const bool clicked = item.hovered && io.MouseClicked[0];
    const bool opened = reached_by_tab(item.id) || (clicked && (io.KeyCtrl || io.MouseClickedCount[0] == 2));
    // A press that opens the text must not begin a drag as well.
    if (clicked && !opened) take_mouse(item.id);
    draw_frame(item);
    const bool dragged = !opened &&
                         ImGui::DragBehavior(item.id, ImGuiDataType_Double, &number.shown, number.speed, &number.lowest,
                                             &number.highest, "%.5g", ImGuiSliderFlags_AlwaysClamp);
    if (dragged) ImGui::MarkItemEdited(item.id);
    ImGui::RenderTextClipped(item.frame.Min, item.frame.Max, number.display.c_str(), nullptr, nullptr, {0.5f, 0.5f});
    return opened ? DragOrType::opened : dragged ? DragOrType::dragged : DragOrType::nothing;
}

DragOrType type_number(const char* id, const platform::Theme& theme, std::span<char> text, bool was_active,
                       bool activate, bool refused) {
    if (refused) ImGui::PushStyleColor(ImGuiCol_Text, theme.failure);
    const FieldItem item = add_item(id);
    const bool active = was_active && ImGui::TempInputIsActive(item.id);
    // A refused text is opened by one click: there is no number to drag.
    const bool clicked = item.hovered && ImGui::GetIO().MouseClicked[0];
    const bool opens = activate || (item.visible && !was_active && (reached_by_tab(item.id) || clicked));
    DragOrType done = was_active ? DragOrType::left : DragOrType::nothing;
    if (active || opens) {
        // InputText takes the keyboard as after Tab.
        if (opens) GImGui->LastItemData.StatusFlags |= ImGuiItemStatusFlags_FocusedByTabbing;
        // Text that was typed here before would be continued; without its id ImGui begins with the given one.
        if (opens && GImGui->TempInputId == item.id) GImGui->TempInputId = 0;
        const bool entered = ImGui::TempInputText(item.frame, item.id, id, text.data(), static_cast<int>(text.size()),
                                                  ImGuiInputTextFlags_AutoSelectAll |
                                                      ImGuiInputTextFlags_EnterReturnsTrue |
                                                      ImGuiInputTextFlags_NoMarkEdited);
        const bool goes_on = ImGui::TempInputIsActive(item.id);
        // ImGui releases the field in the frame of the key; Enter is reported by it, Escape only by the key.
        done = goes_on                                       ? DragOrType::typing
               : entered                                     ? DragOrType::entered
               : ImGui::IsKeyPressed(ImGuiKey_Escape, false) ? DragOrType::cancelled
                                                             : DragOrType::left;
    } else if (item.visible) {
        draw_resting(item, text.data());
    }
    if (refused) {
        ImGui::PopStyleColor();
        if (item.visible)
            // The red frame is drawn over the field's own in all of its states.
            ImGui::GetWindowDrawList()->AddRect(item.frame.Min, item.frame.Max, platform::packed(theme.failure),
                                                ImGui::GetStyle().FrameRounding, 0, theme.scale);
    }
    return done;
}

}  // namespace myo::ui::panels
