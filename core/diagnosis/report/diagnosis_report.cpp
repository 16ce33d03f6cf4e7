#include "diagnosis/report/diagnosis_report.hpp"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

#include "base/markup.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "diagnosis/screening/confusion.hpp"
#include "effect/catalogue.hpp"
#include "report/length.hpp"
#include "results/finding_output.hpp"
#include "results/readable_parameter.hpp"
#include "results/robot_tables.hpp"

namespace myo::diagnosis {
namespace {

/// Title of the page: the verdict as a sentence.
std::string headline(const Diagnosis& d) {
    switch (d.verdict.kind) {
        case VerdictKind::none: return "No effect is missing: the declared model is sufficient";
        case VerdictKind::effects: return "Missing from the model: " + names_of(d.verdict.effects);
        case VerdictKind::unknown: break;
    }
    return "An effect is missing that no known effect explains";
}

/// The text with a capital first letter.
std::string capital(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

/// Length as a multiple of the noise of the recordings.
std::string times_noise(double rms_m, const Diagnosis& d) {
    return readable_number(rms_m / d.noise_m, 3) + " times the noise";
}
/// Error of the predicted trials, or of the fitted trials if there are no others.
report::KeyFigure error_figure(const Diagnosis& d) {
    const bool predicted = std::isfinite(d.after.validation_rms_m) || std::isfinite(d.before.validation_rms_m);
    const double before = predicted ? d.before.validation_rms_m : d.before.fit_rms_m,
                 after = predicted ? d.after.validation_rms_m : d.after.fit_rms_m;
    const std::string label = predicted ? "Error on predicted trials" : "Error on fitted trials";
    if (!has_two_fits(d)) return {label, readable_number(1e3 * before, 3), "mm", times_noise(before, d)};
    return {label, report::in_mm(after), "mm",
            times_noise(after, d) + "; before " + report::length_words(before) + ", " + times_noise(before, d)};
}

/// Figures at the top of the page: fitted effects, confidence, error, noise.
std::vector<report::KeyFigure> key_figures(const setup::Setup& setup, const Diagnosis& d) {
    std::vector<report::KeyFigure> figures;
    if (d.verdict.kind == VerdictKind::effects) {
        const std::vector<EffectEstimate> estimates = effect_estimates(setup, d.augmented.fit);
        for (std::size_t i = 0; i < std::min(diagnosis_report_policy.estimates, estimates.size()); ++i) {
            const EffectEstimate& e = estimates[i];
            figures.push_back({e.name, e.value, e.unit,
                               e.deviation.empty() ? "" : "± " + e.deviation + (e.unit.empty() ? "" : " " + e.unit)});
        }
    }
    figures.push_back({"Confidence", readable_number(100.0 * d.verdict.confidence, 2), "%", "in this verdict"});
    figures.push_back(error_figure(d));
    figures.push_back({"Noise", readable_number(1e3 * d.noise_m, 3), "mm", "rms that a correct model would leave"});
    return figures;
}

/// Lines under the title: name and description of the experiment, summaries of the named effects.
std::vector<std::string> summary(const setup::Setup& setup, const Diagnosis& d) {
    std::vector<std::string> lines{setup.experiment.name};
    if (!setup.experiment.description.empty()) lines.push_back(setup.experiment.description);
    for (const effect::EffectDeclaration& effect : d.verdict.effects)
        if (const effect::Effect* entry = effect::find_effect(effect))
            lines.push_back(results::effect_name(effect.id) + ": " + entry->summary + ".");
    return lines;
}

/// Reason of the verdict, with readable names of effects.
std::string reason(const setup::Setup& setup, const Diagnosis& d) {
    if (d.verdict.kind != VerdictKind::effects) return capital(d.verdict.reason);
    std::string text = "With " + names_of(d.verdict.effects) + " the systematic part of the residual falls from " +
                       readable_number(d.declared.tests.systematic.rms, 3) + " to " +
                       readable_number(d.augmented.tests.systematic.rms, 2) + " times the noise. Best value: ";
    text += fitted_words(setup, d.augmented.fit) + ".";
    return text + d.verdict.cautions;
}

/// Reason, change of the error on trials that were not used, and confounded effects.
report::Section verdict_section(const setup::Setup& setup, const Diagnosis& d) {
    report::Section section{"Verdict", {report::Paragraph{reason(setup, d)}}};
    const double before = d.before.validation_rms_m, after = d.after.validation_rms_m;
    if (has_two_fits(d) && std::isfinite(before) && std::isfinite(after))
        section.blocks.push_back(report::Paragraph{
            "On trials that were not used in the search the error " +
            std::string(after < before ? "falls" : "changes") + " from " + report::length_words(before) + " (" +
            times_noise(before, d) + ") to " + report::length_words(after) + " (" + times_noise(after, d) + ")."});
    if (d.verdict.kind == VerdictKind::effects)
        for (const Confusion& c : confusions_of_verdict(d))
            section.blocks.push_back(report::Paragraph{
                is_decided(d, c) ? capital(name_in_sentence(c.first)) + " and " + name_in_sentence(c.second) +
                                       " are similar in this experiment, but the fits decide: see below."
                                 : "This experiment can hardly separate " + name_in_sentence(c.first) + " from " +
                                       name_in_sentence(c.second) + ": see below."});
    return section;
}

}  // namespace

report::HtmlReport diagnosis_report(const setup::Setup& setup, const Diagnosis& d, const results::RunFacts& facts) {
    assert(d.complete());
    report::HtmlReport report;
    report.title = headline(d);
    report.summary = summary(setup, d);
    report.key_figures = key_figures(setup, d);
    report.warnings.lines = setup.warnings;
    report.warnings.lines.insert(report.warnings.lines.end(), d.notes.begin(), d.notes.end());
    if (!d.before.ok()) report.warnings.lines.push_back("With the declared model: " + d.before.failure);
    if (has_two_fits(d) && !d.after.ok()) report.warnings.lines.push_back("After: " + d.after.failure);
    report.sections.push_back(verdict_section(setup, d));
    if (d.missing_force) report.sections.push_back(force_section(d));
    report.sections.push_back(parameter_section(setup, d));
    report.sections.push_back(error_section(setup, d));
    report.sections.push_back(motion_section(setup, d));
    if (!facts.findings.empty()) report.sections.push_back(results::findings_section(facts.findings));
    report.sections.push_back(residual_section(setup, d));
    report.sections.push_back(significance_section(setup, d));
    report.sections.push_back(numerics_section(setup, d));
    if (!d.candidates.empty()) report.sections.push_back(candidate_section(setup, d));
    if (!d.confusions.empty()) report.sections.push_back(confusion_section(d));
    if (std::vector<report::Block> robot = results::robot_tables(setup, d.augmented.fit.values); !robot.empty())
        report.sections.push_back({"Robot", std::move(robot)});
    report.sections.push_back(cost_section(d));
    const std::string folder = std::filesystem::weakly_canonical(setup.experiment.folder).filename().string();
    report.sections.back().blocks.push_back(report::EmbeddedJson{"diagnose", diagnosis_json(setup, d, folder)});
    report.footer = "Myoloop " + facts.version;
    // The command line, so that the page states how to repeat it.
    for (const std::string& word : facts.command)
        report.footer += (&word == &facts.command.front() ? " — " : " ") + word;
    return report;
}

}  // namespace myo::diagnosis
