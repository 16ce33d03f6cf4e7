#include "panels/diagnose_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "base/letter_case.hpp"
#include "panels/check_marks.hpp"
#include "panels/job_text.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

constexpr const char* times_sign = "\xc3\x97";  // multiplication sign

/// Percentage with three digits; a dash if unknown, "0" below 0.05 %.
std::string percent(double share) {
    return !std::isfinite(share) ? dash : std::abs(share) < 5e-4 ? "0" : plot::value_label(100.0 * share, 3);
}

/// Nothing missing is good news only if the checks are green too.
ImVec4 verdict_color(const platform::Theme& theme, const commands::DiagnosisView& d) {
    if (!d.complete) return theme.text;
    if (d.verdict == commands::DiagnosisVerdict::none) return check_color(theme, commands::worst_state(d.checks));
    return d.verdict == commands::DiagnosisVerdict::effects ? theme.accent : theme.warning;
}

/// Progress of the diagnosis: its present part, what is counted, and the times.
std::string stage_text(const commands::JobView& job) {
    std::string words = job.progress.task.empty() ? "Starting" : job.progress.task;
    // The parts of a diagnosis have lower-case names.
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    if (const std::string counted = counted_text(job); !counted.empty()) words += ", " + counted;
    if (!job.progress.message.empty()) words += " \xc2\xb7 " + readable_detail(job);
    if (job.remaining_s) words += " \xc2\xb7 " + time_text(job);
    return words + " \xc2\xb7 " + duration_label(job.elapsed_s) + " so far";
}

/// Only fitted effects can be added. The declared model is in the model already, and a missing force is no effect.
bool can_be_added(const commands::DiagnosisRow* row) {
    return row && row->fitted && row->kind == commands::DiagnosisRow::Kind::effects;
}

/// Fitted value as far as the cell has room; the tooltip shows all of it.
std::string value_text(const commands::DiagnosisRow& row, float width) {
    const bool fits = ImGui::CalcTextSize(row.value.c_str()).x <= width;
    return row.one_number || (!fits && !row.brief.empty()) ? row.brief : row.value;
}

/// Explains what a diagnosis needs; empty: it is possible.
std::string why_not_diagnosed(const commands::WorkbenchState& state) {
    if (!state.scene)
        return "Finds missing effects: compares the simulation with measured markers and tries every known effect on "
               "the residual. Open an experiment folder to begin.";
    if (!commands::can_be_diagnosed(*state.scene))
        return "Nothing to diagnose: this needs an experiment folder with at least one trial of role fit and its "
               "measured markers.";
    return {};
}

/// Cancel and the progress of the running diagnosis.
void draw_running_diagnosis(PanelContext& context, const ImVec2& button) {
    const commands::WorkbenchState& state = context.state;
    const float s = context.theme.scale;
    // Once cancelled, the button has nothing more to do, but the job needs time to end.
    ImGui::BeginDisabled(state.job->cancelling);
    if (ImGui::Button((std::string(platform::icon::stop) + "  Cancel").c_str(), button))
        context.emit(commands::Cancel{});
    context.items.mark("diagnose/cancel");
    ImGui::EndDisabled();
    ImGui::SameLine(0.0f, 12.0f * s);
    const commands::JobView& job = *state.job;
    ImGui::ProgressBar(static_cast<float>(job.fraction()), {160.0f * s, 0.0f}, bar_text(job).c_str());
    context.items.mark("diagnose/progress");
    ImGui::SameLine(0.0f, 12.0f * s);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(
        elided(job.cancelling ? "Stopping" : stage_text(job), ImGui::GetContentRegionAvail().x).c_str());
}

/// Text of the button that adds the effect of the row; empty: no button.
std::string add_label(const commands::WorkbenchState& state, const commands::DiagnosisRow* row) {
    if (!can_be_added(row)) return {};
    return commands::is_in_model(state, *row) ? std::string(platform::icon::done) + "  Added to the model"
                                              : std::string(platform::icon::plus) + "  Add " + lower_first(row->name);
}

/// Reasons of the verdict and indistinguishable effects, as one text.
std::string reasons(const commands::DiagnosisView& d) {
    std::string words = d.because;
    for (const std::string& each : d.confounded) words += (words.empty() ? "" : " ") + each;
    return words;
}

