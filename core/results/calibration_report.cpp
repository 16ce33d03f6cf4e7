#include "results/calibration_report.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "base/markup.hpp"
#include "dynamics/material_damping.hpp"
#include "report/length.hpp"
#include "results/calibration_report_parts.hpp"
#include "results/finding_output.hpp"
#include "results/marker_places.hpp"
#include "results/output_motion.hpp"
#include "results/readable_parameter.hpp"
#include "results/robot_tables.hpp"

namespace myo::results {
namespace {

/// Main frequency of the first trial that vibrates [Hz]; 0 if none does.
double fitted_frequency(const setup::Setup& setup, const calibration::Calibration& calibration) {
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        if (!calibration.after.predictions[t].ok()) continue;
        if (const double f = main_frequency(setup, t, calibration.after.predictions[t]); f > 0.0) return f;
    }
    return 0.0;
}

/// "± 0.1 kPa", or the reason why there is no standard deviation.
std::string deviation_words(const calibration::Calibration& calibration, Eigen::Index row,
                            const ReadableEstimate& shown, const std::string& unit) {
    const std::string reason = calibration.undetermined_reason(static_cast<std::size_t>(row));
    if (!reason.empty()) return "not determined: " + reason;
    return shown.deviation.empty() ? "without a standard deviation" : "± " + shown.deviation + " " + unit;
}

/// Fitted modulus in kPa with its standard deviation and the declared value.
report::KeyFigure modulus_figure(const calibration::Calibration& calibration, Eigen::Index row) {
    const ReadableEstimate shown = readable_estimate(1e-3 * calibration.fit.values(row),
                                                     1e-3 * calibration.deviation(static_cast<std::size_t>(row)));
    return {"Young's modulus", shown.value, "kPa",
            deviation_words(calibration, row, shown, "kPa") + ", declared " +
                readable_number(1e-3 * calibration.fit.start(row), 4) + " kPa"};
}

/// Factor between damping time and damping ratio in the first vibration, which most trials excite; of a slender body if
/// the mode was not computed.
double damping_factor_of(const setup::Setup& setup) {
    const bool known = setup.integration && setup.integration->frequency_Hz > 0.0;
    return known ? setup.integration->damping_factor
                 : dynamics::slender_damping_factor(setup.experiment.material.poissons_ratio);
}

/// Damping time in ms with the damping ratio at the main frequency of the fitted motion.
report::KeyFigure damping_figure(const setup::Setup& setup, const calibration::Calibration& calibration,
                                 Eigen::Index row) {
    const double damping = calibration.fit.values(row);
    const ReadableEstimate shown = readable_estimate(1e3 * damping,
                                                     1e3 * calibration.deviation(static_cast<std::size_t>(row)));
    std::string note = deviation_words(calibration, row, shown, "ms");
    if (const double f = fitted_frequency(setup, calibration); f > 0.0)
        note += "; damping ratio " +
                readable_number(dynamics::damping_ratio(damping_factor_of(setup), damping, 2.0 * std::numbers::pi * f),
                                2) +
                " at " + readable_number(f, 2) + " Hz";
    return {"Damping", shown.value, "ms", note};
}

/// Headline values: modulus, damping, error of the fit, error of the prediction.
std::vector<report::KeyFigure> key_figures(const setup::Setup& setup, const calibration::Calibration& calibration) {
    std::vector<report::KeyFigure> figures;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        // Other fitted parameters are in the table; these two are what most readers look for.
        if (calibration.parameters[i].kind == prediction::ModelParameter::Kind::youngs_modulus)
            figures.push_back(modulus_figure(calibration, row));
        if (calibration.parameters[i].kind == prediction::ModelParameter::Kind::damping)
            figures.push_back(damping_figure(setup, calibration, row));
    }
    figures.push_back({"Fit error (rms)", report::in_mm(calibration.after.fit_rms_m), "mm",
                       "was " + report::length_words(calibration.before.fit_rms_m) + " as declared; noise " +
                           report::length_words(setup::mean_noise(setup)) +
                           (setup.experiment.markers.noise_m ? " (declared)" : " (estimated)")});
    // NaN if no trial was predicted, or none completed.
    if (std::isfinite(calibration.after.validation_rms_m)) {
        const double before = calibration.before.validation_rms_m;
        figures.push_back({"Prediction error (rms)", report::in_mm(calibration.after.validation_rms_m), "mm",
                           (std::isfinite(before) ? "was " + report::length_words(before) + "; " : "") +
                               "trials that were not fitted"});
    }
    return figures;
}

/// How the fit ended; empty if it converged and all trials were run.
std::string ending(const calibration::Calibration& calibration) {
    if (calibration.fit.converged())
        return calibration.stopped ? "The user stopped before all trials were predicted." : "";
    if (calibration.stopped)
        return "The user stopped the fit before it converged: these are the best values up to then.";
    return "The fit did not converge: " + calibration.fit.message;
}

/// How the fit ended, for the summary sentence.
std::string fit_words(const calibration::Calibration& calibration) {
    if (calibration.fit.converged()) return "converged";
    return calibration.stopped ? "was stopped" : "did not converge";
}

