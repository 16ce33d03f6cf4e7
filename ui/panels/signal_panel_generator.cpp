#include <imgui.h>

#include "panels/signal_panel.hpp"
#include "panels/tables.hpp"

namespace myo::ui::panels {
namespace {

/// Shapes of a recipe, in the order of commands::SignalShape.
const std::vector<commands::Choice>& shape_choices() {
    static const std::vector<commands::Choice> choices{
        {"constant", "Constant", "The same value at all times."},
        {"step", "Step", "Passive, then the level, within a millisecond."},
        {"ramp", "Ramp", "Passive, then linearly to the level, which is held."},
        {"sine", "Sine", "Oscillates between passive and the level."}};
    return choices;
}

/// The level of the recipe, which every shape has.
NumberField level_field() {
    return {"Level a",
            "signals/level",
            commands::Dimension::ratio,
            "",
            "Target stretch a, dimensionless: target length of the fibres over their length at rest, in the "
            "energy per rest volume w/2 (|F m| − a)². 1 is passive.",
            {0.05, 5.0},
            0.005};
}

/// Number of the recipe. No part of undo, so it does not matter whether a drag continues.
void recipe_row(PanelContext& context, const NumberField& field, NumberEdits& edit, double& value) {
    bool ignored = false;
    number_row(context, field, edit, value, ignored);
}

/// A sine with many thousand knots could not be edited.
bool can_be_generated(const commands::SignalRecipe& recipe) {
    return recipe.shape != commands::SignalShape::sine ||
           (recipe.end_s > recipe.start_s && (recipe.end_s - recipe.start_s) * recipe.frequency_Hz <= 200.0);
}

}  // namespace

void SignalPanel::draw_recipe(PanelContext& context) {
    recipe_row(context, level_field(), edit_, recipe_.level);
    // A constant has no start; a ramp also has a rise, a sine a frequency and an end.
    if (recipe_.shape != commands::SignalShape::constant)
        recipe_row(context,
                   {"Start",
                    "signals/start",
                    commands::Dimension::time,
                    "s",
                    "Time t₀ [s] up to which the muscle is passive, a = 1.",
                    {-1e3, 1e3},
                    0.01},
                   edit_, recipe_.start_s);
    if (recipe_.shape == commands::SignalShape::ramp)
        recipe_row(context,
                   {"Rise",
                    "signals/rise",
                    commands::Dimension::time,
                    "s",
                    "Time [s] from passive to the level: a = 1 + (level − 1) (t − t₀) / rise.",
                    {1e-3, 1e3},
                    0.01},
                   edit_, recipe_.rise_s);
    if (recipe_.shape == commands::SignalShape::sine) draw_sine(context);
}

void SignalPanel::draw_sine(PanelContext& context) {
    recipe_row(context,
               {"Frequency",
                "signals/frequency",
                commands::Dimension::frequency,
                "Hz",
                "Oscillations per second f [Hz]: a = 1 + (level − 1) (1 − cos 2π f (t − t₀)) / 2.",
                {0.01, 100.0},
                0.01},
               edit_, recipe_.frequency_Hz);
    recipe_row(context,
               {"End",
                "signals/end",
                commands::Dimension::time,
                "s",
                "Time [s] at which it stops; a is held from there on.",
                {-1e3, 1e3},
                0.01},
               edit_, recipe_.end_s);
}

/// The popup keeps its recipe, so that several muscles can get the same signal.
void SignalPanel::draw_generator(PanelContext& context) {
    const commands::Muscle& muscle = *context.state.chosen_muscle();
    if (ImGui::Button("Generate")) ImGui::OpenPopup("generate");
    context.items.mark("signals/generate");
    tooltip(context.theme, "A constant, a step, a ramp or a sine");
    if (!begin_popup_above(context.theme, "generate", 320.0f)) return;
    // The level of a new recipe fits the action of the muscle: below 1 for one that contracts.
    if (recipe_muscle_ != muscle.name || (recipe_.level > 1.0) != muscle.extends) {
        recipe_muscle_ = muscle.name;
        recipe_.level = muscle.extends ? 1.2 : 0.8;
    }
    std::string shape = shape_choices()[static_cast<std::size_t>(recipe_.shape)].id;
    if (choice_row(context, "Shape", "signals/shape", "Shape of the signal.", shape_choices(), shape))
        for (std::size_t i = 0; i < shape_choices().size(); ++i)
            if (shape_choices()[i].id == shape) recipe_.shape = static_cast<commands::SignalShape>(i);
    draw_recipe(context);
    const bool fits = can_be_generated(recipe_);
    // The button is disabled, too; the notice says why.
    notice_in_place(context.theme, commands::LogLevel::warning,
                    fits ? "" : "The end must lie after the start, by at most 200 periods.", 2);
    ImGui::BeginDisabled(!fits);
    if (primary_button(context.theme, "Apply", {-1.0f, 0.0f})) {
        give_signal(context, commands::make_signal(recipe_), "generated signal", false);
        plot_ = {};
        ImGui::CloseCurrentPopup();
    }
    context.items.mark("signals/use");
    ImGui::EndDisabled();
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
