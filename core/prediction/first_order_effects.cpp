#include "prediction/first_order_effects.hpp"

#include <utility>

#include "effect/affected_tangent.hpp"
#include "prediction/moved_markers.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::prediction {
namespace {

/// Whether cameras report a motion alike.
bool same_observation(const measurement::ObservationError& a, const measurement::ObservationError& b) {
    return a.mount == b.mount && a.clock_offset_s == b.clock_offset_s && a.rate_error == b.rate_error &&
           a.scale_error == b.scale_error && a.swaps.size() == b.swaps.size() && a.shifts.size() == b.shifts.size() &&
           a.lenses.size() == b.lenses.size() && a.places.size() == b.places.size();
}

ParameterValues with_effect(ParameterValues values, const effect::EffectDeclaration& effect) {
    values.effects.push_back(effect);
    return values;
}

/// Derivative of the model along the whole effect; empty if only a run shows it.
std::optional<sensitivity::ModelTangent> along(const effect::Affected& without, const effect::Affected& with) {
    if (without.options.starts_at_equilibrium() != with.options.starts_at_equilibrium()) return {};
    return effect::affected_tangent(without, without, with, 1.0);
}

/// Adds the change of what cameras see of an unchanged motion; zero where nothing was measured.
void add_change_of_sight(const std::vector<Eigen::Matrix3Xd>& with, const std::vector<Eigen::Matrix3Xd>& without,
                         std::vector<Eigen::Matrix3Xd>& change) {
    for (std::size_t m = 0; m < change.size(); ++m) {
        const Eigen::Matrix3Xd difference = with[m] - without[m];
        change[m] += difference.array().isFinite().select(difference, 0.0).matrix();
    }
}

}  // namespace

std::vector<std::optional<std::vector<Eigen::Matrix3Xd>>> first_order_changes(
    const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
    const std::vector<effect::EffectDeclaration>& effects, const Progress& progress,
    std::shared_ptr<const dynamics::StagePath> warm_start) {
    std::vector<std::optional<std::vector<Eigen::Matrix3Xd>>> changes(effects.size());
    effect::Affected without = affected_trial(setup, trial, values);
    std::vector<sensitivity::ModelTangent> tangents;
    struct Source {
        std::size_t effect = 0;
        bool seen_alike = true;
    };
    std::vector<Source> sources;  // per tangent
    for (std::size_t e = 0; e < effects.size(); ++e) {
        const effect::Affected with = affected_trial(setup, trial, with_effect(values, effects[e]));
        std::optional<sensitivity::ModelTangent> tangent = along(without, with);
        if (!tangent) continue;
        tangents.push_back(std::move(*tangent));
        sources.push_back({e, same_observation(without.observation_error, with.observation_error)});
    }
    if (tangents.empty()) return changes;
    without.options.warm_start = std::move(warm_start);
    const measurement::MarkerSet markers = markers_of(setup, without.observation_error, values);
    const sensitivity::SensitiveTrace run = sensitivity::simulate_with_tangents(without.model, without.options,
                                                                                tangents, markers.nodes, progress);
    if (!run.trace.complete()) return changes;
    const SensitiveMotion motion = sensitive_motion(
        without.observation_error, run, markers,
        motion_times(setup.trials[trial], without.observation_error, values.start_shift_s[trial]));
    const TrialPrediction seen = observe_trial(setup, trial, values, run.trace);
    for (std::size_t row = 0; row < tangents.size(); ++row) {
        std::vector<Eigen::Matrix3Xd> change = moved_tangent(setup, trial, values, motion, row);
        if (!sources[row].seen_alike)
            add_change_of_sight(
                observe_trial(setup, trial, with_effect(values, effects[sources[row].effect]), run.trace).residual_m,
                seen.residual_m, change);
        changes[sources[row].effect] = std::move(change);
    }
    return changes;
}

}  // namespace myo::prediction
