#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnose_settings.hpp"
#include "diagnosis/discretisation/numerical_error.hpp"
#include "diagnosis/fit/joint_fit.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "statistics/independence_test.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::diagnosis {

/// Fit with its assessment.
struct JudgedFit {
    JointFit fit;
    double rms_m = 0.0;         // over the fit trials
    double held_out_rms = 0.0;  // [noise levels] each trial predicted from the others (linearised); a single trial:
                                // blocks of time
    double held_out_in_time_rms = 0.0;  // [noise levels] blocks of time of all trials predicted from the others
    int single_trial_directions = 0;    // directions of the parameters that a single trial determines; they keep the
                                        // fitted values when it is held out
    double criterion = 0.0;             // order of fits; lower is better
    double weight = 0.0;                // share of the evidence among all fits
    statistics::ResidualTests tests;
    statistics::IndependenceTest independence;  // computed for residuals that are significant and not large
    std::optional<NumericalError> numerics;     // error of this fit, removed; empty: that of the declared fit was

    bool usable() const { return fit.usable(); }
    /// The systematic residual is measurement drift: uncorrelated between markers.
    bool drifts() const { return independence.is_drift(); }
};

/// Assesses a fit: tests of its residual and prediction of held-out data.
/// A fit that is not usable is returned with default tests.
JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings);

/// Effect that was tried.
struct Candidate {
    EffectScore score;                         // of its best probe
    double adjusted_p = 1.0;                   // of the score, over all probes (Holm)
    std::optional<JudgedFit> judged;           // empty: not fitted
    std::vector<std::string> confounded_with;  // effects that this experiment cannot separate from this one
};

/// What other fits are judged against. Refers to values that outlive it.
struct Baseline {
    const JudgedFit& declared;
    const FitData& data;             // of both fits
    const NumericalError& numerics;  // of the declared fit; applies to fits without one of their own
    const DiagnoseSettings& settings;

    const DiagnosisPolicy& policy() const { return settings.policy; }
};

}  // namespace myo::diagnosis
