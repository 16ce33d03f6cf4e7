#include "panels/effect_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "commands/units.hpp"
#include "effect/catalogue.hpp"
#include "effect/readable_quantity.hpp"

namespace myo::ui::panels {
namespace {

using effect::EffectParameter;
using effect::EffectParameterEntry;
using effect::EffectParameterKind;

constexpr double drag_share = 0.02;  // of a change that matters, per pixel of dragging
constexpr double plain_drag = 0.01;  // of the shown value, for numbers without such a change
constexpr double unbounded = 1e300;  // ranges beyond are none

/// How a number of an effect is shown. Units that number fields do not know stand in the label; the field has a plain
/// number then.
struct ShownNumber {
    NumberField field;
    double factor = 1.0;  // number of the field per SI value of the parameter
};

/// Field of a number of an effect.
///
/// @param item  item name of the effect
/// @param part  coordinate or number of a component; empty for a parameter with one number
ShownNumber shown_number(const EffectParameterEntry& entry, const std::string& item, const std::string& part) {
    const effect::ReadableQuantity quantity = effect::readable_quantity(entry.name);
    ShownNumber shown;
    NumberField& field = shown.field;
    field.label = effect::effect_name(quantity.name) + (part.empty() ? "" : " " + part);
    field.name = item + "/" + entry.name + (part.empty() ? "" : "/" + part);
    field.tip = entry.name;
    // The unit must mean the same to both modules, otherwise typed units would be converted wrongly.
    const commands::Dimension dimension = commands::dimension_of_unit(quantity.unit);
    const commands::Unit* const unit = commands::find_unit(dimension, quantity.unit);
    if (!quantity.unit.empty() && unit && std::abs(quantity.factor * unit->si() - 1.0) < 1e-9) {
        field.dimension = dimension;
        field.unit = quantity.unit;
    } else {
        shown.factor = quantity.factor;
        if (!quantity.unit.empty()) field.label += " [" + quantity.unit + "]";
    }
    // The upper bound of a signal's parameter holds for muscles, whose unit is 1; pressures and forces may exceed it.
    field.limits = {shown.factor * std::max(-unbounded, entry.lowest),
                    shown.factor * std::min(unbounded, entry.of_signal ? unbounded : entry.highest)};
    if (entry.kind == EffectParameterKind::direction) field.limits = {-1.0, 1.0};
    field.smallest_step = entry.scale > 0.0 ? drag_share * quantity.factor * entry.scale : plain_drag;
    return shown;
}

/// Draws one number; true if it changed.
bool number_of_effect(PanelContext& context, const ShownNumber& shown, NumberEdits& edits, double& value,
                      bool& goes_on) {
    double scaled = shown.factor * value;
    if (!number_row(context, shown.field, edits, scaled, goes_on)) return false;
    value = scaled / shown.factor;
    return true;
}

/// A row per component of a vector or list: x, y and z, or 1, 2, ... in a list.
void vector_of_effect(PanelContext& context, const EditedEffect& edited, const EffectParameterEntry& entry,
                      const Eigen::VectorXd& value, NumberEdits& edits) {
    for (Eigen::Index k = 0; k < value.size(); ++k) {
        std::string part = std::to_string(k + 1);
        if (entry.kind != EffectParameterKind::number_or_list && k < 3) part = axis_names[static_cast<std::size_t>(k)];
        Eigen::VectorXd changed = value;
        bool goes_on = false;
        if (!number_of_effect(context, shown_number(entry, edited.item, part), edits, changed(k), goes_on)) continue;
        const EffectParameter parameter = changed;
        edited.change(entry.name, &parameter, goes_on);
    }
}

/// Names that a parameter may have.
std::vector<std::string> names_of(const commands::Scene& scene, EffectParameterKind kind) {
    std::vector<std::string> names;
    if (kind == EffectParameterKind::trial)
        for (const commands::SceneTrial& trial : scene.trials) names.push_back(trial.name);
    else if (kind == EffectParameterKind::actuator)
        names = scene.effects.actuators;
    else
        for (const commands::SceneMarker& marker : scene.markers) names.push_back(marker.name);
    return names;
}

/// A list of names; `none` is the label of the entry without one, empty if there is no such entry.
bool name_row(PanelContext& context, const std::string& label, const std::string& item,
              const std::vector<std::string>& names, const std::string& none, std::string& chosen) {
    std::vector<commands::Choice> choices;
    if (!none.empty()) choices.push_back({"", none, ""});
    for (const std::string& name : names) choices.push_back({name, name, ""});
    const std::string before = chosen;
    return choice_row(context, label, item, "", choices, chosen) && chosen != before;
}

/// Row of a parameter that is the name of a marker, trial or actuator. The empty choice leaves out an optional one.
void draw_name(PanelContext& context, const EditedEffect& edited, const EffectParameterEntry& entry) {
    const auto given = edited.effect.parameters.find(entry.name);
    std::string chosen = given != edited.effect.parameters.end() ? std::get<std::string>(given->second) : "";
    const std::string none = !entry.optional ? "" : entry.kind == EffectParameterKind::trial ? "All trials" : "All";
    if (!name_row(context, effect::effect_name(entry.name), edited.item + "/" + entry.name,
                  names_of(*context.state.scene, entry.kind), none, chosen))
        return;
    const EffectParameter value = chosen;
    edited.change(entry.name, chosen.empty() ? nullptr : &value, false);
}

/// Rows of a parameter that names two markers.
void draw_pair(PanelContext& context, const EditedEffect& edited, const EffectParameterEntry& entry,
               const std::vector<std::string>& pair) {
    for (std::size_t k = 0; k < pair.size(); ++k) {
        std::vector<std::string> changed = pair;
        if (!name_row(context, "Marker " + std::to_string(k + 1),
                      edited.item + "/" + entry.name + "/" + std::to_string(k),
                      names_of(*context.state.scene, entry.kind), "", changed[k]))
            continue;
        const EffectParameter value = changed;
        edited.change(entry.name, &value, false);
    }
}

/// Row of a parameter that is a coordinate axis: 0, 1 or 2.
void draw_axis(PanelContext& context, const EditedEffect& edited, const EffectParameterEntry& entry, double axis) {
    std::vector<commands::Choice> choices;
    for (std::size_t k = 0; k < axis_names.size(); ++k) choices.push_back({std::to_string(k), axis_names[k], ""});
    std::string chosen = std::to_string(static_cast<int>(axis));
    const std::string before = chosen;
    if (!choice_row(context, "Axis", edited.item + "/" + entry.name, "Coordinate axis of the mesh frame.", choices,
                    chosen) ||
        chosen == before)
        return;
    const EffectParameter value = static_cast<double>(chosen[0] - '0');
    edited.change(entry.name, &value, false);
}

/// Whether the value of a parameter is a single name.
bool is_name(EffectParameterKind kind) {
    return kind == EffectParameterKind::marker || kind == EffectParameterKind::trial ||
           kind == EffectParameterKind::actuator;
}

/// A box to tick for a parameter that may be left out. Returns whether its rows are drawn.
bool draw_given(PanelContext& context, const EditedEffect& edited, const EffectParameterEntry& entry) {
    bool given = edited.effect.parameters.contains(entry.name);
    const bool before = given;
    row_label(context.theme, effect::effect_name(effect::readable_quantity(entry.name).name),
              "May be left out; the manual says what holds then.");
    ImGui::BeginDisabled(!edited.start);
    ImGui::Checkbox(("given##" + entry.name).c_str(), &given);
    ImGui::EndDisabled();
    context.items.mark(edited.item + "/" + entry.name + "/given");
    if (given != before && given) edited.change(entry.name, &edited.start->parameters.at(entry.name), false);
    if (given != before && !given) edited.change(entry.name, nullptr, false);
    // A parameter that was just given has its rows from the next frame on, when the state has its value.
    return given && before;
}

/// Rows of one parameter. Its kind decides about names and axes, the type of its value about the rest.
void draw_parameter(PanelContext& context, const EditedEffect& edited, const EffectParameterEntry& entry,
                    NumberEdits& edits) {
    // Names have an entry for "none" in their list; other optional parameters have a box to tick.
    if (is_name(entry.kind)) return draw_name(context, edited, entry);
    if (entry.optional && !draw_given(context, edited, entry)) return;
    const auto given = edited.effect.parameters.find(entry.name);
    if (given == edited.effect.parameters.end()) return;
    const EffectParameter& value = given->second;
    if (const auto* const pair = std::get_if<std::vector<std::string>>(&value))
        return draw_pair(context, edited, entry, *pair);
    if (const auto* const vector = std::get_if<Eigen::VectorXd>(&value))
        return vector_of_effect(context, edited, entry, *vector, edits);
    const auto* const number = std::get_if<double>(&value);
    if (!number) return;
    if (entry.kind == EffectParameterKind::axis) return draw_axis(context, edited, entry, *number);
    double changed = *number;
    bool goes_on = false;
    if (!number_of_effect(context, shown_number(entry, edited.item, ""), edits, changed, goes_on)) return;
    const EffectParameter parameter = changed;
    edited.change(entry.name, &parameter, goes_on);
}

}  // namespace

void effect_rows(PanelContext& context, const EditedEffect& edited, NumberEdits& edits) {
    const effect::Effect* const entry = effect::find_effect(edited.start ? *edited.start : edited.effect);
    if (!entry) return muted_text(context.theme, "This version does not know the effect.");
    for (const EffectParameterEntry& parameter : entry->parameters) draw_parameter(context, edited, parameter, edits);
}

}  // namespace myo::ui::panels
