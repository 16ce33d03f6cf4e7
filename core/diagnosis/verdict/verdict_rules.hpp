#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/diagnosis_policy.hpp"

namespace myo::diagnosis {

/// Input of the verdict rules.
struct VerdictEvidence {
    const Diagnosis& diagnosis;
    const DiagnosisPolicy& policy;      // of the diagnosis
    const JudgedFit* single = nullptr;  // fit of the most credible candidate; null: none was fitted
    const JudgedFit* set = nullptr;     // best set, if other trials test its parameters; otherwise null
};
/// Evidence of a diagnosis whose candidates and sets are ordered.
VerdictEvidence verdict_evidence(const Diagnosis& diagnosis);

/// Verdict without its ranking, and the fit that it rests on.
struct Conclusion {
    Verdict verdict;
    JudgedFit fit;
};

/// Rule of the verdict: a condition, and the conclusion if it holds.
struct VerdictRule {
    std::string name;
    // Called in order; a rule may assume that all earlier ones do not apply.
    bool (*applies)(const VerdictEvidence& evidence);
    Conclusion (*conclude)(const VerdictEvidence& evidence);
};

/// Rules in the order in which they are tried: the first one that applies gives the verdict. The last one always
/// applies.
///
///   drift            significant, but uncorrelated between markers: `none`, the measurement drifts
///   nothing_missing  not significant, or below the numerical allowance: `none`
///   single_effect    one effect explains the residual
///   set              several effects explain it, and the best of them alone does not
///   nearly_all       one effect removes all but an eighth of the systematic residual
///   most_by_set      the noise was not declared, and several effects remove most of the residual
///   most_by_single   the noise was not declared, and one effect removes most of the residual
///   faint            small enough to be the difference between two simulators of the same model: `none`
///   unexplained      otherwise: `unknown`
const std::vector<VerdictRule>& verdict_rules();

/// Text such as "quadratic_drag (coefficient_kg_m3 = 910) and cable_tug (...)". Asserts that there is an effect.
std::string effects_in_words(const std::vector<effect::EffectDeclaration>& effects);

/// Sentence about the fall of the systematic residual with the effects of a fit.
std::string systematic_fall(const JudgedFit& fit, const JudgedFit& declared);

/// Text such as "2.31 times the noise".
std::string times_noise(double rms);

}  // namespace myo::diagnosis
