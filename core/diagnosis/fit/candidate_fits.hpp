#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "diagnosis/selection/judged_fit.hpp"

namespace myo::diagnosis {

/// Start of a candidate fit.
struct CandidateStart {
    effect::EffectDeclaration effect;
    Eigen::VectorXd step;              // increment of the base fit's parameters; empty: none
    bool nonlinear = false;            // start beyond the linear range: more evaluations before the fit may be pruned
    double predicted_reduction = 0.0;  // predicted share of the squared residual that the effect removes
    effect::EffectParameters safe;     // parameters of the probe, the fallback start; empty: none
};
/// Start at the amount that the score predicts.
/// The prediction is linear; nonlinear_starts() are for effects beyond its range.
CandidateStart start_of(const EffectScore& score);
/// Starts beyond the linear range: those of the best probe of each effect that `wanted` accepts.
std::vector<CandidateStart> nonlinear_starts(const std::vector<EffectScore>& scores,
                                             const std::function<bool(const EffectScore&)>& wanted);

/// Input of fit_candidates(). Refers to values that outlive the fits.
struct CandidateFitInput {
    const setup::Setup& setup;
    const FitData& data;
    const DiagnoseSettings& settings;
    const JointFit& base;  // to whose effects a candidate is added, and to whose values the starts' steps refer
    const std::vector<CandidateStart>& starts;
    double least_so_far = 0.0;    // smallest squared residual of the candidates fitted before
    double pruning_factor = 1.0;  // see fits_worth_continuing()
    std::string phase;            // under which the fits are logged
};

/// Fits candidate effects added to the effects of a base fit: first the amount of each effect, then all parameters of
/// the candidates that are not pruned, best first.
///
/// Fits found in the store are evaluated only.
///
/// @return  in the order of the starts; not usable where the fit failed
std::vector<JudgedFit> fit_candidates(const CandidateFitInput& in, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
