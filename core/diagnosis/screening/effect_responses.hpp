#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/progress.hpp"
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
/// The change is that by the whole amount of the declaration, not a derivative.
///
/// @param task  name under which runs are reported
std::vector<EffectResponse> effect_responses(const UnaffectedRuns& runs,
                                             const std::vector<effect::EffectDeclaration>& effects,
                                             const std::string& task, const Progress& progress);

}  // namespace myo::diagnosis
