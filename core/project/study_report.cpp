#include "project/study_report.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "dynamics/material_damping.hpp"
#include "project/finding_output.hpp"
#include "project/output_motion.hpp"
#include "project/readable_parameter.hpp"
#include "project/study_report_parts.hpp"
#include "report/length.hpp"
#include "report/markup.hpp"

namespace myo {
namespace {

/// Main frequency of the first trial that vibrates.
double fitted_frequency(const Study& study, const Calibration& calibration) {
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        if (!calibration.after.predictions[t].ok()) continue;
        if (const double f = main_frequency(study, t, calibration.after.predictions[t]); f > 0.0) return f;
    }
    return 0.0;
}

/// "± 0.1 kPa", or why there is none.
std::string deviation_words(const Calibration& calibration, Eigen::Index row, const ReadableEstimate& shown,
                            const std::string& unit) {
    const std::string reason = calibration.undetermined_reason(static_cast<std::size_t>(row));
    if (!reason.empty()) return "not determined: " + reason;
    return shown.deviation.empty() ? "without a standard deviation" : "± " + shown.deviation + " " + unit;
}

KeyFigure modulus_figure(const Calibration& calibration, Eigen::Index row) {
    const ReadableEstimate shown = readable_estimate(
        1e-3 * calibration.fit.values(row), 1e-3 * calibration.deviation(static_cast<std::size_t>(row)));
    return {"Young’s modulus", shown.value, "kPa",
            deviation_words(calibration, row, shown, "kPa") + ", declared " +
                readable_number(1e-3 * calibration.fit.start(row), 4) + " kPa"};
}

/// Describes the damping of the first vibration, which most trials excite.
double damping_factor_of(const Study& study) {
    const bool known = study.integration && study.integration->frequency_Hz > 0.0;
    return known ? study.integration->damping_factor : slender_damping_factor(study.experiment.material.poissons_ratio);
}

KeyFigure damping_figure(const Study& study, const Calibration& calibration, Eigen::Index row) {
    const double damping = calibration.fit.values(row);
    const ReadableEstimate shown = 
        readable_estimate(1e3 * damping, 1e3 * calibration.deviation(static_cast<std::size_t>(row)));
    std::string note = deviation_words(calibration, row, shown, "ms");
    if (const double f = fitted_frequency(study, calibration); f > 0.0)
        note += "; damping ratio " +
                readable_number(damping_ratio(damping_factor_of(study), damping, 2.0 * std::numbers::pi * f), 2) +
                " at " + readable_number(f, 2) + " Hz";
    return {"Damping", shown.value, "ms", note};
}

std::vector<KeyFigure> key_figures(const Study& study, const Calibration& calibration) {
    std::vector<KeyFigure> figures;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        if (calibration.parameters[i].kind == StudyParameter::Kind::youngs_modulus) figures.push_back(modulus_figure(calibration, row));
        if (calibration.parameters[i].kind == StudyParameter::Kind::damping) figures.push_back(damping_figure(study, calibration, row));
    }
    figures.push_back({"Fit error (rms)", in_mm(calibration.after.fit_rms_m), "mm",
                       "was " + length_words(calibration.before.fit_rms_m) + " as declared; noise " + length_words(mean_noise(study)) +
                           (study.experiment.markers.noise_m ? " (declared)" : " (estimated)")});
    if (std::isfinite(calibration.after.validation_rms_m)) {
        const double before = calibration.before.validation_rms_m;
        figures.push_back({"Prediction error (rms)", in_mm(calibration.after.validation_rms_m), "mm",
                           (std::isfinite(before) ? "was " + length_words(before) + "; " : "") + "trials that were not fitted"});
    }
    return figures;
}

/// How the fit ended; empty when it converged and everything was run.
std::string ending(const Calibration& calibration) {
    if (calibration.fit.converged()) return calibration.stopped ? "The user stopped before all trials were predicted." : "";
    if (calibration.stopped) return "The user stopped the fit before it converged: these are the best values up to then.";
    return "The fit did not converge: " + calibration.fit.message;
}

std::string fit_words(const Calibration& calibration) {
    if (calibration.fit.converged()) return "converged";
    return calibration.stopped ? "was stopped" : "did not converge";
}

