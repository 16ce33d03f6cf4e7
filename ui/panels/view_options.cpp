#include "panels/view_options.hpp"

#include <imgui.h>

#include "platform/fonts.hpp"

namespace myo {

void draw_view_options(PanelContext& context) {
    if (ImGui::Button((std::string(icon::eye) + "  Show").c_str())) ImGui::OpenPopup("view options");
    context.items.mark("view/options");
    const ImVec2 below{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 4.0f * context.theme.scale};
    ImGui::SetNextWindowPos(below);
    if (!ImGui::BeginPopup("view options")) return;
    struct Option { const char* label; const char* name; bool ViewOptions::* value; };
    static constexpr Option options[] = {{"Measured markers", "view/measured", &ViewOptions::measured},
                                         {"Simulated markers", "view/simulated", &ViewOptions::simulated},
                                         {"Trails", "view/trails", &ViewOptions::trails},
                                         {"Error lines", "view/errors", &ViewOptions::errors},
                                         {"Names", "view/labels", &ViewOptions::labels},
                                         {"Element edges", "view/edges", &ViewOptions::edges},
                                         {"Muscles and fibres", "view/fibres", &ViewOptions::fibres},
                                         {"Force of the effect", "view/effect_force", &ViewOptions::effect_force},
                                         {"Displacement colours", "view/displacement", &ViewOptions::displacement},
                                         {"Clamp", "view/clamp", &ViewOptions::clamp},
                                         {"Ground grid", "view/grid", &ViewOptions::grid}};
    ViewOptions view = context.state.view;
    for (const Option& option : options) {
        ImGui::Checkbox(option.label, &(view.*option.value));
        context.items.mark(option.name);
    }
    float opacity = static_cast<float>(100.0 * view.opacity);
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    if (ImGui::SliderFloat("Body", &opacity, 10.0f, 100.0f, "%.0f %%", ImGuiSliderFlags_AlwaysClamp)) {
        view.opacity = 0.01 * static_cast<double>(opacity);
    }
    context.items.mark("view/opacity");
    if (!(view == context.state.view)) context.emit(command::ChangeView{view});
    ImGui::EndPopup();
}

}  // namespace myo
