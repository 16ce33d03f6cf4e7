#include "panels/unknown_bounds.hpp"

#include <imgui.h>

#include <cmath>

#include "panels/declared_list.hpp"
#include "plot/number_text.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Ids of the ways in which bounds are given.
const char* const usual_id = "usual";
const char* const bounds_id = "bounds";
const char* const tolerance_id = "tolerance";

/// Values of what is newly declared, for the user to change.
struct NewBoundsPolicy {
    double half_width = 0.5;  // over the value, where there is no usual bound; and of a tolerance
    double largest = 1e15;    // largest number of a field, SI
};
constexpr NewBoundsPolicy new_bounds_policy;

/// Way that the experiment declares for a value.
const char* id_of(const commands::SceneUnknown& unknown) {
    if (unknown.declared_tolerance) return tolerance_id;
    return unknown.declared_lowest || unknown.declared_highest ? bounds_id : usual_id;
}

/// Unit in which values are shown.
std::string shown_unit(const std::string& si) { return si == "Pa" ? "kPa" : si == "m" ? "mm" : si; }

/// SI value of the shown unit; 1 for a value without a unit, or with one that no field knows.
double si_per_shown(const std::string& si) {
    const commands::Unit* const unit = commands::find_unit(commands::dimension_of_unit(si), shown_unit(si));
    return unit ? unit->si() : 1.0;
}

/// Field of a bound or tolerance, in the unit of its value.
NumberField field_of(const commands::SceneUnknown& unknown, const std::string& label, const std::string& name,
                     const char* tip) {
    // A modulus is positive; nothing else is known about a bound.
    const double lowest = unknown.name.ends_with("youngs_modulus_Pa") ? 1e-3 : -new_bounds_policy.largest;
    const double size = std::max(std::abs(unknown.value), 1e-6) / si_per_shown(unknown.unit);
    NumberField field;
    field.label = label;
    field.name = name;
    field.dimension = commands::dimension_of_unit(unknown.unit);
    field.unit = shown_unit(unknown.unit);
    field.tip = tip;
    field.limits = {lowest, new_bounds_policy.largest};
    field.smallest_step = 0.005 * size;
    return field;
}

/// TOML lines of new bounds or of a tolerance. Bounds begin with those that hold now, where they are finite.
std::string keys_text(const std::string& kind, const commands::SceneUnknown& unknown) {
    // Around a value of zero a share of it would be no range.
    const double half = new_bounds_policy.half_width * (unknown.value != 0.0 ? std::abs(unknown.value) : 1.0);
    if (kind == tolerance_id) return "tolerance = " + toml::toml_number(half) + "\n";
    const double lowest = std::isfinite(unknown.lowest) ? unknown.lowest : unknown.value - half,
                 highest = std::isfinite(unknown.highest) ? unknown.highest : unknown.value + half;
    return "lowest = " + toml::toml_number(lowest) + "\nhighest = " + toml::toml_number(highest) + "\n";
}

/// Declares bounds or a tolerance instead of what was declared. One edit.
void set_kind(PanelContext& context, const std::string& kind, const commands::SceneUnknown& unknown,
              const std::string& item) {
    std::vector<commands::DeclarationEdit> edits;
    // What is declared of a value is one table, which is replaced as a whole.
    if (unknown.declared >= 0)
        edits.push_back(commands::RemoveDeclared{{"unknown", static_cast<std::size_t>(unknown.declared)}});
    if (kind != usual_id)
        edits.push_back(commands::AppendDeclared{
            {"unknown"}, "name = " + toml::toml_text(unknown.name) + "\n" + keys_text(kind, unknown)});
    context.emit(commands::EditDeclaration{std::move(edits), item + "/kind"});
}

/// Row of one number of a declared unknown. `key`: in its table.
void number(PanelContext& context, const commands::SceneUnknown& unknown, const NumberField& field, const char* key,
            double value, NumberEdits& edits) {
    bool goes_on = false;
    if (number_row(context, field, edits, value, goes_on, unknown.name))
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{{"unknown", static_cast<std::size_t>(unknown.declared), key},
                                   toml::toml_number(value)}},
            field.name,
            goes_on});
}

/// Bounds of a value as a button; while it is open, how they are given.
void draw_unknown(PanelContext& context, const commands::SceneUnknown& unknown, NumberEdits& edits) {
    const std::string item = "unknown/bounds/" + unknown.name;
    const double per_unit = si_per_shown(unknown.unit);
    const std::string unit = shown_unit(unknown.unit);
    const std::string words = plot::plain_label(unknown.lowest / per_unit, 3) + " to " +
                              plot::plain_label(unknown.highest / per_unit, 3) + (unit.empty() ? "" : " " + unit);
    // Closed, a value takes one line with the bounds that hold, declared or not.
    row_label(context.theme, unknown.label);
    if (ImGui::Button((words + "##" + item).c_str(), {-1.0f, 0.0f}))
        open_item(context, is_open(context, item) ? "" : item);
    context.items.mark(item);
    tooltip(context.theme, "Within which values a fit searches. A click shows how they are given.");
    if (!is_open(context, item)) return;
    const std::vector<commands::Choice> choices{
        {usual_id, "As usual",
         "The bounds that the program takes: a tolerance of the modulus, else what has a meaning."},
        {bounds_id, "From ... to", "A lowest and a highest value."},
        {tolerance_id, "Tolerance", "At most this far from the value at which the fit starts."}};
    std::string chosen = id_of(unknown);
    const std::string before = chosen;
    if (choice_row(context, "Bounds", item + "/kind", "Within which values a fit searches.", choices, chosen) &&
        chosen != before)
        set_kind(context, chosen, unknown, item);
    // One of the two bounds may be declared alone: the other field then shows what holds without it.
    if (before == bounds_id) {
        number(context, unknown, field_of(unknown, "Lowest", item + "/lowest", "Smallest value of a fit."), "lowest",
               unknown.declared_lowest.value_or(unknown.lowest), edits);
        number(context, unknown, field_of(unknown, "Highest", item + "/highest", "Largest value of a fit."), "highest",
               unknown.declared_highest.value_or(unknown.highest), edits);
    }
    if (before != tolerance_id) return;
    NumberField field = field_of(unknown, "Tolerance", item + "/tolerance", "Largest distance from the start value.");
    // A tolerance of zero would leave nothing to fit.
    field.limits.lowest = 1e-12;
    number(context, unknown, field, "tolerance", *unknown.declared_tolerance, edits);
}

}  // namespace

void draw_bounds(PanelContext& context, NumberEdits& edits) {
    const commands::SceneUnknowns& fitted = context.state.scene->fitted;
    if (fitted.empty()) return;
    heading(context.theme, "Found by a fit");
    for (const commands::SceneUnknown& unknown : fitted) draw_unknown(context, unknown, edits);
}

}  // namespace myo::ui::panels
