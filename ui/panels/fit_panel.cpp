#include "panels/fit_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "commands/search_target.hpp"
#include "commands/sought_signals.hpp"
#include "panels/check_marks.hpp"
#include "panels/limit_rows.hpp"
#include "panels/signal_ticks.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {

namespace {

/// Number of the settings of a search. No part of undo, so it does not matter whether a drag continues.
bool request_row(PanelContext& context, const NumberField& field, NumberEdits& edit, double& value) {
    bool ignored = false;
    return number_row(context, field, edit, value, ignored);
}

/// Row of a bound of the target stretch.
///
/// @param which  "Lower" or "Upper"
/// @param meaning  what values on its side of 1 do
NumberField bound_field(const char* label, const char* name, const std::string& which, const std::string& meaning,
                        const commands::Limits& limits) {
    return {label,
            name,
            commands::Dimension::ratio,
            "",
            which +
                " bound of the target stretch a, dimensionless: target length of the fibres over their length at "
                "rest. " +
                meaning,
            limits,
            0.005};
}

/// What a quantity is that the search may change.
const char* seek_explanation(const std::string& word) {
    if (word.starts_with("direction"))
        return "Turns the fibres from their declared direction: all alike where one direction is declared, otherwise "
               "by "
               "a smooth field over the muscle, a polynomial of third degree of the place.";
    if (word.starts_with("weights"))
        return "Share of muscle in each painted cell and in the cells next to them, 0 to 1. Changes from cell to cell "
               "cost a little, so that the paint stays even.";
    return "Young's modulus E [kPa], from a tenth to ten times its present value.";
}

/// What is ticked, in short: "signals, 2 of the body", "1 of 3 signals".
std::string seek_words(const commands::WorkbenchState& state, const commands::OptimizeRequest& request) {
    const std::size_t count = request.seek.size();
    const std::vector<commands::SignalChoice> all = commands::signal_choices(*state.scene, state.settings);
    const auto sought = std::count_if(all.begin(), all.end(), [](const auto& choice) { return choice.sought; });
    const bool every = sought == static_cast<std::ptrdiff_t>(all.size());
    std::string words = !request.signals ? ""
                        : every          ? "signals"
                                         : std::to_string(sought) + " of " + std::to_string(all.size()) + " signals";
    if (count > 0) words += (words.empty() ? "" : ", ") + std::to_string(count) + " of the body";
    return words.empty() ? "nothing" : words;
}

/// Ticks of what the search may change, in a list that opens.
void draw_seek_row(PanelContext& context, commands::OptimizeRequest& request) {
    const commands::WorkbenchState& state = context.state;
    row_label(context.theme, "Change", "What the search may change: signals, and quantities of the body.");
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##seek", seek_words(state, request).c_str());
    context.items.mark("fit/seek");
    if (!open) return;
    // One entry of the list; the word identifies it in requests and tests.
    const auto tick = [&](const std::string& label, const std::string& word, const char* explanation, bool& on) {
        ImGui::Checkbox((label + "##seek/" + word).c_str(), &on);
        context.items.mark("fit/seek/" + word);
        tooltip(context.theme, explanation);
    };
    if (commands::has_actuators(*state.scene, state.settings))
        tick("Signals", "signals",
             "Signals of the muscles that follow none, pressures of chambers, commands of tendons, at knots over time: "
             "of those that are ticked below.",
             request.signals);
    if (request.signals) draw_signal_ticks(context);
    for (const commands::SeekChoice& choice : commands::seek_choices(state.scene->seekable, state.settings)) {
        // The request lists the words of what is sought; what is not listed keeps its value.
        const auto found = std::find(request.seek.begin(), request.seek.end(), choice.word);
        const bool was = found != request.seek.end();
        bool on = was;
        tick(choice.label, choice.word, seek_explanation(choice.word), on);
        if (on && !was) request.seek.push_back(choice.word);
        if (!on && was) request.seek.erase(found);
    }
    ImGui::EndCombo();
}

/// Density of the knots and bounds of the search for signals.
void draw_optimize_rows(PanelContext& context, NumberEdits& edit, commands::OptimizeRequest& request) {
    request_row(
        context,
        {"Knots",
         "fit/frequency",
         commands::Dimension::frequency,
         "1/s",
         "Knots of each signal a(t) per second [1/s]; between them it is linear. A trial of T seconds has about "
         "T times as many unknowns for each muscle.",
         {0.5, 200.0},
         0.1,
         "density of knots"},
        edit, request.frequency_Hz);
    // Limits of chambers and tendons belong to the experiment, bounds of muscles to the request.
    draw_limit_rows(context, edit);
    if (context.state.settings.muscles.empty()) return;
    request_row(context, bound_field("Minimum a", "fit/lowest", "Lower", "Below 1 they pull.", {0.1, 1.0}), edit,
                request.lowest);
    request_row(context, bound_field("Maximum a", "fit/highest", "Upper", "Above 1 they push.", {1.0, 4.0}), edit,
                request.highest);
}

/// Row of the maximum number of runs of the search.
void draw_evaluations_row(PanelContext& context, NumberEdits& edit, commands::OptimizeRequest& request) {
    // Number fields edit doubles; the request has an integer.
    double evaluations = request.max_evaluations;
    const NumberField field{
        "Evaluations",
        "fit/evaluations",
        commands::Dimension::number,
        "",
        "Maximum number of runs of the trial, each with the exact gradient of its loss by the adjoint method.",
        {1.0, 1000.0},
        1.0,
        "number of evaluations",
        true};
    if (request_row(context, field, edit, evaluations))
        request.max_evaluations = static_cast<int>(std::lround(evaluations));
}

}  // namespace