/// The verdict, with its confidence if there is room for it. The tooltip has both, and the reasons in `words`.
void draw_verdict(PanelContext& context, const std::string& words, float add_width) {
    const platform::Theme& theme = context.theme;
    const commands::DiagnosisView& d = *context.state.diagnosis;
    const float s = theme.scale;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(theme.strong);
    // Widths in pixels at scale 1: the confidence is shown if 160 remain for the verdict.
    const float confidence_width = 140.0f * s, all = ImGui::GetContentRegionAvail().x - add_width - 16.0f * s;
    const bool with_confidence = d.complete && all > confidence_width + 160.0f * s;  // otherwise in the tooltip
    const float room = all - (with_confidence ? confidence_width : 0.0f);
    const std::string confidence = "confidence " + plot::value_label(100.0 * d.confidence, 2) + " %";
    const std::string headline = d.complete ? d.headline : "Cancelled before a verdict: interim results";
    ImGui::TextColored(verdict_color(theme, d), "%s", elided(headline, room).c_str());
    ImGui::PopFont();
    context.items.mark("diagnose/verdict");
    tooltip(theme, d.headline + (d.complete ? "\n" + confidence : "") + (words.empty() ? "" : "\n\n") + words);
    if (with_confidence) {
        ImGui::SameLine(0.0f, 12.0f * s);
        ImGui::TextColored(theme.muted, "%s", confidence.c_str());
        tooltip(theme,
                "Probability of the verdict among all candidates, the declared model and \"none of these\" included.");
    }
}

/// Below the head, in one or two lines, depending on the height that is left.
void draw_reasons(PanelContext& context, const std::string& words) {
    const ImVec2 below = ImGui::GetContentRegionAvail();
    const float s = context.theme.scale;
    if (below.y < 160.0f * s) return;  // the plot needs the room; the tooltip of the verdict has the text
    muted_text(context.theme, elided_lines(words, below.x, below.y > 180.0f * s ? 2 : 1));
    context.items.mark("diagnose/because");
    tooltip(context.theme, words);
}

/// Button at the right that adds the effect of the row to the model.
void draw_add_button(PanelContext& context, const commands::DiagnosisRow& row, const std::string& add,
                     float add_width) {
    const platform::Theme& theme = context.theme;
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - add_width));
    ImGui::BeginDisabled(commands::is_in_model(context.state, row));
    if (primary_button(theme, add, {add_width, 0.0f})) context.emit(commands::AddEffect{row.key});
    context.items.mark("diagnose/add");
    ImGui::EndDisabled();
    tooltip(theme, row.name + ": " + row.value +
                       "\n\nAdds it to the model, with the modulus and the damping that were fitted with "
                       "it. The next run uses it; undo removes it.");
}

/// Columns and headings of the ranking.
void set_up_ranking(const platform::Theme& theme) {
    ImGui::TableSetupScrollFreeze(0, 1);
    // In a narrow window the value is in the tooltip, and the weight makes room for the name.
    const float width = ImGui::GetWindowWidth() / theme.scale;
    const bool narrow = width < 480.0f, tight = width < 420.0f;
    const std::vector<Heading> headings{
        {"", ""},
        {"Effect", "Best first. Click a row to show its effect."},
        {"Fitted value", "With one standard deviation, fitted together with the declared parameters."},
        {"Explains [%]", "Share of the squared residual that it can remove, after what the declared parameters absorb.",
         true},
        {std::string("Held out [") + times_sign + "]",
         "Error on blocks of data that the fit did not see, in units of the noise: 1 is perfect.", true},
        {"Weight [%]", "Share of the evidence among all that was fitted, the declared model included.", true}};
    ImGui::TableSetupColumn("rank", ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("00").x);
    ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch, 1.2f);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch | (narrow ? ImGuiTableColumnFlags_Disabled : 0),
                            1.2f);
    for (std::size_t k = 3; k < headings.size(); ++k)
        number_column(theme, headings[k], tight && k == 5 ? ImGuiTableColumnFlags_Disabled : 0);
    heading_row(theme, headings);
}

/// Tooltip of a row. It adds what the columns cannot show: similar effects, and why there are no force arrows.
std::string row_words(const commands::DiagnosisRow& row) {
    const std::string like = row.like.empty() ? "" : "In this experiment it is confounded with " + row.like + ".";
    // Complete, however narrow the table is.
    std::string words = row.name + (row.value.empty() ? "" : ": " + row.value);
    for (const std::string& more : {like, row.no_force})
        if (!more.empty()) words += (words.empty() ? "" : "\n") + more;
    return words;
}