/// One sentence on trials, convergence and cost, and the description of the experiment.
std::vector<std::string> summary(const setup::Setup& setup, const calibration::Calibration& calibration) {
    int fitted = 0;
    for (const setup::PreparedTrial& trial : setup.trials) fitted += trial.role == experiment::TrialRole::fit ? 1 : 0;
    // Trials without a recording are counted as predicted, too.
    const int predicted = static_cast<int>(setup.trials.size()) - fitted;
    const auto trials = [](int n) { return std::to_string(n) + (n == 1 ? " trial" : " trials"); };
    std::string text = "Calibrated on " + trials(fitted);
    if (predicted > 0)
        text += "; " + trials(predicted) + (predicted == 1 ? " is" : " are") + " predicted with the result";
    text += ". The fit " + fit_words(calibration) + " after " + std::to_string(calibration.evaluations()) +
            (calibration.evaluations() == 1 ? " evaluation in " : " evaluations in ") +
            readable_number(calibration.seconds, 3) + " s.";
    std::vector<std::string> lines{text};
    if (!setup.experiment.description.empty()) lines.push_back(setup.experiment.description);
    return lines;
}

/// Parameters with standard deviations, reasons for undetermined ones, starts and correlation.
report::Section parameter_section(const setup::Setup& setup, const calibration::Calibration& calibration) {
    report::Section section{"Parameters", {parameter_table(setup, calibration)}};
    section.blocks.push_back(report::Paragraph{
        "± is one standard deviation, the root of the sum of the squares of three: by the noise of the markers, "
        "enlarged in proportion where the model leaves more than noise; by the mesh, from the values on a finer or "
        "coarser one; by the time step, from the values with longer steps. A dash is a part that is not known and left "
        "out. It does not cover what the model leaves out."});
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
        if (const std::string reason = calibration.undetermined_reason(i); !reason.empty())
            section.blocks.push_back(report::Paragraph{readable_parameter(calibration.parameters[i], setup).name +
                                                       " is not determined: " + reason + "."});
    // A fit from one start has nothing to compare.
    if (calibration.starts.size() > 1)
        section.blocks.push_back(report::Details{"Starts", {starts_table(setup, calibration)}});
    // A single parameter has no correlation.
    if (calibration.parameters.size() < 2) return section;
    report::Table correlation{
        "How errors of the parameters go together: 1 and −1 mean that the data hardly separate them.", {{""}}, {}};
    const auto n = static_cast<Eigen::Index>(calibration.parameters.size());
    for (const prediction::ModelParameter& p : calibration.parameters)
        correlation.columns.push_back({readable_parameter(p, setup).name, "", 3});
    for (Eigen::Index i = 0; i < n; ++i) {
        std::vector<report::Cell> row{
            readable_parameter(calibration.parameters[static_cast<std::size_t>(i)], setup).name};
        for (Eigen::Index j = 0; j < n; ++j)
            // Two decimals: a correlation has no more meaning.
            row.emplace_back(std::round(100.0 * calibration.fit.correlation(i, j)) / 100.0);
        correlation.rows.push_back(std::move(row));
    }
    section.blocks.push_back(report::Details{"Correlation", {correlation}});
    return section;
}

}  // namespace

ReadableEstimate readable_estimate(double value, double deviation) {
    if (!std::isfinite(deviation) || !(deviation > 0.0) || !std::isfinite(value))
        return {readable_number(value, 4), ""};
    // Two significant digits of the deviation determine the decimals, but the value has at most five significant
    // digits; a deviation below its last digit keeps one digit of its own.
    const int meaningful = 1 - static_cast<int>(std::floor(std::log10(deviation)));
    const int readable = value != 0.0 ? 4 - static_cast<int>(std::floor(std::log10(std::abs(value)))) : meaningful;
    const int decimals = std::max(0, std::min(meaningful, readable));
    // Values far below the unit that is shown are readable only with a power of ten.
    if (decimals > 6) return {readable_number(value, 5), readable_number(deviation, 2)};
    const bool vanishes = deviation < 0.5 * std::pow(10.0, -decimals);
    return {fixed_decimals(value, decimals),
            vanishes ? readable_number(deviation, 1) : fixed_decimals(deviation, decimals)};
}

report::HtmlReport calibration_report(const setup::Setup& setup, const calibration::Calibration& calibration,
                                      const RunFacts& facts) {
    assert(calibration.usable());
    report::HtmlReport report;
    report.title = setup.experiment.name;
    report.summary = summary(setup, calibration);
    report.key_figures = key_figures(setup, calibration);
    report.warnings.lines = calibration.warnings;
    report.warnings.lines.insert(report.warnings.lines.end(), setup.warnings.begin(), setup.warnings.end());
    // Order of the warnings: how the fit ended, findings of checks, calibration, setup.
    const std::vector<std::string> found = sentences_to_report(facts.findings);
    report.warnings.lines.insert(report.warnings.lines.begin(), found.begin(), found.end());
    if (const std::string end = ending(calibration); !end.empty())
        report.warnings.lines.insert(report.warnings.lines.begin(), end);
    // Order of the sections: results first, details of the model last.
    report.sections.push_back({"Trials", {trial_table(setup, calibration)}});
    if (report::Table sensors = sensor_table(setup, calibration.before, &calibration.after); !sensors.rows.empty())
        report.sections.back().blocks.emplace_back(std::move(sensors));
    if (!facts.findings.empty()) report.sections.push_back(findings_section(facts.findings));
    report.sections.push_back(parameter_section(setup, calibration));
    if (!calibration.places.empty())
        report.sections.push_back(places_section(calibration.places, setup.experiment.markers.placement_m));
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        report.sections.push_back(trial_section(setup, calibration, t));
    report.sections.push_back(model_section(setup, calibration));
    report.sections.back().blocks.push_back(
        report::EmbeddedJson{"calibrate", calibrate_json(setup, calibration, facts)});
    report.footer = "Myoloop " + facts.version;
    for (const std::string& word : facts.command)
        report.footer += (&word == &facts.command.front() ? " — " : " ") + word;
    return report;
}

}  // namespace myo::results
