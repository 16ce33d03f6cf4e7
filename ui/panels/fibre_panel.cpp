#include "panels/fibre_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fibre/direction_field.hpp"
#include "panels/actuator_rows.hpp"
#include "panels/brush_rows.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

// Names are unique, because they are columns in signal files and refer to other muscles.
bool is_taken(const commands::Settings& settings, const std::string& name) {
    return std::any_of(settings.muscles.begin(), settings.muscles.end(),
                       [&](const commands::Muscle& muscle) { return muscle.name == name; });
}

/// Amount of paint: number of elements and volume.
std::string amount_label(const fibre::PaintedAmount& amount) {
    return with_separators(amount.cells) + (amount.cells == 1 ? " element, " : " elements, ") +
           plot::value_label(1e6 * amount.volume_m3, 3) + " cm\xc2\xb3";
}

/// Edits the selected muscle and emits the changed settings.
void change(PanelContext& context, const std::string& what, bool goes_on,
            const std::function<void(commands::Muscle&)>& edit) {
    commands::Settings settings = context.state.settings;
    edit(settings.muscles[static_cast<std::size_t>(context.state.muscle)]);
    context.emit(commands::ChangeSettings{std::move(settings), what, goes_on});
}

/// Ids for tests and settings, labels and explanations for the user.
const std::vector<commands::Choice>& action_choices() {
    static const std::vector<commands::Choice> choices{
        {"contracts", "Contracts", "Its fibres shorten when active: a < 1."},
        {"extends", "Extends", "Its fibres lengthen when active, as a chamber under pressure does: a > 1."}};
    return choices;
}

/// Colour, name and painted volume of a muscle.
void draw_muscle_row(PanelContext& context, int m) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const commands::Muscle& muscle = state.settings.muscles[static_cast<std::size_t>(m)];
    ImGui::PushID(m);
    // A square in the muscle's colour before the name; the name is indented by spaces to leave room for it.
    const float box = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable(("        " + muscle.name).c_str(), m == state.muscle))
        context.emit(commands::ChooseMuscle{m});
    context.items.mark("fibres/muscle/" + muscle.name);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + 2.0f * theme.scale, at.y + 1.0f},
                                              {at.x + 2.0f * theme.scale + box, at.y + 1.0f + box - 2.0f},
                                              platform::packed(theme.muscle(muscle.color)), 3.0f * theme.scale);
    // During a stroke the amount follows the paint under the brush.
    if (static_cast<std::size_t>(m) < state.paint.size() && state.ground) {
        const fibre::CellPaint& paint = m == state.muscle && context.live_paint
                                            ? *context.live_paint
                                            : *state.paint[static_cast<std::size_t>(m)];
        const fibre::PaintedAmount amount = fibre::amount_of(paint, state.ground->volumes_m3);
        const std::string text = amount.cells > 0 ? plot::value_label(1e6 * amount.volume_m3, 3) + " cm\xc2\xb3"
                                                  : "not painted";
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
        ImGui::TextColored(theme.muted, "%s", text.c_str());
    }
    ImGui::PopID();
}

/// Ratio of the selected muscle to the one that it follows.
void draw_ratio(PanelContext& context, NumberEdits& edit) {
    // NumberField: label, item name, dimension, unit, tooltip, limits, smallest change while dragging.
    double ratio = context.state.chosen_muscle()->ratio;
    bool goes_on = false;
    const NumberField field{"Ratio",
                            "fibres/ratio",
                            commands::Dimension::ratio,
                            "",
                            "Factor from a \xe2\x88\x92 1 of the other muscle to that of this one: \xe2\x88\x92"
                            "1 lengthens as much as the other shortens.",
                            commands::muscle_ratio_limits,
                            0.01,
                            "ratio"};
    if (number_row(context, field, edit, ratio, goes_on, context.state.chosen_muscle()->name))
        change(context, "ratio of antagonists", goes_on, [&](commands::Muscle& m) { m.ratio = ratio; });
}