/// One row of the ranking. Effects are numbered: `rank` counts them.
void ranking_row(PanelContext& context, const commands::DiagnosisRow& row, int& rank) {
    const platform::Theme& theme = context.theme;
    const commands::DiagnosisView& d = *context.state.diagnosis;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    // Rows that were not fitted are dimmed.
    const ImVec4& color = row.fitted ? theme.text : theme.muted;
    const std::string label = row.kind == commands::DiagnosisRow::Kind::effects ? std::to_string(++rank) : " ";
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    if (ImGui::Selectable((label + "##" + row.key).c_str(), &row == context.state.diagnosis_row(),
                          ImGuiSelectableFlags_SpanAllColumns))
        context.emit(commands::ChooseCandidate{row.key});
    ImGui::PopStyleColor();
    context.items.mark("diagnose/row/" + row.key);
    tooltip(theme, row_words(row));
    // The verdict's row carries the icon of the checks instead of a tick of its own.
    const std::string sign = row.chosen ? std::string("  ") + check_icon(commands::worst_state(d.checks)) : "";
    text_cell(theme, row.name + sign, row.chosen ? verdict_color(theme, d) : color);
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::TextColored(color, "%s", elided(value_text(row, room), room).c_str());
    context.items.add("diagnose/value/" + row.key, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    number_cell(theme, percent(row.explained), &color);
    number_cell(theme, plot::value_label(row.held_out, 3), &color);
    number_cell(theme, percent(row.weight), &color);
}

}  // namespace

std::string DiagnosePanel::title() const { return std::string(platform::icon::stethoscope) + "  Diagnose"; }

void DiagnosePanel::draw_details(PanelContext& context, bool narrow) {
    ImGui::BeginChild("chosen");
    const commands::DiagnosisRow* const row = context.state.diagnosis_row();
    if (narrow) {
        if (tab(context.theme, "Ranking", ranking_)) ranking_ = true;
        context.items.mark("diagnose/show/ranking");
        if (row) ImGui::SameLine();
    }
    // In a narrow panel the ranking is one of the alternatives, like the details.
    const bool alone = narrow && ranking_;
    if (row) draw_choices(context, alone);
    if (alone)
        draw_ranking(context);
    else if (!row) {
    } else if (errors_)
        draw_errors(context, *row);
    else if (row->kind == commands::DiagnosisRow::Kind::missing_force)
        draw_force(context);
    else
        draw_residual(context, *row);
    ImGui::EndChild();
}

/// Explains what is missing if a diagnosis is not possible. Otherwise: the head; below it the ranking on the left and
/// the details of the selected row on the right; in a narrow panel one of the two.
void DiagnosePanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (const std::string why = why_not_diagnosed(state); !why.empty()) return muted_text(context.theme, why);
    // Before drawing, as the parts below use zoom and axis.
    follow(state);
    draw_head(context);
    if (!state.diagnosis) {
        if (!state.diagnosing())
            muted_text(
                context.theme,
                "Diagnose fits the declared values, tests whether the residual exceeds the noise, tries every effect "
                "of the catalogue and "
                "fits the best. Trials of role validate are predicted once, at the end. It takes some minutes "
                "and can be cancelled.");
        return;
    }
    const float width = ImGui::GetContentRegionAvail().x;
    // not enough room for both: ranking and plot become alternatives
    const bool narrow = width < 560.0f * context.theme.scale;
    if (!narrow) {
        ImGui::BeginChild("ranking", {std::floor(0.55f * width), 0.0f});
        draw_ranking(context);
        ImGui::EndChild();
        ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
    }
    draw_details(context, narrow);
}

/// Resets zoom and axis if another curve is shown.
void DiagnosePanel::follow(const commands::WorkbenchState& state) {
    if (scene_ != state.scene) axis_chosen_ = false;
    scene_ = state.scene;
    // Until the user selects an axis, the one with the largest error is shown.
    if (!axis_chosen_ && state.diagnosis) axis_ = std::clamp(state.diagnosis->worst_axis, 0, 2);
    const commands::DiagnosisRow* const row = state.diagnosis_row();
    // One string for everything that identifies the curve is simpler to compare than six members.
    const std::string shown = state.scene->path.string() +
                              (row && row->kind == commands::DiagnosisRow::Kind::missing_force ? " force " : " ") +
                              std::to_string(state.trial) + " " + std::to_string(state.marker) + " " +
                              std::to_string(axis_);
    if (shown == followed_) return;
    // A different curve: the old zoom has no meaning for it.
    followed_ = shown;
    time_.range.reset();
    plot_ = {};
}