std::vector<std::string> summary(const Study& study, const Calibration& calibration) {
    int fitted = 0;
    for (const StudyTrial& trial : study.trials) fitted += trial.role == TrialRole::fit ? 1 : 0;
    const int predicted = static_cast<int>(study.trials.size()) - fitted;
    const auto trials = [](int n) { return std::to_string(n) + (n == 1 ? " trial" : " trials"); };
    std::string text = "Calibrated on " + trials(fitted);
    if (predicted > 0) text += "; " + trials(predicted) + (predicted == 1 ? " is" : " are") + " predicted with the result";
    text += ". The fit " + fit_words(calibration) + " after " +
            std::to_string(calibration.evaluations()) + (calibration.evaluations() == 1 ? " evaluation in " : " evaluations in ") + readable_number(calibration.seconds, 3) + " s.";
    std::vector<std::string> lines{text};
    if (!study.experiment.description.empty()) lines.push_back(study.experiment.description);
    return lines;
}

Section parameter_section(const Study& study, const Calibration& calibration) {
    Section section{"Parameters", {parameter_table(study, calibration)}};
    section.blocks.push_back(Paragraph{
        "± is one standard deviation, the root of the sum of the squares of three: by the noise of the markers, "
        "enlarged in proportion where the model leaves more than noise; by the mesh, from the values on a finer or "
        "coarser one; by the time step, from the values with longer steps. A dash is a part that is not known and left "
        "out. It does not cover what the model leaves out."});
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
        if (const std::string reason = calibration.undetermined_reason(i); !reason.empty())
            section.blocks.push_back(Paragraph{readable_parameter(calibration.parameters[i], study).name +
                                               " is not determined: " + reason + "."});
    if (calibration.starts.size() > 1) section.blocks.push_back(Details{"Starts", {starts_table(study, calibration)}});
    if (calibration.parameters.size() < 2) return section;
    Table correlation{"How errors of the parameters go together: 1 and −1 mean that the data tell them apart badly.", {{""}}, {}};
    const auto n = static_cast<Eigen::Index>(calibration.parameters.size());
    for (const StudyParameter& p : calibration.parameters) correlation.columns.push_back({readable_parameter(p, study).name, "", 3});
    for (Eigen::Index i = 0; i < n; ++i) {
        std::vector<Cell> row{readable_parameter(calibration.parameters[static_cast<std::size_t>(i)], study).name};
        for (Eigen::Index j = 0; j < n; ++j) row.emplace_back(std::round(100.0 * calibration.fit.correlation(i, j)) / 100.0);
        correlation.rows.push_back(std::move(row));
    }
    section.blocks.push_back(Details{"Correlation", {correlation}});
    return section;
}

}  // namespace

ReadableEstimate readable_estimate(double value, double deviation) {
    if (!std::isfinite(deviation) || !(deviation > 0.0) || !std::isfinite(value)) return {readable_number(value, 4), ""};
    // Five significant digits of the value are as many as anyone reads; a deviation below them keeps one digit of its own.
    const int meaningful = 1 - static_cast<int>(std::floor(std::log10(deviation)));
    const int readable = value != 0.0 ? 4 - static_cast<int>(std::floor(std::log10(std::abs(value)))) : meaningful;
    const int decimals = std::max(0, std::min(meaningful, readable));
    if (decimals > 6) return {readable_number(value, 5), readable_number(deviation, 2)};
    const bool vanishes = deviation < 0.5 * std::pow(10.0, -decimals);
    return {fixed_decimals(value, decimals), vanishes ? readable_number(deviation, 1) : fixed_decimals(deviation, decimals)};
}

HtmlReport study_report(const Study& study, const Calibration& calibration, const RunFacts& facts) {
    assert(calibration.usable());
    HtmlReport report;
    report.title = study.experiment.name;
    report.summary = summary(study, calibration);
    report.key_figures = key_figures(study, calibration);
    report.warnings.lines = calibration.warnings;
    report.warnings.lines.insert(report.warnings.lines.end(), study.warnings.begin(), study.warnings.end());
    const std::vector<std::string> found = untold(facts.findings);
    report.warnings.lines.insert(report.warnings.lines.begin(), found.begin(), found.end());
    if (const std::string end = ending(calibration); !end.empty()) report.warnings.lines.insert(report.warnings.lines.begin(), end);
    report.sections.push_back({"Trials", {trial_table(study, calibration)}});
    if (!facts.findings.empty()) report.sections.push_back(findings_section(facts.findings));
    report.sections.push_back(parameter_section(study, calibration));
    for (std::size_t t = 0; t < study.trials.size(); ++t) report.sections.push_back(trial_section(study, calibration, t));
    report.sections.push_back(model_section(study, calibration));
    report.sections.back().blocks.push_back(EmbeddedJson{"calibrate", calibrate_json(study, calibration, facts)});
    report.footer = "Myoloop " + facts.version;
    for (const std::string& word : facts.command) report.footer += (&word == &facts.command.front() ? " — " : " ") + word;
    return report;
}

}  // namespace myo
