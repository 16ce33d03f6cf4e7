#include <cassert>
#include <cmath>
#include <limits>

#include "base/markup.hpp"
#include "base/text.hpp"
#include "calibration/calibrate.hpp"
#include "calibration/sought_signals.hpp"
#include "chart/svg.hpp"
#include "experiment/actuators.hpp"
#include "report/length.hpp"
#include "results/calibration_report_parts.hpp"
#include "results/finding_output.hpp"
#include "results/optimize_output.hpp"

namespace myo::results {
namespace {

/// How the search ended; empty if it converged after more than one evaluation.
std::string ending(const calibration::Optimization& optimization) {
    if (optimization.stopped) return "The user stopped the search: these are the best signals up to then.";
    if (optimization.fit.log.size() == 1 && optimization.fit.converged())
        return "The target is met from the start: there was nothing to seek.";
    if (!optimization.fit.converged()) return "The search did not converge: " + optimization.fit.message + ".";
    return "";
}

/// Name, quantity and unit of the actuator that a signal drives.
experiment::Actuator actuator_named(const setup::Setup& setup, const std::string& name) {
    return experiment::actuators(setup.experiment)[*experiment::find_actuator(setup.experiment, name)];
}

/// Headline values: error, range of each signal, cost.
std::vector<report::KeyFigure> key_figures(const setup::Setup& setup, const calibration::Optimization& optimization) {
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    std::vector<report::KeyFigure> figures;
    const std::string levels = optimization.miss.goals
                                   ? "distance to the goals"
                                   : readable_number(optimization.miss.noise_levels, 3) + " times the noise";
    figures.push_back({optimization.miss.reached ? "Error (rms)" : "Error (rms): target not reached",
                       report::in_mm(optimization.after.fit_rms_m), "mm",
                       levels + "; was " + report::in_mm(optimization.before.fit_rms_m) + " mm at the start"});
    for (std::size_t s = 0; s < sought.signals.size(); ++s) {
        const auto row = optimization.fit.values.row(static_cast<Eigen::Index>(s));
        const experiment::Actuator actuator = actuator_named(setup, sought.signals[s].name);
        const std::string title = (actuator.kind == experiment::ActuatorKind::muscle
                                       ? "Signal "
                                       : "Signal (" + experiment::quantity_word(actuator.kind) + ") ") +
                                  actuator.name;
        // A pose has one value per signal.
        if (sought.constant)
            figures.push_back({title, readable_number(row(0), 4), actuator.unit, "held at rest"});
        else
            figures.push_back({title, readable_number(row.minCoeff(), 3) + " … " + readable_number(row.maxCoeff(), 3),
                               actuator.unit,
                               std::to_string(row.size()) + " values at " + readable_number(sought.frequency_Hz, 3) +
                                   " Hz" + (sought.hold ? ", held" : "")});
    }
    figures.push_back({"Evaluations", std::to_string(optimization.evaluations()), "",
                       readable_number(optimization.seconds, 3) + " s, " + std::to_string(setup.body->dofs()) +
                           " degrees of freedom"});
    return figures;
}

/// Standard deviation of every actuator's signal at the knots; empty if unknown.
std::vector<fibre::Signal> band_of(const calibration::Optimization& optimization) {
    if (!optimization.deviations.found) return {};
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    const Eigen::MatrixXd& deviations = optimization.deviations.deviations;
    std::vector<fibre::Signal> widths = inverse::commands_of(sought, deviations);
    const std::vector<fibre::Signal> none = inverse::commands_of(
        sought, Eigen::MatrixXd::Zero(deviations.rows(), deviations.cols()));
    // commands_of() is affine in the signals: subtracting its value at zero leaves the linear part.
    for (std::size_t g = 0; g < widths.size(); ++g)
        for (std::size_t k = 0; k < widths[g].values.size(); ++k) widths[g].values[k] -= none[g].values[k];
    return widths;
}

/// Explanation of the band of standard deviations, or why there is none.
std::string band_words(const calibration::Optimization& optimization) {
    const inverse::ActuationDeviations& deviations = optimization.deviations;
    if (!deviations.found) return " Standard deviations were " + deviations.reason + ".";
    return " Bands are one standard deviation: a noise of " + report::in_mm(deviations.noise_m) +
           " mm per coordinate, and what the smoothness may hide of a signal that changes no faster than where it was "
           "seen; values without a band were not measured.";
}

/// Scales of signals other than those of muscles, for the rate; empty if there are none.
std::string scale_words(const setup::Setup& setup, const inverse::SoughtSignals& sought) {
    std::vector<std::string> scales;
    for (const inverse::SoughtSignal& signal : sought.signals)
        if (const experiment::Actuator actuator = actuator_named(setup, signal.name);
            actuator.kind != experiment::ActuatorKind::muscle)
            scales.push_back(signal.name + " " + readable_number(signal.scale, 3) + " " + actuator.unit);
    return scales.empty() ? "" : " over their scales (" + join(scales) + ")";
}

/// What the signals mean.
std::string passive_words(const setup::Setup& setup) {
    std::string words;
    if (!setup.experiment.muscles.empty())
        words =
            "1 is passive; below it a muscle contracts, above it it extends. Muscles that follow another are drawn, "
            "too.";
    if (!setup.experiment.chambers.empty() || !setup.experiment.tendons.empty())
        words += std::string(words.empty() ? "" : " ") + "At 0 chambers and tendons are at rest.";
    return words;
}

/// Signal of one actuator over time, with a band of one standard deviation.
///
/// @param width  standard deviation at the knots; null: unknown
chart::Series signal_series(const std::string& name, const inverse::SoughtSignals& sought, const fibre::Signal& signal,
                            const fibre::Signal* width) {
    chart::Series series{
        name, {}, {}, sought.hold || sought.constant ? chart::SeriesStyle::line : chart::SeriesStyle::line_and_dots};
    for (std::size_t k = 0; k < signal.times_s.size(); ++k) {
        series.x.push_back(std::max(0.0, signal.times_s[k]));
        series.y.push_back(signal.values[k]);
        if (width != nullptr) series.half_width.push_back(std::abs(width->values[k]));
    }
    // A held signal lasts to the end, where it has no knot.
    series.x.push_back(std::max(sought.end_s, series.x.back()));
    series.y.push_back(signal.values.back());
    if (width != nullptr) series.half_width.push_back(series.half_width.back());
    return series;
}

/// Signals of all actuators over time, with bands of one standard deviation; one panel per quantity.
chart::Chart signal_chart(const setup::Setup& setup, const calibration::Optimization& optimization) {
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    const std::vector<fibre::Signal> signals = calibration::found_commands(sought, optimization.fit.values);
    const std::vector<fibre::Signal> widths = band_of(optimization);
    const std::vector<experiment::Actuator> actuators = experiment::actuators(setup.experiment);
    std::vector<chart::Panel> panels;
    for (std::size_t g = 0; g < signals.size(); ++g) {
        const experiment::Actuator& actuator = actuators[g];
        const bool is_muscle = actuator.kind == experiment::ActuatorKind::muscle;
        if (g == 0 || actuator.kind != actuators[g - 1].kind) {
            // Actuators of a kind follow each other.
            panels.push_back({{.label = is_muscle ? "activation a" : experiment::quantity_word(actuator.kind),
                               .unit = actuator.unit},
                              {},
                              220.0});
            panels.back().horizontal.push_back({actuator.rest, "passive"});
        }
        panels.back().series.push_back(
            signal_series(actuator.name, sought, signals[g], widths.empty() ? nullptr : &widths[g]));
    }
    return {"Signals", {.label = "time", .unit = "s"}, std::move(panels)};
}

/// Loss and gradient over the evaluations, logarithmic.
chart::Chart loss_chart(const calibration::Optimization& optimization) {
    chart::Panel loss{{.label = "rms of the loss", .unit = "mm", .logarithmic = true}, {}, 170.0},
        gradient{{.label = "gradient", .unit = "mm²", .logarithmic = true}, {}, 130.0};
    chart::Series each{"evaluation", {}, {}, chart::SeriesStyle::dots},
        best{"best so far", {}, {}, chart::SeriesStyle::line}, norm{"", {}, {}, chart::SeriesStyle::dots};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < optimization.fit.log.size(); ++i) {
        const inverse::ActuationIterate& line = optimization.fit.log[i];
        // The loss is in m^2: its root is an error in mm, comparable with the key figures.
        const double x = static_cast<double>(i + 1), y = line.ok ? 1e3 * std::sqrt(line.loss_m2) : std::nan("");
        // Failed evaluations leave a gap in the dots; the best value so far goes on.
        if (line.ok) least = std::min(least, y);
        each.x.push_back(x), each.y.push_back(y);
        best.x.push_back(x), best.y.push_back(least);
        norm.x.push_back(x), norm.y.push_back(line.ok ? 1e6 * line.gradient_norm_m2 : std::nan(""));
    }
    loss.series = {each, best};
    gradient.series = {norm};
    return {"Loss", {.label = "evaluation"}, {loss, gradient}};
}

/// What became of the quantities of the body.
report::Section body_section(const calibration::Optimization& optimization) {
    report::Table table{"", {{"quantity"}, {"change"}}, {}};
    for (const calibration::FoundItem& found : optimization.found)
        table.rows.push_back({{calibration::readable(found.item)}, {found.change}});
    return {"Body",
            {std::move(table),
             report::Paragraph{"experiment_optimized.toml holds these in place of the declared ones. Uneven changes of "
                               "fibres cost: a turn by one radian over the length of a muscle as much as an error of " +
                               report::in_mm(optimization.problem.design_smoothness_m) + " mm."}}};
}

/// What was sought, how, and at what cost.
std::string summary_sentence(const setup::Setup& setup, const calibration::Optimization& optimization) {
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    const bool signals = !sought.signals.empty(), body = !optimization.found.empty();
    std::string words = signals && body ? "Signals and a body that make the markers "
                        : signals       ? "The actuation that makes the markers "
                                        : "The body that makes the markers ";
    words += (optimization.miss.goals ? "reach the goals of trial " : "follow trial ") + setup.trials.front().name;
    if (signals)
        words += sought.constant
                     ? ": one value of each signal, as the body is at rest"
                     : ": signals with values " + readable_number(1e3 / sought.frequency_Hz, 3) + " ms apart";
    return words + ", found by " + std::to_string(optimization.evaluations()) + " runs with their gradients in " +
           readable_number(optimization.seconds, 3) + " s.";
}

/// The runs as a Calibration, so that the sections of a fit can display the trial.
calibration::Calibration shown_as_fit(const calibration::Optimization& optimization) {
    calibration::Calibration shown;
    shown.before = optimization.before;
    shown.after = optimization.after;
    return shown;
}

}  // namespace

