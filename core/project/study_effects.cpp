#include "project/study_effects.hpp"

#include <algorithm>
#include <cassert>

#include "effect/catalogue.hpp"
#include "effect/direction.hpp"

namespace myo {

EffectSite effect_site(const Study& study, std::size_t index) {
    const Experiment& experiment = study.experiment;
    const StudyTrial& trial = study.trials[index];
    EffectSite site;
    site.body = study.body;
    site.held = experiment.clamp_box_m;
    site.marker_names = study.marker_names;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) site.marker_rest_m.push_back(marker.rest_m);
    site.markers = study.markers.bindings;
    for (const MuscleDeclaration& muscle : experiment.muscles) site.muscle_names.push_back(muscle.name);
    site.trial = trial.name;
    site.session_time_s = experiment.trials[index].session_time_s;
    site.start = trial.options.start;
    site.interval_s = sampling_interval_s(trial);
    site.end_s = trial.options.end_s;
    return site;
}

Affected with_effects(const Study& study, std::size_t trial, Model model, const std::vector<EffectDeclaration>& effects) {
    Affected affected{std::move(model), study.trials[trial].options, {}};
    if (effects.empty()) return affected;
    apply_effects(effect_site(study, trial), effects, affected);
    const double last = true_times(affected.seen, study.trials[trial].measured.time_s.tail(1))(0);
    affected.options.end_s = std::max(affected.options.end_s, last + affected.options.h_s);
    return affected;
}

bool is_seen_only(const EffectDeclaration& effect) {
    const Effect* const entry = find_effect(effect.id);
    return entry != nullptr && entry->stage == EffectStage::measurement;
}

std::vector<EffectNumber> effect_numbers(const EffectDeclaration& effect) {
    const Effect* const entry = find_effect(effect.id);
    assert(entry != nullptr);
    std::vector<EffectNumber> numbers;
    for (const EffectParameterEntry& parameter : entry->parameters) {
        const auto found = effect.parameters.find(parameter.name);
        if (found == effect.parameters.end() || !(parameter.scale > 0.0)) continue;
        const std::string name = "effect." + effect.id + "." + parameter.name;
        const auto* const v = std::get_if<Eigen::VectorXd>(&found->second);
        if (v == nullptr) {
            numbers.push_back({parameter.name, -1, name, parameter.lowest, parameter.highest, parameter.scale, parameter.over_decades});
            continue;
        }
        if (parameter.kind == EffectParameterKind::direction) {
            const Eigen::Vector3d base = v->normalized();
            for (int i = 0; i < 2; ++i)
                numbers.push_back({parameter.name, i, name + ".turn_" + std::to_string(i + 1) + "_rad",
                                   parameter.lowest, parameter.highest, parameter.scale, false, base});
            continue;
        }
        for (int i = 0; i < static_cast<int>(v->size()); ++i)
            numbers.push_back({parameter.name, i, name + "." + "xyz"[i % 3], parameter.lowest, parameter.highest, parameter.scale, false});
    }
    return numbers;
}

double effect_number(const EffectDeclaration& effect, const std::string& parameter, int component,
                     const Eigen::Vector3d& base) {
    const EffectParameter& value = effect.parameters.at(parameter);
    if (component < 0) return std::get<double>(value);
    const auto& v = std::get<Eigen::VectorXd>(value);
    return base.isZero(0.0) ? v(component) : direction_angles(base, v)(component);
}

void set_effect_number(EffectDeclaration& effect, const std::string& parameter, int component, double value,
                       const Eigen::Vector3d& base) {
    EffectParameter& place = effect.parameters.at(parameter);
    if (component < 0) {
        place = value;
        return;
    }
    auto& v = std::get<Eigen::VectorXd>(place);
    if (base.isZero(0.0)) {
        v(component) = value;
        return;
    }
    Eigen::Vector2d angles = direction_angles(base, v);
    angles(component) = value;
    v = direction_at(base, angles);
}

}  // namespace myo