/// Swatches of the colours that the muscle can have.
void draw_colors(PanelContext& context, const commands::Muscle& muscle) {
    const platform::Theme& theme = context.theme;
    row_label(theme, "Colour");
    // Eight swatches fill the column exactly, whatever its width.
    const float swatch = std::floor((ImGui::GetContentRegionAvail().x - 7.0f * 2.0f * theme.scale) / 8.0f);
    for (int c = 0; c < static_cast<int>(theme.muscles.size()); ++c) {
        if (c > 0) ImGui::SameLine(0.0f, 2.0f * theme.scale);
        ImGui::PushID(c);
        const bool chosen = c == muscle.color % static_cast<int>(theme.muscles.size());
        if (ImGui::ColorButton("##color", theme.muscles[static_cast<std::size_t>(c)],
                               ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                               {swatch, ImGui::GetFrameHeight()}))
            change(context, "colour", false, [&](commands::Muscle& m) { m.color = c; });
        if (chosen)
            ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                platform::packed(theme.text), 4.0f * theme.scale, 0,
                                                2.0f * theme.scale);
        context.items.mark("fibres/color/" + std::to_string(c));
        ImGui::PopID();
    }
}

/// Row of the stiffness w of the selected muscle [Pa], shown in kPa.
void draw_stiffness(PanelContext& context, NumberEdits& edit) {
    double stiffness = context.state.chosen_muscle()->stiffness_Pa;
    bool goes_on = false;
    const NumberField field{
        "Stiffness w",
        "fibres/stiffness",
        commands::Dimension::pressure,
        "kPa",
        "Energy per rest volume w/2 (|F m| \xe2\x88\x92 a)\xc2\xb2: m the fibre's direction, a(t) the target stretch.",
        commands::muscle_stiffness_limits,
        0.1,
        "stiffness"};
    if (number_row(context, field, edit, stiffness, goes_on, context.state.chosen_muscle()->name))
        change(context, "stiffness of a muscle", goes_on, [&](commands::Muscle& m) { m.stiffness_Pa = stiffness; });
}

/// A button of this width. Returns true if it was pressed.
bool paint_button(PanelContext& context, float width, const char* label, const char* name, const char* tip) {
    const bool pressed = ImGui::Button(label, {width, 0.0f});
    context.items.mark(name);
    tooltip(context.theme, tip);
    return pressed;
}

/// Settings without the selected muscle. Those that follow it become passive.
commands::Settings without_chosen_muscle(const commands::WorkbenchState& state) {
    const std::string name = state.chosen_muscle()->name;
    commands::Settings settings = state.settings;
    settings.muscles.erase(settings.muscles.begin() + state.muscle);
    for (commands::Muscle& other : settings.muscles)
        if (other.follows == name) other.follows.clear(), other.signal = fibre::Signal::constant(1.0);
    return settings;
}

/// Declared muscles cannot be removed.
void draw_remove_button(PanelContext& context, float width) {
    ImGui::BeginDisabled(!context.state.chosen_muscle()->declared.empty());
    if (paint_button(context, width, "Remove the muscle", "fibres/remove",
                     "Removes the muscle with its paint and its signal from the model"))
        context.emit(commands::ChangeSettings{without_chosen_muscle(context.state), "remove muscle", false});
    ImGui::EndDisabled();
}

/// Only the directions change; weights stay.
fibre::CellPaint straightened(const fibre::CellPaint& paint, const mesh::VolumeMesh& mesh) {
    fibre::CellPaint straight = paint;
    straight.directions = fibre::directions_along_longest_axis(mesh, paint.weights);
    return straight;
}

}  // namespace

