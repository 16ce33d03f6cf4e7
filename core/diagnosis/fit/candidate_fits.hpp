#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/effect_scores.hpp"

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
CandidateStart start_of(const EffectScore& score);
/// Starts beyond the linear range: those of the best probe of each effect that `wanted` accepts.
std::vector<CandidateStart> nonlinear_starts(const std::vector<EffectScore>& scores,
                                             const std::function<bool(const EffectScore&)>& wanted);

/// Common inputs of candidate fits.
struct CandidateFitting {
    const setup::Setup& setup;
    const setup::Setup& serial;  // same setup with one thread per fit, for fits in parallel
    const FitData& data;
    const DiagnoseSettings& settings;
    FitStore& store;
};

/// Result of fit_candidates().
struct CandidateFits {
    std::vector<JudgedFit> fits;  // in the order of the starts; not usable if the fit failed
    int runs = 0;                 // approximate number of model runs
};

/// Fits candidate effects added to the effects of a base fit: first the amount of each effect, then all parameters of
/// the candidates that are not pruned, best first.
///
/// @param base            fit whose values the starts' steps refer to
/// @param least_so_far    smallest squared residual of the candidates fitted before
/// @param pruning_factor  a fit continues only if its squared residual, or the one that its Jacobian predicts, is below
///                        this multiple of the smallest; the limit is higher while the smallest is far above the noise,
///                        and for candidates with a comparable predicted reduction
/// @param name            name of the phase, for progress
CandidateFits fit_candidates(const CandidateFitting& fitting, const JointFit& base,
                             const std::vector<CandidateStart>& starts, double least_so_far, double pruning_factor,
                             const std::string& name, const Progress& progress);

}  // namespace myo::diagnosis
