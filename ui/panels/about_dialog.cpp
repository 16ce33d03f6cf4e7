#include "panels/about_dialog.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/escape.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"

namespace myo::ui::panels {
namespace {

/// Summary of the packages' own copyright files.
constexpr const char* bound_by =
    "Myoloop's source is under the MIT licence. A distributed binary is bound by further licences: CHOLMOD's "
    "supernodal module and SPQR are under the GPL 2 or later, METIS's Apache licence is compatible with the GPL 3 "
    "only, and the mesher myoloop-tetgen contains TetGen, which is under the AGPL 3. So distribute a binary under the "
    "GPL 3, its mesher under the AGPL 3, and the source with both.";

/// Table of names, versions and licences, as the backend lists them.
void draw_libraries(const std::vector<commands::Library>& libraries) {
    if (!ImGui::BeginTable("libraries", 3, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("version", ImGuiTableColumnFlags_WidthStretch, 0.8f);
    ImGui::TableSetupColumn("licence", ImGuiTableColumnFlags_WidthStretch, 1.5f);
    for (const commands::Library& library : libraries) {
        ImGui::TableNextRow();
        // Long licences wrap within their column.
        for (const std::string* text : {&library.name, &library.version, &library.licence}) {
            ImGui::TableNextColumn();
            wrapped_text(*text);
        }
    }
    ImGui::EndTable();
}

}  // namespace

// Escape closes the dialog as the button does.
void draw_about(PanelContext& context, bool& open) {
    if (!open) return;
    const platform::Theme& theme = context.theme;
    // Width in pixels at scale 1; the licences need lines of some length.
    if (!begin_dialog(theme, "About Myoloop", 560.0f)) return;
    heading(theme, "Myoloop " + context.backend.version());
    // The list scrolls in a low window, so that the button stays visible.
    ImGui::BeginChild("about",
                      {0.0f, std::min(460.0f * theme.scale, ImGui::GetIO().DisplaySize.y - 170.0f * theme.scale)});
    muted_text(theme, "A workbench for soft robots, built on these libraries and fonts:");
    draw_libraries(context.backend.libraries());
    ImGui::Spacing();
    // The summary comes last: it follows from the licences in the list.
    muted_text(theme, bound_by);
    ImGui::EndChild();
    context.items.mark("about/text");
    ImGui::Spacing();
    if (primary_button(theme, "Close", {-1.0f, 0.0f}) || escape_closes()) {
        open = false;
        ImGui::CloseCurrentPopup();
    }
    context.items.mark("about/close");
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