commands::Muscle new_muscle(const commands::Settings& settings) {
    commands::Muscle muscle;
    for (int i = 1;; ++i) {
        muscle.name = "muscle " + std::to_string(i);
        if (!is_taken(settings, muscle.name)) break;
    }
    // The first colour that no other muscle has; beyond eight muscles the theme repeats its colours.
    const auto used = [&](const commands::Muscle& other) { return other.color == muscle.color; };
    while (std::any_of(settings.muscles.begin(), settings.muscles.end(), used)) ++muscle.color;
    muscle.stiffness_Pa = settings.youngs_modulus_Pa;
    // a contraction of a fifth within half a second, so that the first run shows motion
    muscle.signal = fibre::Signal{{0.0, 0.5}, {1.0, 0.8}};
    return muscle;
}

/// The brush is shown only with a selected muscle, as paint always belongs to one.
void FibrePanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (!state.scene) {
        muted_text(context.theme, "Muscles are painted on the body here.");
        return;
    }
    draw_actuators(context);
    draw_list(context);
    if (state.chosen_muscle()) draw_muscle(context);
    if (state.chosen_muscle()) brush_rows(context, {"fibres"}, edit_);
}

void FibrePanel::draw_list(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (state.settings.muscles.empty())
        muted_text(context.theme, "No muscles yet. Add one, then paint it on the body.");
    for (int m = 0; m < static_cast<int>(state.settings.muscles.size()); ++m) {
        draw_muscle_row(context, m);
    }
    if (ImGui::Button((std::string(platform::icon::plus) + "  Add a muscle").c_str(), {-1.0f, 0.0f})) {
        commands::Settings settings = state.settings;
        settings.muscles.push_back(new_muscle(settings));
        // The new muscle is selected by a second command, which is executed after the first one.
        const int added = static_cast<int>(settings.muscles.size()) - 1;
        context.emit(commands::ChangeSettings{std::move(settings), "add muscle", false});
        context.emit(commands::ChooseMuscle{added});
    }
    context.items.mark("fibres/add");
}

/// A typed name is checked when the field is left. A name that is not allowed is discarded without a message, and the
/// field shows the old one.
void FibrePanel::draw_name(PanelContext& context) {
    const commands::Muscle& muscle = *context.state.chosen_muscle();
    row_label(context.theme, "Name", "Heading of the muscle's column in signal files.");
    // While the field has the keyboard, its text is not replaced by the state.
    if (!typing_) typed_name_ = muscle.name;
    // A declared muscle keeps the name that it has in the experiment.
    ImGui::BeginDisabled(!muscle.declared.empty());
    ImGui::InputText("##name", &typed_name_);
    context.items.mark("fibres/name");
    ImGui::EndDisabled();
    typing_ = ImGui::IsItemActive();
    if (!ImGui::IsItemDeactivatedAfterEdit() || typed_name_ == muscle.name) return;
    // A name that would break signal files or clash with another muscle is rejected.
    const bool fits = !typed_name_.empty() && typed_name_ != "time_s" && typed_name_.find(',') == std::string::npos &&
                      !is_taken(context.state.settings, typed_name_);
    if (!fits) return;
    commands::Settings settings = context.state.settings;
    // Followers refer to the muscle by its name.
    for (commands::Muscle& other : settings.muscles)
        if (other.follows == muscle.name) other.follows = typed_name_;
    settings.muscles[static_cast<std::size_t>(context.state.muscle)].name = typed_name_;
    context.emit(commands::ChangeSettings{std::move(settings), "name of a muscle", false});
}

