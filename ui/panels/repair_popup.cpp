#include "panels/repair_popup.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// How repairs are written, and limits of the fields.
struct RepairWritingPolicy {
    double times_per_s = 1e6;         // to which the ends of a span are rounded: far below the interval of any camera
    double least_window_s = 1e-3;     // of smoothing
    double greatest_window_s = 10.0;  // of smoothing
};
constexpr RepairWritingPolicy repair_writing_policy;

/// Index of the shown trial in the declaration.
std::size_t trial_index(const commands::WorkbenchState& state) { return static_cast<std::size_t>(state.trial); }

/// Name of the shown marker, whose recording is repaired.
const std::string& marker_name_of(const commands::WorkbenchState& state) {
    return state.scene->markers[static_cast<std::size_t>(state.marker)].name;
}

/// Text of a time of the trial as a time of its recording, as repairs are declared.
std::string file_time(const commands::SceneTrial& trial, double time_s) {
    const double per_s = repair_writing_policy.times_per_s;
    return toml::toml_number(std::round((time_s + trial.repairs.start_s) * per_s) / per_s);
}

/// First and last sample in the span; the span itself if it holds none, for the reader to refuse.
chart::Range sampled(const commands::SceneTrial& trial, const chart::Range& span) {
    const auto first = std::lower_bound(trial.time_s.begin(), trial.time_s.end(), span.lowest);
    const auto end = std::upper_bound(trial.time_s.begin(), trial.time_s.end(), span.highest);
    return first < end ? chart::Range{*first, *(end - 1)} : span;
}

/// Emits the repair. `lines`: keys of this kind of repair.
void emit_repair(PanelContext& context, const commands::SceneTrial& trial, const chart::Range& span,
                 const std::string& kind, const std::string& lines = {}) {
    const chart::Range samples = sampled(trial, span);
    context.emit(commands::EditDeclaration{
        {commands::AppendDeclared{{"trial", trial_index(context.state), "repair"},
                                  "kind = " + toml::toml_text(kind) +
                                      "\nmarker = " + toml::toml_text(marker_name_of(context.state)) + "\n" + lines +
                                      "from_s = " + file_time(trial, samples.lowest) +
                                      "\nto_s = " + file_time(trial, samples.highest) + "\n"}},
        "repair/" + kind});
}

}  // namespace

void RepairPopup::draw(PanelContext& context, const char* label, std::optional<chart::Range>& span) {
    const commands::SceneTrial& trial = *context.state.scene_trial();
    ImGui::BeginDisabled(!trial.repairs.possible);
    if (ImGui::Button(label)) ImGui::OpenPopup("repair");
    context.items.mark("repair/open");
    ImGui::EndDisabled();
    tooltip(context.theme, trial.repairs.possible
                               ? "Cuts, fills, swaps or smooths the recording of this marker over the selected time. "
                                 "The file of the recording stays as it is."
                               : "This trial has no recording to repair.");
    if (!begin_popup_above(context.theme, "repair", 360.0f)) return;
    heading(context.theme, "Repair the recording of " + marker_name_of(context.state));
    draw_span(context, trial, span);
    ImGui::BeginDisabled(!span);
    draw_repairs(context, trial, span.value_or(chart::Range{}));
    ImGui::EndDisabled();
    draw_made(context, trial);
    // The popup covers the head of the side panel, where a refused edit is reported otherwise.
    if (!context.state.refused.empty()) notice(context.theme, commands::LogLevel::warning, context.state.refused);
    ImGui::EndPopup();
}

void RepairPopup::draw_span(PanelContext& context, const commands::SceneTrial& trial,
                            std::optional<chart::Range>& span) {
    const double first = trial.time_s[0], last = trial.time_s[trial.time_s.size() - 1];
    if (!span) {
        muted_text(context.theme, "Shift and drag in a plot selects the time, or type it here.");
        if (ImGui::Button("The whole trial", {-1.0f, 0.0f})) span = chart::Range{first, last};
        context.items.mark("repair/whole");
    }
    // Without a selection the fields show the whole trial; the first edit of one selects a span.
    chart::Range edited = span.value_or(chart::Range{first, last});
    bool goes_on = false, changed = false;
    changed |= number_row(context,
                          {"From",
                           "repair/from",
                           commands::Dimension::time,
                           "s",
                           "First time of the span, t of the trial.",
                           {first, std::max(first, edited.highest)},
                           1e-3,
                           "first time"},
                          edits_, edited.lowest, goes_on);
    changed |= number_row(context,
                          {"To",
                           "repair/to",
                           commands::Dimension::time,
                           "s",
                           "Last time of the span, t of the trial.",
                           {std::min(edited.lowest, last), last},
                           1e-3,
                           "last time"},
                          edits_, edited.highest, goes_on);
    if (changed) span = edited;
    // Times of other programs count from the start of the recording.
    if (trial.repairs.start_s != 0.0)
        muted_text(context.theme, "t = 0 is " + plot::value_label(trial.repairs.start_s, 6) + " s of the recording.");
}

