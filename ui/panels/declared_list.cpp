#include "panels/declared_list.hpp"

#include <imgui.h>

#include "panels/tables.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {

ItemPress item_heading(PanelContext& context, const ItemHeading& heading, float reserved) {
    const float button = ImGui::GetFrameHeight(), spacing = ImGui::GetStyle().ItemSpacing.x;
    const float right = ImGui::GetWindowContentRegionMax().x;
    const bool open = is_open(context, heading.item);
    ImGui::PushID(heading.item.c_str());
    if (heading.muted) ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    ImGui::AlignTextToFramePadding();
    // The state decides what is open, not ImGui: the view must highlight the same thing, and one is open at a time.
    ImGui::SetNextItemOpen(open);
    // The title leaves room for the controls at the right.
    const float room = right - ImGui::GetCursorPosX() - button - spacing - reserved -
                       ImGui::GetTreeNodeToLabelSpacing();
    const bool now = ImGui::TreeNodeEx("##title", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
                                       elided(heading.title, room).c_str());
    if (heading.muted) ImGui::PopStyleColor();
    context.items.mark(heading.item);
    tooltip(context.theme, heading.tip);
    if (now != open) open_item(context, now ? heading.item : "");
    ImGui::SameLine(right - button);
    const bool removed = ImGui::Button(platform::icon::remove, {button, 0.0f});
    context.items.mark(heading.item + "/remove");
    tooltip(context.theme, heading.remove_tip);
    // The next thing in the list would take the name of the removed one, and open.
    if (removed) open_item(context, "");
    ImGui::PopID();
    return removed ? ItemPress::removed : ItemPress::nothing;
}

bool is_open(const PanelContext& context, const std::string& item) { return context.state.view.edited == item; }

void open_item(PanelContext& context, const std::string& item) {
    commands::ViewOptions view = context.state.view;
    view.edited = item;
    context.emit(commands::ChangeView{view});
}

}  // namespace myo::ui::panels