report::HtmlReport optimize_report(const setup::Setup& setup, const calibration::Optimization& optimization,
                                   const RunFacts& facts) {
    assert(optimization.usable());
    const calibration::Calibration shown = shown_as_fit(optimization);
    report::HtmlReport report;
    report.title = setup.experiment.name;
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    report.summary = {summary_sentence(setup, optimization)};
    report.key_figures = key_figures(setup, optimization);
    report.warnings.lines = optimization.warnings;
    report.warnings.lines.insert(report.warnings.lines.end(), setup.warnings.begin(), setup.warnings.end());
    if (const std::string end = ending(optimization); !end.empty())
        report.warnings.lines.insert(report.warnings.lines.begin(), end);
    if (!optimization.found.empty()) report.sections.push_back(body_section(optimization));
    if (!sought.groups.empty())
        report.sections.push_back({"Signals",
                                   {report::Figure{chart::svg(signal_chart(setup, optimization)),
                                                   passive_words(setup) + band_words(optimization)}}});
    report.sections.push_back(trial_section(setup, shown, 0));
    report.sections.push_back(
        {"Search",
         {report::Figure{chart::svg(loss_chart(optimization)),
                         "The loss is the mean square distance of the coordinates plus the square of " +
                             readable_number(1e3 * optimization.problem.smoothness_m_s, 3) +
                             " mm·s times the mean square rate of the signals" + scale_words(setup, sought) +
                             "; its root is shown."}}});
    report.sections.push_back(model_section(setup, shown));
    // Before the model, which embeds the JSON and stays last.
    if (!facts.findings.empty()) report.sections.insert(report.sections.end() - 1, findings_section(facts.findings));
    report.sections.back().blocks.push_back(
        report::EmbeddedJson{"optimize", optimize_json(setup, optimization, facts)});
    report.footer = "Myoloop " + facts.version;
    for (const std::string& word : facts.command)
        report.footer += (&word == &facts.command.front() ? " — " : " ") + word;
    return report;
}

}  // namespace myo::results
