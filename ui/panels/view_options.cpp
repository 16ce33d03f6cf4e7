#include "panels/view_options.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "commands/field_store.hpp"
#include "panels/clip_options.hpp"
#include "panels/escape.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "viewport/color_map.hpp"

namespace myo::ui::panels {
namespace {

/// An end of the range. A unit that no dimension has is not typed: the number is in it.
void draw_range_end(PanelContext& context, const commands::FieldKind& kind, NumberEdits& edits, NumberField field,
                    double& value) {
    field.dimension = commands::dimension_of_unit(kind.unit);
    const bool known = commands::find_unit(field.dimension, kind.unit) != nullptr;
    const double scale = known ? 1.0 : kind.per_unit;
    if (known)
        field.unit = kind.unit;
    else
        field.dimension = commands::Dimension::number;
    field.limits = {field.limits.lowest / scale, field.limits.highest / scale};
    double shown = value / scale;
    bool goes_on = false;
    if (number_field(context, field, edits, shown, goes_on, kind.id)) value = scale * shown;
}

/// Two fields next to each other, in the order of the colours. The ends stay apart: an empty or reversed range has no
/// colours.
void draw_range_ends(PanelContext& context, const commands::FieldKind& kind, NumberEdits& edits,
                     std::array<double, 2>& range) {
    const double far = 1e15 * kind.per_unit, infinity = std::numeric_limits<double>::infinity();
    const float width = 110.0f * context.theme.scale;
    NumberField field;
    field.name = "view/field/lowest";
    field.tip = "Value of the first colour.";
    field.quantity = "lower end";
    // Each end is limited by the other.
    field.limits = {-far, std::nextafter(range[1], -infinity)};
    ImGui::SetNextItemWidth(width);
    draw_range_end(context, kind, edits, field, range[0]);
    ImGui::SameLine();
    field.name = "view/field/highest";
    field.tip = "Value of the last colour.";
    field.quantity = "upper end";
    field.limits = {std::nextafter(range[0], infinity), far};
    ImGui::SetNextItemWidth(width);
    draw_range_end(context, kind, edits, field, range[1]);
}

/// Rows for the range of the colours, edited in the field's unit and stored in SI units.
void draw_field_range(PanelContext& context, const commands::FieldKind& kind, NumberEdits& edits,
                      commands::ViewOptions& view) {
    const auto found = view.field_ranges.find(kind.id);
    bool fixed = found != view.field_ranges.end();
    const bool was_fixed = fixed;
    ImGui::Checkbox("Fixed range", &fixed);
    context.items.mark("view/field/fixed");
    tooltip(context.theme, "Otherwise the colours span the values of the whole trial" +
                               std::string(kind.signed_values ? ", symmetric about zero." : "."));
    // A fixed range starts with the one that is shown, so that the picture does not change.
    if (fixed && !was_fixed) {
        const std::optional<std::array<double, 2>>& shown = context.field_range;
        view.field_ranges[kind.id] = shown ? std::array<double, 2>{kind.per_unit * (*shown)[0],
                                                                   kind.per_unit * (*shown)[1]}
                                           : std::array<double, 2>{kind.signed_values ? -kind.per_unit : 0.0,
                                                                   kind.per_unit};
    }
    if (!fixed && was_fixed) view.field_ranges.erase(kind.id);
    if (!fixed || !was_fixed) return;
    draw_range_ends(context, kind, edits, found->second);
}

/// Only for unsigned fields: signed ones have the diverging map.
void draw_color_map_choice(PanelContext& context, commands::ViewOptions& view) {
    // An unknown id, as of a project of another version, shows the default map.
    const viewport::ColorMap&
        shown = viewport::color_maps()[static_cast<std::size_t>(viewport::number_of_color_map(view.color_map))];
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    const bool open = ImGui::BeginCombo("Map", shown.label.c_str());
    context.items.mark("view/color_map");
    if (!open) {
        tooltip(context.theme, shown.explanation);
        return;
    }
    for (const viewport::ColorMap& map : viewport::color_maps()) {
        if (ImGui::Selectable(map.label.c_str(), map.id == shown.id)) view.color_map = map.id;
        context.items.mark("view/color_map/" + map.id);
        tooltip(context.theme, map.explanation);
    }
    ImGui::EndCombo();
}

/// Tooltip of a field: explanation, unit, and what it requires.
std::string words_about(const commands::FieldKind& kind, const std::string& needed) {
    return kind.explanation + (kind.unit.empty() ? "" : " In " + kind.unit + ".") +
           (needed.empty() ? "" : "\n\n" + needed);
}

/// Entries of the open list: none, and all fields with what they need.
void draw_field_entries(PanelContext& context, const std::vector<commands::FieldKind>& kinds,
                        commands::ViewOptions& view) {
    if (ImGui::Selectable("None", view.field.empty())) view.field.clear();
    context.items.mark("view/field/none");
    for (const commands::FieldKind& kind : kinds) {
        const std::string needed = commands::needed_for(kind, context.state);
        // A field of a run can be selected before the run; one of a diagnosis only afterwards, as that takes
        // minutes.
        ImGui::BeginDisabled(commands::of_diagnosis(kind) && !needed.empty());
        if (ImGui::Selectable(kind.label.c_str(), kind.id == view.field)) view.field = kind.id;
        ImGui::EndDisabled();
        context.items.mark("view/field/" + kind.id);
        tooltip(context.theme, words_about(kind, needed));
    }
}

// Closed, the list explains the selected field; open, each entry explains itself.
void draw_field_choice(PanelContext& context, NumberEdits& edits, commands::ViewOptions& view) {
    const std::vector<commands::FieldKind> kinds = commands::field_kinds(context.backend);
    const auto chosen = std::find_if(kinds.begin(), kinds.end(),
                                     [&](const commands::FieldKind& kind) { return kind.id == view.field; });
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    const bool open = ImGui::BeginCombo("Colours", chosen != kinds.end() ? chosen->label.c_str() : "None");
    context.items.mark("view/field");
    if (open) {
        draw_field_entries(context, kinds, view);
        ImGui::EndCombo();
    } else {
        tooltip(context.theme,
                chosen != kinds.end() ? words_about(*chosen, "") : "A quantity whose values colour the body");
    }
    // Another field may have been selected just now; its rows follow in the next frame.
    if (chosen == kinds.end() || chosen->id != view.field) return;
    if (const std::string needed = commands::needed_for(*chosen, context.state); !needed.empty())
        ImGui::TextDisabled("%s", needed.c_str());
    if (!chosen->signed_values) draw_color_map_choice(context, view);
    draw_field_range(context, *chosen, edits, view);
}

/// Options that are a single switch; the others follow below the list.
struct ViewSwitch {
    const char* label;
    const char* name;
    bool commands::ViewOptions::*value;
    const char* tip;
};
constexpr ViewSwitch view_switches[] = {
    {"Measured markers", "view/measured", &commands::ViewOptions::measured,
     "Balls at the measured positions of the markers at the shown time"},
    {"Simulated markers", "view/simulated", &commands::ViewOptions::simulated,
     "Rings at the simulated positions of the markers at the shown time, compared runs included"},
    {"Trails", "view/trails", &commands::ViewOptions::trails,
     "Paths of measured and simulated markers over the last half second"},
    {"Error lines", "view/errors", &commands::ViewOptions::errors,
     "From each measured marker to the simulated one: simulated \xe2\x88\x92 measured"},
    {"Names", "view/labels", &commands::ViewOptions::labels,
     "Next to the markers, where there is room; a click on a marker shows its name, too"},
    {"Element edges", "view/edges", &commands::ViewOptions::edges, "Edges of the elements on the body's surface"},
    {"Muscles and fibres", "view/fibres", &commands::ViewOptions::fibres,
     "Elements in the colour of their muscle, and their fibre directions F d"},
    {"Chambers and tendons", "view/actuators", &commands::ViewOptions::actuators,
     "Walls of the air chambers and paths of the tendons, each in the colour of its row in Muscles"},
    {"Force of the effect", "view/effect_force", &commands::ViewOptions::effect_force,
     "Arrows of the force that the selected row of the diagnosis puts on each part of the body; the body is "
     "translucent then. Available after Diagnose."},
    {"Clamp", "view/clamp", &commands::ViewOptions::clamp, "The box in which the body is held"},
    {"Undeformed", "view/undeformed", &commands::ViewOptions::undeformed,
     "The edges of the elements where the body lies at rest"},
    {"Side by side", "view/side_by_side", &commands::ViewOptions::side_by_side,
     "The newest run that is ticked under Compare in Jobs at the right, the shown run at the left, with the same "
     "camera, "
     "time and colours"},
    {"Loads and gravity", "view/loads", &commands::ViewOptions::loads,
     "Forces as arrows, masses as weights, where they act on the body in the shown trial; and the direction of "
     "gravity"},
    {"Obstacles and parts", "view/obstacles", &commands::ViewOptions::obstacles,
     "Rigid obstacles, and boxes of parts with a material of their own, whose elements are tinted"},
    {"Ground grid", "view/grid", &commands::ViewOptions::grid,
     "A grid below the body, in squares of 1, 2 or 5 times a power of ten of a metre"}};

/// At least 10 %: an invisible body could not be found again.
void draw_opacity(PanelContext& context, NumberEdits& edits, commands::ViewOptions& view) {
    static const NumberField field{
        "Body", "view/opacity", commands::Dimension::ratio, "%", "Opacity of the body.", {0.1, 1.0}, 0.5, "opacity"};
    ImGui::SetNextItemWidth(140.0f * context.theme.scale);
    bool goes_on = false;
    number_field(context, field, edits, view.opacity, goes_on);
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted("Body");
}

}  // namespace

void draw_view_options(PanelContext& context, const viewport::Camera& camera, NumberEdits& edits) {
    if (ImGui::Button((std::string(platform::icon::eye) + "  Show").c_str())) ImGui::OpenPopup("view options");
    context.items.mark("view/options");
    tooltip(context.theme, "What the view shows, in which colours, and a plane that cuts the body open");
    const ImVec2 below{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 4.0f * context.theme.scale};
    ImGui::SetNextWindowPos(below);
    if (!ImGui::BeginPopup("view options")) return;
    if (escape_closes()) ImGui::CloseCurrentPopup();
    // All controls edit a copy; one command is emitted if anything changed.
    commands::ViewOptions view = context.state.view;
    for (const ViewSwitch& option : view_switches) {
        ImGui::Checkbox(option.label, &(view.*option.value));
        context.items.mark(option.name);
        tooltip(context.theme, option.tip);
    }
    draw_opacity(context, edits, view);
    draw_field_choice(context, edits, view);
    draw_clip_options(context, camera, edits, view);
    if (!(view == context.state.view)) context.emit(commands::ChangeView{view});
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
