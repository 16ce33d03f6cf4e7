#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/diagnosis_policy.hpp"

namespace myo::diagnosis {

/// What the rules of the verdict look at.
struct VerdictEvidence {
    const Diagnosis& diagnosis;
    const DiagnosisPolicy& policy;      // of the diagnosis
    const JudgedFit* single = nullptr;  // of the most credible candidate; null: none was fitted
    const JudgedFit* pair = nullptr;    // the best one whose parameters other trials test; null: none
};
VerdictEvidence verdict_evidence(const Diagnosis& diagnosis);

/// A verdict without its ranking, and the fit that it rests on.
struct Conclusion {
    Verdict verdict;
    JudgedFit fit;
};

struct VerdictRule {
    std::string name;
    bool (*applies)(const VerdictEvidence& evidence);
    Conclusion (*conclude)(const VerdictEvidence& evidence);
};

/// In the order in which they are tried: the first that applies gives the verdict. The last one always applies.
///
///   drift            significant, but uncorrelated between markers: none, the measurement drifts
///   nothing_missing  no test is significant, or the residual is below the program's own error: none
///   single_effect    one effect explains the residual
///   pair             two effects do, and the second is needed
///   nearly_all       one effect removes all but an eighth of the systematic residual
///   most_by_pair     the noise was not declared, and two effects remove most of the residual
///   most_by_single   the same by one effect
///   faint            a residual that another simulator of the same model may leave: none
///   unexplained      unknown
const std::vector<VerdictRule>& verdict_rules();

/// "quadratic_drag (coefficient_kg_m3 = 910) and cable_tug (...)". Asserts that there is an effect.
std::string effects_in_words(const std::vector<effect::EffectDeclaration>& effects);

/// How far the systematic residual falls with a fit's effects, in a sentence.
std::string systematic_fall(const JudgedFit& fit, const JudgedFit& declared);

/// "2.31 times the noise".
std::string times_noise(double rms);

/// Whether the parameters of two effects rest on one trial alone, which no other trial tests. A single effect is tested
/// by the residual itself, and one that acts in one trial cannot be tested by others.
bool is_untested(const JudgedFit& pair, const JudgedFit& declared);

}  // namespace myo::diagnosis