/// From left to right: button, verdict, confidence, and the button that adds the effect. What has no room moves into
/// the tooltip of the verdict, first the reasons, then the confidence.
void DiagnosePanel::draw_head(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float s = theme.scale;
    const ImVec2 button{132.0f * s, 0.0f};
    // While a diagnosis runs, the head shows its progress instead of the verdict.
    if (state.diagnosing()) {
        draw_running_diagnosis(context, button);
        return;
    }
    const std::string label = std::string(platform::icon::stethoscope) + "  Diagnose";
    if (state.diagnosis ? ImGui::Button(label.c_str(), button) : primary_button(theme, label, button))
        context.emit(commands::Diagnose{});
    context.items.mark("diagnose/diagnose");
    if (!state.diagnosis) return;
    const commands::DiagnosisView& d = *state.diagnosis;
    const commands::DiagnosisRow* const row = state.diagnosis_row();
    const std::string add = add_label(state, row);
    // The verdict takes the room that the button on the right leaves.
    const float add_width = add.empty() ? 0.0f
                                        : ImGui::CalcTextSize(add.c_str()).x + 4.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(0.0f, 12.0f * s);
    const std::string words = reasons(d);
    draw_verdict(context, words, add_width);
    if (!add.empty()) draw_add_button(context, *row, add, add_width);
    if (!words.empty()) draw_reasons(context, words);
}

/// Columns in falling importance from left to right; those that have no room are left out, and the tooltip of a row has
/// all of them.
void DiagnosePanel::draw_ranking(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const commands::DiagnosisView& d = *state.diagnosis;
    // Six columns always exist; those without room are disabled, so the rows below need no cases.
    if (!ImGui::BeginTable("candidates", 6,
                           ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                               ImGuiTableFlags_BordersOuterH))
        return;
    set_up_ranking(theme);
    int rank = 0;
    for (const commands::DiagnosisRow& row : d.rows) {
        ranking_row(context, row, rank);
    }
    ImGui::EndTable();
}

void DiagnosePanel::draw_axis_choice(PanelContext& context, float width) {
    ImGui::SetNextItemWidth(width);
    const bool axes = ImGui::BeginCombo("##axis", axis_names[static_cast<std::size_t>(axis_)]);
    context.items.mark("diagnose/axis");
    if (!axes) return;
    for (int axis = 0; axis < 3; ++axis) {
        const char* const name = axis_names[static_cast<std::size_t>(axis)];
        if (ImGui::Selectable(name, axis_ == axis)) {
            axis_ = axis;
            axis_chosen_ = true;
        }
        context.items.mark(std::string("diagnose/axis/") + name);
    }
    ImGui::EndCombo();
}

/// Marker and axis belong to the residual only; errors and the missing force have no marker.
void DiagnosePanel::draw_choices(PanelContext& context, bool none) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float s = theme.scale;
    const auto choice = [&](const char* label, const char* name, bool errors) {
        if (tab(theme, label, !none && errors_ == errors)) {
            errors_ = errors;
            ranking_ = false;
        }
        context.items.mark(name);
    };
    choice("Residual", "diagnose/show/residual", false);
    ImGui::SameLine();
    choice("Errors", "diagnose/show/errors", true);
    tooltip(theme, "Errors of the trials before and after");
    const commands::DiagnosisRow* const row = state.diagnosis_row();
    if (none || errors_ || row->kind == commands::DiagnosisRow::Kind::missing_force) return;
    // The marker is shared with the other panels; the axis belongs to this panel.
    // In a narrow window these controls get a line of their own.
    const float axis_width = 56.0f * s, least = 72.0f * s;
    ImGui::SameLine(0.0f, 16.0f * s);
    const float room = ImGui::GetContentRegionAvail().x - axis_width - ImGui::GetStyle().ItemSpacing.x;
    if (room < least) ImGui::NewLine();
    ImGui::SetNextItemWidth(
        std::min(150.0f * s, ImGui::GetContentRegionAvail().x - axis_width - ImGui::GetStyle().ItemSpacing.x));
    marker_list(context, "diagnose/marker");
    ImGui::SameLine();
    draw_axis_choice(context, axis_width);
}

}  // namespace myo::ui::panels
