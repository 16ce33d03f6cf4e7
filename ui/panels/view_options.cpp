#include "panels/view_options.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "commands/field_store.hpp"
#include "panels/clip_options.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "viewport/color_map.hpp"

namespace myo {
namespace {

/// Least and greatest value of the colours, in the field's unit.
void draw_field_range(PanelContext& context, const FieldKind& kind, ViewOptions& view) {
    const auto found = view.field_ranges.find(kind.id);
    bool fixed = found != view.field_ranges.end();
    const bool was_fixed = fixed;
    ImGui::Checkbox("Fixed range", &fixed);
    context.items.mark("view/field/fixed");
    tooltip(context.theme, "Without it, the colours span what the whole trial reaches" + std::string(kind.signed_values ? ", evenly to both sides of zero." : "."));
    if (fixed && !was_fixed) {
        const std::optional<std::array<double, 2>>& shown = context.field_range;
        view.field_ranges[kind.id] = shown ? std::array<double, 2>{kind.per_unit * (*shown)[0], kind.per_unit * (*shown)[1]} : std::array<double, 2>{kind.signed_values ? -kind.per_unit : 0.0, kind.per_unit};
    }
    if (!fixed && was_fixed) view.field_ranges.erase(kind.id);
    if (!fixed || !was_fixed) return;
    std::array<double, 2>& range = found->second;
    std::array<double, 2> typed{range[0] / kind.per_unit, range[1] / kind.per_unit};
    const std::string format = "%.4g " + kind.unit;
    ImGui::SetNextItemWidth(220.0f * context.theme.scale);
    const bool changed = ImGui::InputScalarN("##range", ImGuiDataType_Double, typed.data(), 2, nullptr, nullptr, format.c_str(), ImGuiInputTextFlags_EnterReturnsTrue);
    context.items.mark("view/field/range");
    if (changed && std::isfinite(typed[0]) && std::isfinite(typed[1]) && typed[0] < typed[1]) range = {kind.per_unit * typed[0], kind.per_unit * typed[1]};
}

void draw_color_map_choice(PanelContext& context, ViewOptions& view) {
    const ColorMap& shown = color_maps()[static_cast<std::size_t>(number_of_color_map(view.color_map))];
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    const bool open = ImGui::BeginCombo("Map", shown.label.c_str());
    context.items.mark("view/color_map");
    if (!open) return;
    for (const ColorMap& map : color_maps()) {
        if (ImGui::Selectable(map.label.c_str(), map.id == shown.id)) view.color_map = map.id;
        context.items.mark("view/color_map/" + map.id);
    }
    ImGui::EndCombo();
}

void draw_field_choice(PanelContext& context, ViewOptions& view) {
    const std::vector<FieldKind> kinds = field_kinds(context.backend);
    const auto chosen = std::find_if(kinds.begin(), kinds.end(), [&](const FieldKind& kind) { return kind.id == view.field; });
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    const bool open = ImGui::BeginCombo("Colours", chosen != kinds.end() ? chosen->label.c_str() : "None");
    context.items.mark("view/field");
    if (open) {
        if (ImGui::Selectable("None", view.field.empty())) view.field.clear();
        context.items.mark("view/field/none");
        for (const FieldKind& kind : kinds) {
            if (ImGui::Selectable(kind.label.c_str(), kind.id == view.field)) view.field = kind.id;
            context.items.mark("view/field/" + kind.id);
            tooltip(context.theme, kind.explanation);
        }
        ImGui::EndCombo();
    }
    if (chosen == kinds.end() || chosen->id != view.field) return;
    if (!context.field_range) ImGui::TextDisabled("%s", of_diagnosis(*chosen) ? "Needs a diagnosis, and a row of it with forces." : "Needs a run.");
    if (!chosen->signed_values) draw_color_map_choice(context, view);
    draw_field_range(context, *chosen, view);
}

}  // namespace

void draw_view_options(PanelContext& context, const Camera& camera) {
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
    draw_field_choice(context, view);
    draw_clip_options(context, camera, view);
    if (!(view == context.state.view)) context.emit(command::ChangeView{view});
    ImGui::EndPopup();
}

}  // namespace myo
