#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "report/html_report.hpp"

// Sections of the page about a diagnosis; see diagnosis_report.hpp.

namespace myo::diagnosis {

/// What the page shows at once; the rest is folded away or in the tables.
struct DiagnosisReportPolicy {
    std::size_t estimates = 4;        // of effects, in the summary
    std::size_t trials = 3;           // with their motion open
    std::size_t further_markers = 3;  // of a trial, beside the worst
    std::size_t candidates = 12;      // rows of the table
    std::size_t correlates = 4;       // of a missing force
    std::size_t bars = 16;            // with more markers a table is easier to read
    int lags = 60;                    // of the autocorrelation [samples]
    double least_correlation = 0.5;   // of a correlate that is named in a sentence
    double most_p = 0.01;             // of the same
};
inline constexpr DiagnosisReportPolicy diagnosis_report_policy;

/// "quadratic drag and clamp compliance".
std::string names_of(const std::vector<effect::EffectDeclaration>& effects);
/// "quadratic drag".
std::string name_in_sentence(const std::string& effect_id);
/// How figures and tables call what the verdict stands on: "with quadratic drag", or the best that was tried.
std::string after_words(const Diagnosis& diagnosis);
/// Colour slots of the declared model and of what the verdict stands on, the same on the whole page: bars take them in
/// this order.
inline constexpr int before_colour = 0, after_colour = 1;
/// Whether there are two fits to be set side by side.
bool has_two_fits(const Diagnosis& diagnosis);
/// "0.0312", "3.1 × 10⁻⁹", "< 10⁻¹²".
std::string p_words(double p);

/// A fitted number of an effect as a person reads it.
struct EffectEstimate {
    std::string name;  // "Quadratic drag, coefficient"
    std::string value;
    std::string deviation;  // empty when unknown
    std::string unit;
};
/// All numbers that were fitted of the effects that were tried.
std::vector<EffectEstimate> effect_estimates(const setup::Setup& setup, const JointFit& fit);
/// "903 ± 12 kg/m³".
std::string estimate_words(const EffectEstimate& estimate);
/// "coefficient 903 ± 12 kg/m³, ..." and what is no number, for a cell of a table.
std::string fitted_words(const setup::Setup& setup, const JointFit& fit);

/// Declared and augmented fit side by side.
report::Section parameter_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Errors of trials and markers before and after, in mm and in units of the noise.
report::Section error_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Measured, before and after: in each trial the marker that was worst, and the residual over time.
report::Section motion_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Spectrum, autocorrelation and distribution over the body of what is left of the fit trials.
report::Section residual_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Tests of significance, and the program's own errors.
report::Section significance_section(const setup::Setup& setup, const Diagnosis& diagnosis);
report::Section numerics_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Effects and pairs that were tried.
report::Section candidate_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Effects that the experiment does not tell apart; asserts that there are some.
report::Section confusion_section(const Diagnosis& diagnosis);
report::Section cost_section(const Diagnosis& diagnosis);
/// Asserts that a missing force was sought.
report::Section force_section(const Diagnosis& diagnosis);

}  // namespace myo::diagnosis
