#pragma once

#include <optional>
#include <vector>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"

namespace myo::diagnosis {

/// Scores of all effects that may be named, before any is fitted.
struct Screening {
    /// Fit whose residual was scored, from which candidates are fitted: the declared fit with its distorted parameters
    /// reset, see debiased_start(). Empty: the declared fit itself.
    std::optional<JointFit> debiased;
    std::vector<EffectScore> scores;  // of all probes; empty if cancelled

    const JointFit& base(const DiagnosisContext& context) const { return debiased ? *debiased : context.declared.fit; }
};

/// Scores all effects by small probes. If the declared fit has distorted parameters, from the fit with these reset,
/// unless the best effect leaves less from the declared fit itself.
Screening screen_effects(const DiagnosisContext& context, FitStore& store, PhaseLog& log);

/// Scores of the effects that may be named on the residual of a fit with the shift of `data`, except those of
/// `without`. Empty if cancelled.
std::vector<EffectScore> scores_from(const DiagnosisContext& context, const FitData& data, const JointFit& base,
                                     ProbeSize size, const PhaseLog& log, const std::vector<std::string>& without = {});

/// Each effect once, with its best probe. P-values are adjusted over all probes by Holm's rule.
std::vector<Candidate> listed_candidates(const std::vector<EffectScore>& scores);

}  // namespace myo::diagnosis