void RepairPopup::draw_repairs(PanelContext& context, const commands::SceneTrial& trial, const chart::Range& span) {
    // Every repair is appended to the list of the trial and applied in that order when the recording is read.
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (ImGui::Button("Cut", {half, 0.0f})) emit_repair(context, trial, span, "cut");
    context.items.mark("repair/cut");
    tooltip(context.theme, "Makes the span a gap: these samples are not compared.");
    ImGui::SameLine();
    if (ImGui::Button("Fill the gaps", {half, 0.0f})) emit_repair(context, trial, span, "fill");
    context.items.mark("repair/fill");
    tooltip(context.theme,
            "Interpolates the gaps in the span by a cubic polynomial through the five samples on each side. Filled "
            "samples count as measurements in a fit.");
    draw_swap(context, trial, span);
    // The width of the window is no part of the experiment until the repair is made.
    bool goes_on = false;
    number_row(context,
               {"Window",
                "repair/window",
                commands::Dimension::time,
                "s",
                "Width of the window of smoothing: shorter than the motion to keep, longer than a few samples.",
                {repair_writing_policy.least_window_s, repair_writing_policy.greatest_window_s},
                1e-3},
               edits_, window_s_, goes_on);
    if (ImGui::Button("Smooth", {-1.0f, 0.0f}))
        emit_repair(context, trial, span, "smooth", "window_s = " + toml::toml_number(window_s_) + "\n");
    context.items.mark("repair/smooth");
    tooltip(context.theme,
            "Gives every sample of the span the value of the cubic polynomial that fits the samples in the window "
            "around it best. The noise is then estimated from the rest of the recording.");
}

void RepairPopup::draw_swap(PanelContext& context, const commands::SceneTrial& trial, const chart::Range& span) {
    const std::vector<commands::SceneMarker>& markers = context.state.scene->markers;
    std::vector<commands::Choice> others;
    for (std::size_t m = 0; m < markers.size(); ++m)
        if (static_cast<int>(m) != context.state.marker) others.push_back({std::to_string(m), markers[m].name, ""});
    if (others.empty()) return;
    // The marker chosen last may be the shown one by now.
    std::string chosen = std::to_string(with_);
    if (std::none_of(others.begin(), others.end(), [&](const commands::Choice& c) { return c.id == chosen; }))
        chosen = others.front().id;
    choice_row(context, "Other marker", "repair/with", "The marker that the shown one is swapped with.", others,
               chosen);
    with_ = std::stoi(chosen);
    const std::string& name = markers[static_cast<std::size_t>(with_)].name;
    if (ImGui::Button("Swap the two", {-1.0f, 0.0f}))
        emit_repair(context, trial, span, "swap", "with = " + toml::toml_text(name) + "\n");
    context.items.mark("repair/swap");
    tooltip(context.theme, "Exchanges the samples of the two markers in the span.");
}

void RepairPopup::draw_made(PanelContext& context, const commands::SceneTrial& trial) {
    if (trial.repairs.made.empty()) return;
    heading(context.theme, "Repairs of this trial");
    const float button = ImGui::GetFrameHeight();
    for (std::size_t r = 0; r < trial.repairs.made.size(); ++r) {
        const std::string item = "repair/remove/" + std::to_string(r);
        ImGui::PushID(static_cast<int>(r));
        if (ImGui::Button(platform::icon::remove, {button, 0.0f}))
            context.emit(commands::EditDeclaration{
                {commands::RemoveDeclared{{"trial", trial_index(context.state), "repair", r}}}, item});
        context.items.mark(item);
        tooltip(context.theme, "Remove this repair");
        ImGui::SameLine();
        wrapped_text(trial.repairs.made[r]);
        ImGui::PopID();
    }
}

}  // namespace myo::ui::panels
