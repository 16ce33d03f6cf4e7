#include "setup/trial_effects.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "effect/catalogue.hpp"
#include "effect/direction.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::setup {

effect::TrialContext trial_context(const Setup& setup, std::size_t index) {
    const experiment::Experiment& experiment = setup.experiment;
    const PreparedTrial& trial = setup.trials[index];
    effect::TrialContext context;
    // Effects may read geometry and timing, but no measured positions.
    context.body = setup.body;
    context.held = experiment.clamp_box_m;
    context.marker_names = setup.marker_names;
    for (const experiment::MarkerDeclaration& marker : experiment.markers.on_body)
        context.marker_rest_m.push_back(marker.rest_m);
    context.markers = setup.markers.bindings;
    context.actuator_names = actuator_names(experiment);
    context.trial = trial.name;
    context.number = index;
    context.session_time_s = experiment.trials[index].session_time_s;
    context.condition = experiment.trials[index].condition;
    context.start = trial.options.start;
    context.interval_s = sampling_interval_s(trial);
    context.end_s = trial.options.end_s;
    context.hold = trial.hold;
    return context;
}

effect::Affected with_effects(const Setup& setup, std::size_t trial, model::Model model,
                              const std::vector<effect::EffectDeclaration>& effects) {
    effect::Affected affected{std::move(model), setup.trials[trial].options, {}};
    affected.recorded_mount = setup.trials[trial].mount;
    if (effects.empty() && !affected.recorded_mount) return affected;
    effect::apply_effects(trial_context(setup, trial), effects, affected);
    // A hold is an equilibrium and has no times.
    if (setup.trials[trial].hold) return affected;
    // Effects on the clock can shift the last sample beyond the simulated end.
    const double last = measurement::true_times(affected.observation_error,
                                                setup.trials[trial].measured.time_s.tail(1))(0);
    affected.options.end_s = std::max(affected.options.end_s, last + affected.options.h_s);
    return affected;
}

bool changes_observation_only(const effect::EffectDeclaration& effect) {
    const effect::Effect* const entry = effect::find_effect(effect);
    return entry != nullptr && entry->kind == effect::EffectKind::measurement;
}

std::vector<EffectNumber> effect_numbers(const effect::EffectDeclaration& effect, double signal_size) {
    const effect::Effect* const entry = effect::find_effect(effect);
    assert(entry != nullptr);
    std::vector<EffectNumber> numbers;
    for (const effect::EffectParameterEntry& parameter : entry->parameters) {
        // Optional parameters that are absent, and those without a scale, are not fitted.
        const std::vector<std::string> names = effect::fitted_names(effect, parameter);
        if (names.empty()) continue;
        const auto* const v = std::get_if<Eigen::VectorXd>(&effect.parameters.at(parameter.name));
        if (v == nullptr) {
            const double unit = parameter.of_signal ? signal_size : 1.0;
            numbers.push_back({parameter.name, -1, names.front(), unit * parameter.lowest, unit * parameter.highest,
                               unit * parameter.scale, parameter.over_decades});
            continue;
        }
        // A unit vector has two degrees of freedom: two rotation angles about the current direction, free of a
        // singularity.
        const bool turns = parameter.kind == effect::EffectParameterKind::direction;
        const Eigen::Vector3d base = turns ? Eigen::Vector3d(v->normalized()) : Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < names.size(); ++i)
            numbers.push_back({parameter.name, static_cast<int>(i), names[i], parameter.lowest, parameter.highest,
                               parameter.scale, false, base});
    }
    return numbers;
}

double signal_size(const Setup& setup, const effect::EffectDeclaration& effect) {
    // Activations of muscles are not among recorded_commands, so an effect on the signal of a muscle has the size 1.
    const std::string only = effect::has(effect.parameters, "signal") ? effect::text(effect.parameters, "signal") : "";
    const std::vector<std::string> names = actuator_names(setup.experiment);
    double largest = 0.0;
    for (const PreparedTrial& trial : setup.trials)
        for (std::size_t c = 0; c < trial.recorded_commands.size(); ++c) {
            if (!only.empty() && names[setup.experiment.muscles.size() + c] != only) continue;
            for (const double value : trial.recorded_commands[c].values) largest = std::max(largest, std::abs(value));
        }
    return largest > 0.0 ? largest : 1.0;
}

double effect_number(const effect::EffectDeclaration& effect, const std::string& parameter, int component,
                     const Eigen::Vector3d& base) {
    const effect::EffectParameter& value = effect.parameters.at(parameter);
    if (component < 0) return std::get<double>(value);
    const auto& v = std::get<Eigen::VectorXd>(value);
    return base.isZero(0.0) ? v(component) : effect::direction_angles(base, v)(component);
}

void set_effect_number(effect::EffectDeclaration& effect, const std::string& parameter, int component, double value,
                       const Eigen::Vector3d& base) {
    effect::EffectParameter& place = effect.parameters.at(parameter);
    if (component < 0) {
        place = value;
        return;
    }
    auto& v = std::get<Eigen::VectorXd>(place);
    if (base.isZero(0.0)) {
        v(component) = value;
        return;
    }
    // A direction is stored as a unit vector; its two angles are taken from it, changed, and put back.
    Eigen::Vector2d angles = effect::direction_angles(base, v);
    angles(component) = value;
    v = effect::direction_at(base, angles);
}

}  // namespace myo::setup
