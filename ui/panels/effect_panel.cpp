#include "panels/effect_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/letter_case.hpp"
#include "commands/effect_words.hpp"
#include "effect/catalogue.hpp"
#include "effect/readable_quantity.hpp"
#include "panels/declared_list.hpp"
#include "panels/effect_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

constexpr float catalogue_height = 320.0f;  // [pixels at scale 1]

/// Item name of an effect: "effect/declared/0". `list`: "declared" or "added".
std::string item_of(const char* list, std::size_t index) {
    return std::string("effect/") + list + "/" + std::to_string(index);
}

/// Start values of an effect; null if the scene does not offer it.
const effect::EffectDeclaration* start_of(const commands::Scene& scene, const std::string& id) {
    for (const effect::EffectDeclaration& offered : scene.effects.offered)
        if (offered.id == id) return &offered;
    return nullptr;
}

/// Entry of an effect among those that the scene offers, laws of the experiment included; null if there is none.
const effect::Effect* entry_of(const commands::Scene& scene, const std::string& id) {
    const effect::EffectDeclaration* const offered = start_of(scene, id);
    return offered ? effect::find_effect(*offered) : effect::find_effect(id);
}

/// Summary of an entry as a sentence; empty for an effect that this version does not know.
std::string summary_of(const effect::Effect* entry) {
    if (!entry) return {};
    std::string sentence = entry->summary;
    if (!sentence.empty()) sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    return sentence + ".";
}

/// Whether a fit can move at least one parameter, that is one with a scale.
bool can_be_fitted(const effect::Effect* entry) {
    return entry && std::any_of(entry->parameters.begin(), entry->parameters.end(),
                                [](const effect::EffectParameterEntry& p) { return p.scale > 0.0; });
}

/// Heading with a switch. Returns whether the effect was switched, and in `removed` whether it was removed.
bool effect_heading(PanelContext& context, const std::string& item, const std::string& id, bool is_on, bool& removed) {
    // The switch stands between the title and the button that removes the effect.
    const float box = ImGui::GetFrameHeight(), spacing = ImGui::GetStyle().ItemSpacing.x;
    const ItemPress press = item_heading(context,
                                         {item, effect::effect_name(id) + (is_on ? "" : " (off)"),
                                          summary_of(entry_of(*context.state.scene, id)), "Remove the effect", !is_on},
                                         box + spacing);
    removed = press == ItemPress::removed;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 2.0f * box - spacing);
    bool on = is_on;
    ImGui::Checkbox(("##on" + item).c_str(), &on);
    context.items.mark(item + "/on");
    tooltip(context.theme, is_on ? "Runs, fits and diagnoses have the effect. Switch it off to leave it out and keep "
                                   "its values."
                                 : "Switched off: runs, fits and diagnoses leave the effect out.");
    return on != is_on;
}

/// Whether a fit moves the values. Returns true if that changed.
bool fit_row(PanelContext& context, const std::string& item, const std::string& id, bool& fitted) {
    if (!can_be_fitted(entry_of(*context.state.scene, id))) return false;
    row_label(context.theme, "Values");
    const bool changed = ImGui::Checkbox(("found by a fit##" + item).c_str(), &fitted);
    context.items.mark(item + "/fit");
    tooltip(context.theme,
            "A calibration finds the numbers and vectors of the effect within their ranges. Names, axes and times of "
            "events stay.");
    return changed;
}

}  // namespace

void EffectPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const std::size_t declared = state.scene->effects.declared.size(), added = state.settings.effects.size();
    if (declared + added == 0)
        muted_text(
            context.theme,
            "The model has no effects besides material, support and loads. Diagnose finds which one is missing.");
    // First the effects that the experiment declares, then those that only the project has.
    for (std::size_t i = 0; i < declared; ++i) draw_declared(context, i);
    if (added > 0 && state.scene->is_experiment) heading(context.theme, "Added to the experiment");
    for (std::size_t i = 0; i < added; ++i) draw_added(context, i);
    draw_catalogue(context);
}

