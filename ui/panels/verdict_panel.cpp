#include "panels/verdict_panel.hpp"

#include <imgui.h>

#include <cmath>

#include "panels/check_marks.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {

namespace {

/// Each missing precondition of a verdict has its own text; empty: there is a diagnosis.
std::string why_no_verdict(const commands::WorkbenchState& state) {
    if (!state.scene || !commands::can_be_diagnosed(*state.scene))
        return "A diagnosis compares the simulation with measured markers and tries every known effect on the "
               "residual. It needs an experiment folder with a trial of role fit.";
    if (state.diagnosing()) return "The diagnosis is running; its ranking is shown below the view.";
    if (!state.diagnosis)
        return "Start it below the view. It fits the declared values first, tests whether the residual exceeds the "
               "noise, then tries every effect of the catalogue.";
    return {};
}

/// Confidence of the verdict and noise of the measurement.
void draw_verdict_numbers(PanelContext& context, const commands::DiagnosisView& d) {
    const platform::Theme& theme = context.theme;
    text_row(theme, "Confidence", plot::value_label(100.0 * d.confidence, 2) + " %");
    tooltip(theme,
            "Probability of the verdict among all candidates, the declared model and \"none of these\" included: "
            "its share of the evidence, reduced where the data cast doubt on the verdict.");
    context.items.mark("verdict/confidence");
    text_row(theme, "Noise", plot::millimetres(d.noise_m));
    tooltip(theme,
            "Root mean square error [mm] that a correct model would leave: that of the measurement. Errors \"times the "
            "noise\" are in units of it.");
    context.items.mark("verdict/noise");
}

/// Errors of the trials before and with the row.
void draw_verdict_errors(const platform::Theme& theme, const commands::DiagnosisView& d,
                         const commands::DiagnosisRow& row) {
    // The declared model has no other errors to compare with.
    const bool compared = row.kind != commands::DiagnosisRow::Kind::declared;
    heading(theme, compared ? "Errors with " + row.name : "Errors of the declared model");
    for (std::size_t t = 0; t < d.trials.size(); ++t) {
        const double after = t < row.after_m.size() ? row.after_m[t] : std::nan("");
        text_row(theme, d.trials[t].name,
                 plot::millimetres(d.trials[t].before_m) +
                     (compared ? " \xe2\x86\x92 " + plot::millimetres(after) : "") +
                     (d.trials[t].fitted ? "" : ", predicted"),
                 after < d.trials[t].before_m ? &theme.success : nullptr);
    }
}

}  // namespace

/// Verdict, confidence, reasons and remarks as text; then the errors per trial before and with the selected row.
void VerdictPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    if (const std::string why = why_no_verdict(state); !why.empty()) return muted_text(theme, why);
    const commands::DiagnosisView& d = *state.diagnosis;
    // "Nothing is missing" is as good as the checks of the experiment; any other verdict is a warning.
    const commands::LogLevel verdict = d.verdict == commands::DiagnosisVerdict::none
                                           ? commands::log_level(commands::worst_state(d.checks))
                                           : commands::LogLevel::warning;
    const commands::LogLevel level = d.complete ? verdict : commands::LogLevel::information;
    const commands::DiagnosisRow* const verdict_row = d.chosen_row();
    const bool added = verdict_row && commands::is_in_model(state, *verdict_row);
    if (added)
        notice(theme, commands::LogLevel::information,
               verdict_row->name + " was missing and is in the model now. Run to see what it changes.");
    else
        notice(theme, level, d.complete ? d.headline + "." : "Cancelled before a verdict; interim results are shown.");
    context.items.mark(added ? "verdict/added" : "verdict/headline");
    if (!d.complete) return;
    checks_line(context, d.checks, "verdict/checks");
    draw_verdict_numbers(context, d);
    if (!d.because.empty()) muted_text(theme, d.because);
    // What cannot be distinguished, what is similar, and further remarks.
    for (const std::vector<std::string>* const list : {&d.confounded, &d.alike, &d.notes})
        for (const std::string& each : *list) notice(theme, commands::LogLevel::information, each);
    const commands::DiagnosisRow* const row = state.diagnosis_row();
    if (!row) return;
    draw_verdict_errors(theme, d, *row);
}

}  // namespace myo::ui::panels