/// Two muscles that pull against each other share one signal. Only a muscle with its own signal can be followed, so
/// chains are not possible.
void FibrePanel::draw_link(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const commands::Muscle& muscle = *state.chosen_muscle();
    // A muscle that others follow needs its own signal, so it can have no partner itself.
    const bool leads = std::any_of(state.settings.muscles.begin(), state.settings.muscles.end(),
                                   [&](const commands::Muscle& other) { return other.follows == muscle.name; });
    // Only muscles with their own signal are offered.
    std::vector<commands::Choice> partners{{"", "None", "It has its own signal."}};
    for (const commands::Muscle& other : state.settings.muscles)
        if (other.name != muscle.name && other.follows.empty() && !leads)
            partners.push_back({other.name, other.name, "Its signal follows that of " + other.name + "."});
    std::string partner = muscle.follows;
    if (choice_row(context, "Antagonist of", "fibres/follows",
                   leads ? "Another muscle follows this one."
                         : "A muscle whose signal this one follows inversely: a \xe2\x88\x92 1 = ratio "
                           "(a\xe2\x82\x80 \xe2\x88\x92 1).",
                   partners, partner))
        change(context, "antagonist", false, [&](commands::Muscle& m) {
            m.follows = partner;
            // Without a partner the muscle needs a signal of its own.
            if (partner.empty() && !m.signal && m.declared.empty()) m.signal = fibre::Signal::constant(1.0);
        });
    if (muscle.follows.empty()) return;
    draw_ratio(context, edit_);
}

void FibrePanel::draw_muscle(PanelContext& context) {
    const commands::Muscle& muscle = *context.state.chosen_muscle();
    ImGui::Spacing();
    draw_name(context);
    draw_colors(context, muscle);
    draw_stiffness(context, edit_);
    // The action of a follower results from its ratio, so only leaders have this row.
    std::string action = muscle.extends ? "extends" : "contracts";
    if (muscle.follows.empty() &&
        choice_row(context, "When active", "fibres/action", "Action of the active muscle; a change mirrors its signal.",
                   action_choices(), action))
        change(context, "action of a muscle", false, [&](commands::Muscle& m) {
            m.extends = action == "extends";
            // Mirrored at a = 1: a contraction becomes the extension of the same size.
            if (m.signal)
                for (double& a : m.signal->values) a = 2.0 - a;
        });
    draw_link(context);
    draw_paint_actions(context);
}

/// These actions replace the paint of the muscle by a new one; each is one undo entry. They need a mesh that is
/// prepared for painting.
void FibrePanel::draw_paint_actions(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const fibre::CellPaint* const paint = state.chosen_paint();
    // Neither exists before the body is meshed.
    const bool ready = paint && state.ground;
    if (ready)
        text_row(context.theme, "Painted",
                 amount_label(
                     fibre::amount_of(context.live_paint ? *context.live_paint : *paint, state.ground->volumes_m3)));
    // All paint actions end in the same command, each with its own name for undo.
    const auto repaint = [&](const char* what, fibre::CellPaint changed) {
        context.emit(commands::Paint{state.muscle, std::make_shared<const fibre::CellPaint>(std::move(changed)), what});
    };
    // The three changes of the paint share a line; the removals below take a line each.
    const float gap = ImGui::GetStyle().ItemSpacing.x,
                third = std::floor((ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f);
    const auto button = [&](auto... texts) { return paint_button(context, third, texts...); };
    ImGui::BeginDisabled(!ready || !(paint->weights.maxCoeff() > 0.0));
    if (button("Grow", "fibres/grow", "Add one layer of elements"))
        repaint("grow", fibre::grown(*paint, state.ground->neighbours));
    ImGui::SameLine();
    if (button("Shrink", "fibres/shrink", "Remove one layer of elements"))
        repaint("shrink", fibre::shrunk(*paint, state.ground->neighbours));
    ImGui::SameLine();
    if (button("Straighten", "fibres/straighten", "Align all its fibres with its longest axis"))
        repaint("straighten", straightened(*paint, state.body->mesh));
    if (paint_button(context, -1.0f, "Clear the paint", "fibres/clear", "Removes all paint of the muscle, which stays"))
        repaint("clear", fibre::blank_paint(state.body->mesh));
    ImGui::EndDisabled();
    // Apart from the paint: this removes the muscle itself.
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    draw_remove_button(context, -1.0f);
}

}  // namespace myo::ui::panels