void EffectPanel::draw_declared(PanelContext& context, std::size_t index) {
    const commands::WorkbenchState& state = context.state;
    const effect::EffectDeclaration& effect = state.scene->effects.declared[index];
    const std::string item = item_of("declared", index);
    const bool on = !commands::is_off(state.settings.off, state.scene->effects.declared, index);
    bool removed = false;
    // The switch changes the settings and not the declaration, which keeps the effect with its values.
    if (effect_heading(context, item, effect.id, on, removed)) {
        commands::Settings settings = state.settings;
        settings.off = commands::switched(std::move(settings.off), {index, effect.id}, !on);
        context.emit(commands::ChangeSettings{settings, item + "/on"});
    }
    if (removed)
        context.emit(commands::EditDeclaration{{commands::RemoveDeclared{{"effect", index}}}, item + "/remove"});
    if (!is_open(context, item)) return;
    effect_rows(context,
                {effect, start_of(*state.scene, effect.id), item,
                 [&](const std::string& key, const effect::EffectParameter* value, bool goes_on) {
                     const toml::TomlPath path{"effect", index, key};
                     // A parameter that is no longer given loses its key.
                     commands::DeclarationEdit edit = commands::RemoveDeclared{path};
                     if (value) edit = commands::SetDeclared{path, commands::declared_text(*value)};
                     context.emit(commands::EditDeclaration{{std::move(edit)}, item + "/" + key, goes_on});
                 }},
                edits_);
    bool fitted = effect.calibrate;
    if (fit_row(context, item, effect.id, fitted))
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{{"effect", index, "calibrate"}, fitted ? "true" : "false"}}, item + "/fit"});
}

void EffectPanel::draw_added(PanelContext& context, std::size_t index) {
    const commands::WorkbenchState& state = context.state;
    const commands::AddedEffect& effect = state.settings.effects[index];
    const std::string item = item_of("added", index);
    // A copy of the settings per edit: it differs from the state in this effect only.
    const auto emit = [&](const std::string& what, bool goes_on, const auto& change) {
        commands::Settings settings = state.settings;
        change(settings);
        context.emit(commands::ChangeSettings{std::move(settings), what, goes_on});
    };
    bool removed = false;
    if (effect_heading(context, item, effect.declaration.id, !effect.off, removed))
        // While it is off, the effect keeps its values, but runs, fits and diagnoses leave it out.
        emit(item + "/on", false, [&](commands::Settings& s) { s.effects[index].off = !effect.off; });
    if (removed)
        emit("effects", false,
             [&](commands::Settings& s) { s.effects.erase(s.effects.begin() + static_cast<std::ptrdiff_t>(index)); });
    if (!is_open(context, item)) return;
    effect_rows(context,
                {effect.declaration, start_of(*state.scene, effect.declaration.id), item,
                 [&](const std::string& key, const effect::EffectParameter* value, bool goes_on) {
                     emit(item + "/" + key, goes_on, [&](commands::Settings& s) {
                         commands::AddedEffect& changed = s.effects[index];
                         if (value)
                             changed.declaration.parameters[key] = *value;
                         else
                             changed.declaration.parameters.erase(key);
                         // The text of the values is kept with them, as the project and the table of jobs show it.
                         changed.value = commands::effect_words(changed.declaration.parameters);
                     });
                 }},
                edits_);
    // On a plain mesh there is no declaration to move the effect into, and no recording to fit it to.
    if (state.scene->is_experiment) {
        if (ImGui::Button(("Put into the experiment##" + item).c_str(), {-1.0f, 0.0f}))
            context.emit(commands::DeclareEffect{index});
        context.items.mark(item + "/declare");
        tooltip(
            context.theme,
            "Declares the effect in the experiment, so that its file has it once it is saved; until then it is part "
            "of the project only.");
    }
    bool fitted = effect.declaration.calibrate;
    if (state.scene->is_experiment && fit_row(context, item, effect.declaration.id, fitted))
        emit(item + "/fit", false, [&](commands::Settings& s) { s.effects[index].declaration.calibrate = fitted; });
}