/// Both searches are shown below each other; each explains why it is not available.
void FitPanel::draw(PanelContext& context) {
    if (!context.state.scene)
        return muted_text(context.theme,
                          // Each part explains what is missing if it cannot be used.
                          "Values and signals are fitted to measured motion here. Open an experiment folder first.");
    draw_calibrate(context);
    draw_optimize(context);
    draw_found(context);
}

void FitPanel::draw_calibrate(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    heading(theme, "Values of the model");
    if (state.scene->calibrated.empty()) return muted_text(theme, "Unknown parameters: none.");
    // One parameter per line.
    std::string list;
    for (const std::string& label : state.scene->calibrated) list += (list.empty() ? "" : "\n") + label;
    text_row(theme, "Unknown", list);
    if (ImGui::Button((std::string(platform::icon::target) + "  Calibrate").c_str(), {-1.0f, 0.0f}))
        context.emit(commands::Calibrate{});
    context.items.mark("fit/calibrate");
    tooltip(theme,
            "Fits these to all trials of role fit: the least |r|² / 2, r = (simulated − measured) / noise, on exact "
            "derivatives; trials of role validate are predicted at the end.");
}

/// The request is part of the state, so its values are kept while other panels are shown.
void FitPanel::draw_optimize(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    heading(theme, "Signals and design");
    const commands::SceneTrial* const trial = state.scene_trial();
    if (!trial || !commands::has_target(*trial))
        return muted_text(theme, "The shown trial has neither goals nor measured markers to follow.");
    // Edited as a copy and emitted if anything changed.
    commands::OptimizeRequest request = commands::offered_request(*state.scene, state.settings, state.optimize);
    // What the experiment no longer has is left out of the request without an edit by the user, so it is no change
    // here.
    const commands::OptimizeRequest offered = request;
    text_row(theme, "Follow", commands::target_words(*trial));
    tooltip(theme, "Goals of the trial that the timeline shows, or else its recording, are the target.");
    draw_seek_row(context, request);
    if (request.signals) draw_optimize_rows(context, edit_, request);
    draw_evaluations_row(context, edit_, request);
    if (!(request == offered)) context.emit(commands::ChangeOptimize{request});
    if (ImGui::Button((std::string(platform::icon::bolt) + "  Optimise").c_str(), {-1.0f, 0.0f}))
        context.emit(commands::Optimize{});
    context.items.mark("fit/optimize");
    tooltip(
        theme,
        "Changes what is ticked until the markers reach the goals or follow the recording: least mean square distance "
        "plus a small penalty on the rate of the signals and on uneven changes of the fibres, by a quasi-Newton search "
        "on its exact gradient. The best so far plays in the view; the result is one step of undo.");
}

void FitPanel::draw_found(PanelContext& context) {
    const auto& found = context.state.found;
    const platform::Theme& theme = context.theme;
    if (!found) return;
    heading(theme, found->title + (found->stopped ? ", stopped" : ""));
    context.items.mark("fit/found");
    // Start values are shown below the results, so that a change can be judged.
    for (const commands::ParameterRow& row : found->parameters)
        text_row(theme, row.name,
                 plot::label_with_deviation(row.value, row.deviation) + " " + row.unit + "\nfrom " +
                     plot::plain_label(row.start, 4) + " " + row.unit);
    for (const std::string& note : found->notes) muted_text(theme, note);
    text_row(theme, "rms error",
             plot::millimetres(found->rms_before_m) + " \xe2\x86\x92 " + plot::millimetres(found->rms_after_m));
    if (!found->problem.empty()) notice(theme, commands::LogLevel::warning, found->problem);
    for (const std::string& warning : found->warnings) notice(theme, commands::LogLevel::warning, warning);
    checks_line(context, found->run.checks, "fit/checks");
}

}  // namespace myo::ui::panels
