#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/fit_data.hpp"
#include "effect/effect.hpp"

namespace myo::diagnosis {

/// Runs to which effects are added. Refers to values that outlive the call.
struct UnaffectedRuns {
    const setup::Setup& setup;
    const diagnosis::FitData& data;
    const prediction::ParameterValues& values;
    const effect::EffectSearch& search;                           // of data.trials
    const std::vector<prediction::TrialPrediction>& predictions;  // of data.trials with these values, traces included
};

/// Change of the flat residual by an effect.
struct EffectResponse {
    Eigen::VectorXd change;  // N [noise levels]; empty if it could not be run
    std::string failure;     // then the reason
    double seconds = 0.0;    // of its runs
};

/// Responses to each effect by itself, in parallel on the setup's threads. Empty if cancelled.
///
/// @param first_order  small responses are found to first order in the effect, at a fraction of the cost of a run (see
///                     prediction::first_order_changes()); others, and what has no first order, by runs with the whole
///                     effect. Empty: all by runs
/// @param task         name under which runs are reported
std::vector<EffectResponse> effect_responses(const UnaffectedRuns& runs,
                                             const std::vector<effect::EffectDeclaration>& effects,
                                             const std::optional<FirstOrderPolicy>& first_order,
                                             const std::string& task, const Progress& progress);

}  // namespace myo::diagnosis
