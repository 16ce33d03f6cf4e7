#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/effect_scores.hpp"

namespace myo::diagnosis {

/// Where a candidate's fit starts.
struct CandidateStart {
    effect::EffectDeclaration effect;
    Eigen::VectorXd step;    // of the base's own parameters; empty: none
    bool nonlinear = false;  // the way from there is not straight: it takes more evaluations before hope is lost
    double predicted_reduction = 0.0;  // share of the residual that its score says it takes away
    effect::EffectParameters safe;  // of the effect, where the fit starts from when all else goes wrong; empty: nowhere
};
CandidateStart start_of(const EffectScore& score);
/// Starts beyond the range of linear response: those of the best probe of each wanted effect.
std::vector<CandidateStart> nonlinear_starts(const std::vector<EffectScore>& scores,
                                             const std::function<bool(const EffectScore&)>& wanted);

/// What fits of candidates share.
struct CandidateFitting {
    const setup::Setup& setup;
    const setup::Setup& serial;  // the same, whose fits run on one thread each, side by side
    const FitData& data;
    const DiagnoseSettings& settings;
    FitStore& store;
};

struct CandidateFits {
    std::vector<JudgedFit> fits;  // in the order of the starts; unusable where they failed
    int runs = 0;                 // of the model, about
};

/// Fits of these starts beside a fit's effects: how much of each at first, then the hopeful ones with all their
/// numbers, the best first.
///
/// @param base        where the starts' steps begin
/// @param least_so_far   squares that other candidates are known to leave
/// @param hope        those go on that leave at most so many times the least squares
/// @param name        of the stage, for progress
CandidateFits fit_candidates(const CandidateFitting& fitting, const JointFit& base,
                             const std::vector<CandidateStart>& starts, double least_so_far, double pruning_factor,
                             const std::string& name, const Progress& progress);

}  // namespace myo::diagnosis