namespace {

/// Adds an effect with its start values: to the declaration, or on a plain mesh to the settings.
void add_effect(PanelContext& context, const effect::EffectDeclaration& start) {
    const commands::WorkbenchState& state = context.state;
    if (state.scene->is_experiment) {
        context.emit(commands::EditDeclaration{{commands::AppendDeclared{{"effect"}, commands::new_effect_text(start)}},
                                               "effect/add"});
        // The new entry will be the last of the list.
        return open_item(context, item_of("declared", state.scene->effects.declared.size()));
    }
    commands::AddedEffect added;
    added.declaration.id = start.id;
    // Optional parameters are left out until the user gives them.
    for (const effect::EffectParameterEntry& parameter : effect::find_effect(start)->parameters)
        if (!parameter.optional) added.declaration.parameters[parameter.name] = start.parameters.at(parameter.name);
    added.name = effect::effect_name(start.id);
    added.value = commands::effect_words(added.declaration.parameters);
    commands::Settings settings = state.settings;
    settings.effects.push_back(std::move(added));
    open_item(context, item_of("added", settings.effects.size() - 1));
    context.emit(commands::ChangeSettings{std::move(settings), "effect/add"});
}

/// Whether name, summary and group of an entry contain the typed text.
bool is_wanted(const effect::Effect& entry, const std::string& wanted) {
    const std::string words = lower_case(effect::effect_name(entry.id) + " " + entry.summary + " " +
                                         to_string(entry.kind));
    return words.find(lower_case(wanted)) != std::string::npos;
}

/// One entry of the catalogue. Returns true if it was chosen.
bool draw_entry(PanelContext& context, const effect::Effect& entry, const std::string& lacking) {
    ImGui::BeginDisabled(!lacking.empty());
    const bool chosen = ImGui::Selectable(effect::effect_name(entry.id).c_str());
    ImGui::EndDisabled();
    context.items.mark("effect/add/" + entry.id);
    tooltip(context.theme, summary_of(&entry) + (lacking.empty() ? "" : "\n\nNeeds " + lacking + "."));
    muted_text(context.theme, lacking.empty() ? entry.summary : "needs " + lacking);
    return chosen;
}

}  // namespace

void EffectPanel::draw_catalogue(PanelContext& context) {
    const commands::SceneEffects& effects = context.state.scene->effects;
    if (effects.offered.empty()) return;
    if (ImGui::Button(adding_ ? "Close the catalogue" : "Add an effect\xe2\x80\xa6", {-1.0f, 0.0f})) adding_ = !adding_;
    context.items.mark("effect/add");
    if (!adding_) return;
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##find_effect", "Find", &wanted_);
    context.items.mark("effect/find");
    ImGui::BeginChild("effect catalogue", {0.0f, catalogue_height * context.theme.scale}, true);
    std::string group;
    for (std::size_t i = 0; i < effects.offered.size(); ++i) {
        const effect::Effect* const entry = effect::find_effect(effects.offered[i]);
        if (!entry || !is_wanted(*entry, wanted_)) continue;
        // An entry of another kind than the one before begins a group.
        if (const std::string kind = to_string(entry->kind); kind != group)
            heading(context.theme, effect::effect_name(group = kind));
        if (!draw_entry(context, *entry, i < effects.lacking.size() ? effects.lacking[i] : "")) continue;
        add_effect(context, effects.offered[i]);
        adding_ = false;
    }
    if (group.empty()) muted_text(context.theme, "No effect of the catalogue has these words.");
    ImGui::EndChild();
}

}  // namespace myo::ui::panels
