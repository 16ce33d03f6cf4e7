#include "panels/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "panels/drag_or_type.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"

namespace myo::ui::panels {
namespace {

/// What a typed text of the field may be: unit, limits, and the name for error messages.
commands::QuantityRange range_of(const NumberField& field) {
    return {field.dimension, field.unit, field.quantity.empty() ? field.label : field.quantity, field.limits,
            field.whole_number};
}

/// Explanation of the field, and how it is edited.
std::string field_tip(const NumberField& field) {
    const std::string units = commands::offered_units(field.dimension);
    std::string typing = "\n\nDrag, or double-click to type a number";
    if (!field.unit.empty()) typing += " in " + field.unit;
    if (!units.empty() && units != field.unit) typing += ", or one with its unit: " + units;
    return field.tip + typing + ".";
}

/// Writes a sentence next to the last item: right of its window, where no other row is; below the item if there is no
/// room. Nothing moves.
void explain_beside(PanelContext& context, const std::string& name, const std::string& sentence) {
    const platform::Theme& theme = context.theme;
    const ImVec2 lowest = ImGui::GetItemRectMin(), highest = ImGui::GetItemRectMax();
    const float gap = 8.0f * theme.scale, width = 300.0f * theme.scale;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowSize().x + gap;
    const bool fits = right + width + gap <= ImGui::GetIO().DisplaySize.x;
    const float below = std::max(0.0f, std::min(lowest.x, ImGui::GetIO().DisplaySize.x - width - gap));
    ImGui::SetNextWindowPos(fits ? ImVec2(right, lowest.y) : ImVec2(below, highest.y + 2.0f * theme.scale));
    ImGui::PushStyleColor(ImGuiCol_Border, theme.failure);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImGui::GetStyle().FramePadding);
    // In the layer of tooltips, in front of dialogs, without taking the mouse or the keyboard.
    ImGui::Begin(("##refused " + name).c_str(), nullptr,
                 ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoTitleBar |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushStyleColor(ImGuiCol_Text, theme.failure);
    wrapped_text(sentence, width - ImGui::GetStyle().WindowPadding.x);
    ImGui::PopStyleColor();
    context.items.mark(name + ": " + sentence);
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

/// Tries the typed text. Returns true if the value changed.
///
/// @param stays  a refused text keeps the keyboard, to be corrected at once
bool try_text(const NumberField& field, NumberEdits& edits, NumberEdits::Typed& typed, bool stays, double& value) {
    const Result<double> tried = commands::accept_quantity(typed.text.data(), range_of(field));
    // The text that the field began with stands for its value, whatever the value is.
    const bool unchanged = typed.opened == typed.text.data();
    if (!tried && !unchanged) {
        typed.refused = true;
        typed.again = stays;
        edits.explained = field.name;
        return false;
    }
    const bool changed = tried && !unchanged && *tried != value;
    if (changed) value = *tried;
    edits.drop(field.name);
    return changed;
}

/// The field while text is in it. Returns true if the value changed.
bool draw_typed(PanelContext& context, const NumberField& field, NumberEdits& edits, NumberEdits::Typed& typed,
                double& value) {
    // A refused text is red until it would be accepted.
    const Result<double> now = typed.refused ? commands::accept_quantity(typed.text.data(), range_of(field))
                                             : Result<double>(value);
    const DragOrType done = type_number(("##" + field.name).c_str(), context.theme, typed.text, typed.active,
                                        typed.again, !now);
    context.items.mark(field.name);
    const bool visible = ImGui::IsItemVisible(), hovered = ImGui::IsItemHovered();
    // Requested once; from here on ImGui knows who has the keyboard.
    typed.again = false;
    typed.active = done == DragOrType::typing;
    // Several sentences at once would cover each other: the field that the user looks at comes first.
    if (!now && (typed.active || hovered)) edits.explained = field.name;
    if (!now && visible && edits.explained == field.name) explain_beside(context, field.name, now.error().what);
    if (done == DragOrType::cancelled) edits.drop(field.name);
    if (done != DragOrType::entered && done != DragOrType::left) return false;
    return try_text(field, edits, typed, done == DragOrType::entered, value);
}

/// The field while its value is shown. Returns true if it was dragged.
bool draw_dragged(PanelContext& context, const NumberField& field, NumberEdits& edits, double& value, bool& goes_on,
                  const std::string& subject) {
    const commands::Unit* unit = commands::find_unit(field.dimension, field.unit);
    assert(unit != nullptr);
    const double per_unit = unit->si();
    double shown = value / per_unit;
    // 0.4 % of the value per pixel: the same relative speed for all magnitudes.
    const float speed = static_cast<float>(std::max(0.004 * std::abs(shown), field.smallest_step));
    const DragOrType done = drag_number(("##" + field.name).c_str(),
                                        {shown, field.limits.lowest / per_unit, field.limits.highest / per_unit, speed,
                                         commands::displayed_text(value, field.dimension, field.unit)});
    context.items.mark(field.name);
    const bool changed = done == DragOrType::dragged && std::isfinite(shown);
    // Right after the item, whose activation it queries.
    goes_on = edits.drag.goes_on(field.name, changed);
    // Not while the field is dragged: the tooltip would cover it.
    if (!ImGui::IsItemActive()) tooltip(context.theme, field_tip(field));
    if (done == DragOrType::opened && std::isfinite(value))
        edits.open(field.name, commands::edited_text(value, field.dimension, field.unit), value, subject);
    if (changed) {
        const double whole = field.whole_number ? std::round(shown) : shown;
        value = std::clamp(whole * per_unit, field.limits.lowest, field.limits.highest);
    }
    return changed;
}

}  // namespace

NumberEdits::Typed* NumberEdits::find(const std::string& name, double value, const std::string& subject) {
    const auto found = typed_.find(name);
    if (found == typed_.end()) return nullptr;
    // A text that is being typed is kept whatever the value does: a job may change it meanwhile.
    if (found->second.subject == subject && (found->second.value == value || found->second.active))
        return &found->second;
    typed_.erase(found);
    return nullptr;
}

NumberEdits::Typed& NumberEdits::open(const std::string& name, const std::string& text, double value,
                                      const std::string& subject) {
    Typed& typed = typed_[name];
    typed = {.opened = text, .again = true, .value = value, .subject = subject};
    // Fields open with a number and its unit, far shorter than the buffer.
    assert(text.size() < typed.text.size());
    std::memcpy(typed.text.data(), text.c_str(), text.size() + 1);
    return typed;
}

bool number_field(PanelContext& context, const NumberField& field, NumberEdits& edits, double& value, bool& goes_on,
                  const std::string& subject) {
    // Another scene has other values, even if they are equal.
    const std::string owner = (context.state.scene ? context.state.scene->path.string() : "") + "\n" + subject;
    NumberEdits::Typed* typed = edits.find(field.name, value, owner);
    if (typed == nullptr) return draw_dragged(context, field, edits, value, goes_on, owner);
    goes_on = false;
    // Typing ends a drag: the next one is an edit of its own.
    edits.drag.close();
    return draw_typed(context, field, edits, *typed, value);
}

bool number_row(PanelContext& context, const NumberField& field, NumberEdits& edits, double& value, bool& goes_on,
                const std::string& subject) {
    explained_label(context, field.label, field.name, field.tip);
    return number_field(context, field, edits, value, goes_on, subject);
}

}  // namespace myo::ui::panels
