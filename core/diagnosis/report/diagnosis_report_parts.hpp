#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "report/html_report.hpp"

// Sections of the page about a diagnosis; see diagnosis_report.hpp.

namespace myo::diagnosis {

/// Numbers of items that the page shows openly; further ones are folded or in tables.
struct DiagnosisReportPolicy {
    std::size_t estimates = 4;        // of effects, in the summary
    std::size_t trials = 3;           // with their motion unfolded
    std::size_t further_markers = 3;  // of a trial, in addition to the worst
    std::size_t candidates = 12;      // rows of their table
    std::size_t correlates = 4;       // of a missing force
    std::size_t bars = 16;            // of a chart of markers; more markers are shown as a table
    int lags = 60;                    // of the autocorrelation [samples]
    double min_correlation = 0.5;     // smallest of a correlate that the text mentions
    double max_p = 0.01;              // largest of a correlate that the text mentions
    double min_steady = 0.8;  // share of the mean in the squares of a course, above which the text calls it nearly
                              // constant
};
inline constexpr DiagnosisReportPolicy diagnosis_report_policy;

/// Text such as "quadratic drag and clamp compliance".
std::string names_of(const std::vector<effect::EffectDeclaration>& effects);
/// Text such as "quadratic drag".
std::string name_in_sentence(const std::string& effect_id);
/// Name of the verdict's fit in figures and tables: "with quadratic drag", or that of the best attempt.
std::string after_words(const Diagnosis& diagnosis);
/// Colour indices of the declared model and of the verdict's fit, the same on the whole page; bars use them in this
/// order.
enum FitColour : int { before_colour, after_colour };
/// Whether the page compares two fits.
bool has_two_fits(const Diagnosis& diagnosis);
/// P-value as text: "0.0312", "3.1 × 10⁻⁹", "< 10⁻¹²".
std::string p_words(double p);

/// Fitted parameter of an effect in readable form.
struct EffectEstimate {
    std::string name;  // "Quadratic drag, coefficient"
    std::string value;
    std::string deviation;  // empty: unknown
    std::string unit;
};
/// All fitted parameters of the tried effects.
std::vector<EffectEstimate> effect_estimates(const setup::Setup& setup, const JointFit& fit);
/// Text such as "903 ± 12 kg/m³".
std::string estimate_words(const EffectEstimate& estimate);
/// Text such as "coefficient 903 ± 12 kg/m³, ...", including parameters that are not numbers, for a table cell.
std::string fitted_words(const setup::Setup& setup, const JointFit& fit);

/// Parameters of declared and augmented fit side by side.
report::Section parameter_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Errors of trials and markers before and after, in mm and in noise levels.
report::Section error_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Measured motion, simulated before and after: in each trial the worst markers, and the residual over time.
report::Section motion_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Remaining residual of the fit trials: distribution over the body, and spectrum and autocorrelation in the worst
/// trial.
report::Section residual_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Significance tests.
report::Section significance_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Numerical error of mesh and step.
report::Section numerics_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Effects and sets that were tried.
report::Section candidate_section(const setup::Setup& setup, const Diagnosis& diagnosis);
/// Effects that the experiment cannot separate; asserts that there are some.
report::Section confusion_section(const Diagnosis& diagnosis);
/// Time and runs of the phases.
report::Section cost_section(const Diagnosis& diagnosis);
/// Missing force, or the reason why there is none; asserts that it was computed.
report::Section force_section(const Diagnosis& diagnosis);

}  // namespace myo::diagnosis
