#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "diagnosis/fit/joint_fit.hpp"
#include "statistics/score_test.hpp"

namespace myo::diagnosis {

/// What one probe of an effect says of a residual, before anything is fitted.
struct EffectScore {
    /// Where a fit may start.
    struct Start {
        effect::EffectParameters effect;
        Eigen::VectorXd step;  // of the fit's own parameters, that goes with it
    };

    std::string id;
    Start best;  // explains the residual best to first order
    effect::EffectParameters
        probed;  // of one number: what was run, for a fit that finds the best one beyond what is linear; else empty
    statistics::ProjectedCandidate candidate;
    statistics::ScoreTest test;  // explained: of the residual, with all numbers within their bounds
    double left = std::numeric_limits<double>::infinity();  // squares of the residual that it would leave
    std::vector<Start>
        nonlinear;              // where the probe goes beyond the residual: starts from which a fit has to find its way
    Eigen::VectorXd predicted;  // N: the part of the residual it would take away
    double seconds = 0.0;       // its runs took, added up
    std::string failure;        // why it could not be tried; empty when it was

    /// Explained share of the residual, by which scores are ordered; -1 if the effect could not be tried.
    double share() const { return usable() ? test.explained : -1.0; }
    bool usable() const { return failure.empty() && candidate.rank() > 0 && test.explained > 0.0; }
};

/// Whether an effect is among those that may be named.
using EffectFilter = std::function<bool(const std::string& id)>;

/// Which probes: the small ones, from which most is straight, or the large ones of what goes with the square of its
/// amount.
enum class ProbeSize { small, large };

/// Scores every probe of every effect on a fit's residual, its own parameters projected out.
///
/// One run per column and trial, on the setup's threads side by side. A probe whose best amount has the wrong sign
/// explains nothing. unaffected: predictions of data.trials with the fit's values, which those with a probe are
/// compared with. They, and the setup, may have longer steps than the fit: what an effect does needs to be known to
/// some percent only. Progress counts runs.
std::vector<EffectScore> score_effects(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                                       const std::vector<prediction::TrialPrediction>& unaffected,
                                       const EffectFilter& allowed, ProbeSize size, const Progress& progress);

/// What effects may know of the experiment with a fit's values.
effect::EffectSearch effect_search(const setup::Setup& setup, const FitData& data,
                                   const prediction::ParameterValues& values);

}  // namespace myo::diagnosis
