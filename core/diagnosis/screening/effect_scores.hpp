#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/joint_fit.hpp"
#include "statistics/score_test.hpp"

namespace myo::diagnosis {

/// Score of one probe of an effect on a residual, before any fit.
struct EffectScore {
    /// Start values of a fit.
    struct Start {
        effect::EffectParameters effect;
        Eigen::VectorXd step;  // of the fit's own parameters, belongs to this amount
    };

    std::string id;
    effect::LawPointer law{};  // see effect::EffectDeclaration
    Start best;                // best explanation of the residual to first order
    /// Parameters of the probe that was run, start of a fit beyond the linear range; empty for several columns.
    effect::EffectParameters probed;
    statistics::ProjectedCandidate candidate;
    statistics::ScoreTest test;  // explained: share of the squared residual, with all parameters within their bounds
    double left = std::numeric_limits<double>::infinity();  // remaining squared residual
    /// Starts for a nonlinear fit, if the response of the probe far exceeds the residual.
    std::vector<Start> nonlinear;
    Eigen::VectorXd predicted;  // N: part of the residual that the effect would remove
    double seconds = 0.0;       // sum over its runs
    std::string failure;        // reason why it could not be tried; empty: none

    /// Explained share of the squared residual, by which scores are ordered; -1 if not usable.
    double share() const { return usable() ? test.explained : -1.0; }
    bool usable() const { return failure.empty() && candidate.rank() > 0 && test.explained > 0.0; }
};

/// True for effects that may be named.
using EffectFilter = std::function<bool(const std::string& id)>;

/// Probes with small amounts (linear response), or with large ones for effects of quadratic response.
enum class ProbeSize { small, large };

/// Scores every probe of every allowed effect on the residual of a fit, with the fit's own parameters projected out.
///
/// At most one run per column and trial, in parallel on the setup's threads. A probe whose best amount has the wrong
/// sign explains nothing. Progress counts runs. Empty if cancelled.
/// @param unaffected  predictions of data.trials by this setup with the fit's values, reference of the probes. The
///                    steps of the setup may be longer than those of the fit: responses are needed to a few percent
///                    only
std::vector<EffectScore> score_effects(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                                       const std::vector<prediction::TrialPrediction>& unaffected,
                                       const EffectFilter& allowed, ProbeSize size, const ScreeningPolicy& policy,
                                       const Progress& progress);

/// Data of the experiment and models with the values of a fit, for the choice of probes.
effect::EffectSearch effect_search(const setup::Setup& setup, const FitData& data,
                                   const prediction::ParameterValues& values);

}  // namespace myo::diagnosis
