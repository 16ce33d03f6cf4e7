#include <algorithm>

#include "prediction/prediction.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::prediction {
namespace {

using Kind = ModelParameter::Kind;

// `names` given by the caller takes precedence over the declaration.
bool is_calibrated(const setup::Setup& setup, const std::string& name, const std::vector<std::string>& names) {
    const std::vector<std::string>& list = names.empty() ? setup.experiment.material.calibrate : names;
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// Unknowns of a fit, with the declared values as their start.
struct ParameterList {
    ParameterValues start;
    std::vector<ModelParameter> parameters;

    void add(Kind kind, std::size_t trial, std::size_t index, const std::string& name, double lower, double upper,
             double scale, const std::string& unit) {
        // Equal bounds declare an exact value: there is nothing to fit.
        if (!(lower < upper)) return;
        ModelParameter entry{kind, trial, index, {name, 0.0, lower, upper, scale}, unit, {}, -1};
        entry.parameter.value = value_of(entry, start);
        parameters.push_back(std::move(entry));
    }
};

/// Modulus, damping and numbers of the material law.
void add_material(const setup::Setup& setup, const std::vector<std::string>& names, ParameterList& list) {
    // The declared tolerance bounds the modulus. Without bounds a model that lacks an effect drifts: muscles that only
    // act against the elasticity of the body determine the ratio of modulus and level, not each of them.
    const double nominal = list.start.youngs_modulus_Pa, tolerance = setup.experiment.material.youngs_modulus_tolerance;
    if (is_calibrated(setup, "youngs_modulus", names))
        list.add(Kind::youngs_modulus, 0, 0, "youngs_modulus_Pa", (1.0 - tolerance) * nominal,
                 (1.0 + tolerance) * nominal, nominal, "Pa");
    if (is_calibrated(setup, "damping", names)) {
        list.add(Kind::damping, 0, 0, "damping_s", 0.0, 1.0, 1e-3, "s");
        list.parameters.back().parameter.over_decades = true;
    }
    const std::vector<material::LawParameter> law = setup.trials.front().model.material->parameters();
    for (std::size_t k = 0; k < law.size(); ++k)
        if (is_calibrated(setup, law[k].name, names)) {
            list.add(Kind::law, 0, k, law[k].name, law[k].lower, law[k].upper, law[k].scale, law[k].unit);
            list.parameters.back().parameter.over_decades = law[k].over_decades;
        }
}

/// Moduli and damping times of the parts, where they are declared as unknown; "spine.youngs_modulus_Pa".
void add_parts(const setup::Setup& setup, ParameterList& list) {
    for (std::size_t k = 0; k < setup.experiment.parts.size(); ++k) {
        const experiment::PartDeclaration& part = setup.experiment.parts[k];
        const auto fitted = [&](const char* name) {
            return std::find(part.calibrate.begin(), part.calibrate.end(), name) != part.calibrate.end();
        };
        const double nominal = part.youngs_modulus_Pa, tolerance = part.youngs_modulus_tolerance;
        if (fitted("youngs_modulus"))
            list.add(Kind::part_modulus, 0, k, part.name + ".youngs_modulus_Pa", (1.0 - tolerance) * nominal,
                     (1.0 + tolerance) * nominal, nominal, "Pa");
        if (!fitted("damping")) continue;
        list.add(Kind::part_damping, 0, k, part.name + ".damping_s", 0.0, 1.0, 1e-3, "s");
        list.parameters.back().parameter.over_decades = true;
    }
}

/// Placement of the cameras, within its declared limits.
void add_registration(const setup::Setup& setup, ParameterList& list) {
    const experiment::RegistrationDeclaration& registration = setup.experiment.registration;
    if (!registration.known && registration.method == experiment::RegistrationMethod::limited) {
        const double angle = registration.max_rotation_deg * 3.14159265358979323846 / 180.0;
        const char* axes[] = {"x", "y", "z"};
        for (std::size_t i = 0; i < 3; ++i)
            list.add(Kind::translation, 0, i, std::string("registration_") + axes[i] + "_m",
                     -registration.max_translation_m, registration.max_translation_m,
                     std::max(registration.max_translation_m, 1e-6), "m");
        for (std::size_t i = 0; i < 3; ++i)
            list.add(Kind::rotation, 0, i, std::string("registration_rotation_") + axes[i] + "_rad", -angle, angle,
                     std::max(angle, 1e-6), "rad");
    }
}

/// Start of the motion and levels of the actuators, of each trial.
void add_trial_unknowns(const setup::Setup& setup, ParameterList& list) {
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const setup::PreparedTrial& trial = setup.trials[t];
        if (trial.role != experiment::TrialRole::fit) continue;
        // A detected start is accurate to a few frames; the fit determines the remainder.
        const double interval = setup::sampling_interval_s(trial);
        if (trial.start_found)
            list.add(Kind::start_shift, t, 0, "start_shift_s." + trial.name, -3.0 * interval, 3.0 * interval, interval,
                     "s");
        const std::vector<std::string> names = setup::actuator_names(setup.experiment);
        for (const std::size_t actuator : trial.free_levels) {
            const setup::LevelBounds bounds = setup::level_bounds(setup.experiment, actuator);
            list.add(Kind::level, t, actuator, "actuation_level." + trial.name + "." + names[actuator], bounds.lower,
                     bounds.upper, bounds.scale, setup::signal_unit(setup.experiment, actuator));
        }
    }
}

/// Bounds of a parameter with those that [[unknown]] declares. Those of moduli, registration and start replace the
/// usual ones, which only say what is plausible; the others stay within theirs, beyond which a model has no meaning.
///
/// @return  empty range, lower >= upper, if nothing is left
std::pair<double, double> declared_range(const experiment::UnknownDeclaration& declared, const ModelParameter& entry) {
    const inverse::Parameter& p = entry.parameter;
    std::optional<double> lowest = declared.lowest, highest = declared.highest;
    if (declared.tolerance) {
        lowest = p.value - *declared.tolerance;
        highest = p.value + *declared.tolerance;
    }
    const bool is_modulus = entry.kind == Kind::youngs_modulus || entry.kind == Kind::part_modulus;
    // The tolerance may exceed a modulus that was set after reading.
    if (is_modulus && lowest && !(*lowest > 0.0)) lowest.reset();
    const bool replaced = is_modulus || entry.kind == Kind::translation || entry.kind == Kind::rotation ||
                          entry.kind == Kind::start_shift;
    const double lower = lowest.value_or(p.lower), upper = highest.value_or(p.upper);
    if (replaced) return {lower, upper};
    return {std::max(lower, p.lower), std::min(upper, p.upper)};
}

const experiment::UnknownDeclaration* declaration_of(const setup::Setup& setup, const ModelParameter& entry) {
    for (const experiment::UnknownDeclaration& unknown : setup.experiment.unknowns)
        if (unknown.name == entry.parameter.name) return &unknown;
    return nullptr;
}

/// All unknowns with their usual bounds.
std::vector<ModelParameter> usual_parameters(const setup::Setup& setup, const std::vector<std::string>& names) {
    ParameterList list{declared_values(setup), {}};
    add_material(setup, names, list);
    add_parts(setup, list);
    add_registration(setup, list);
    add_trial_unknowns(setup, list);
    for (std::size_t e = 0; e < list.start.effects.size(); ++e)
        if (list.start.effects[e].calibrate)
            for (ModelParameter& parameter : effect_parameters(setup, list.start.effects[e], e))
                list.parameters.push_back(std::move(parameter));
    return std::move(list.parameters);
}

}  // namespace

std::vector<ModelParameter> free_parameters(const setup::Setup& setup, const std::vector<std::string>& names) {
    std::vector<ModelParameter> parameters = usual_parameters(setup, names);
    for (ModelParameter& entry : parameters) {
        const experiment::UnknownDeclaration* const declared = declaration_of(setup, entry);
        if (declared == nullptr) continue;
        const auto [lower, upper] = declared_range(*declared, entry);
        if (!(lower < upper)) continue;  // told, see unmet_bounds()
        inverse::Parameter& p = entry.parameter;
        p.lower = lower;
        p.upper = upper;
        p.value = std::clamp(p.value, p.lower, p.upper);
    }
    return parameters;
}

std::vector<ModelParameter> unmet_bounds(const setup::Setup& setup) {
    std::vector<ModelParameter> unmet;
    for (const ModelParameter& entry : usual_parameters(setup, {})) {
        const experiment::UnknownDeclaration* const declared = declaration_of(setup, entry);
        if (declared == nullptr) continue;
        const auto [lower, upper] = declared_range(*declared, entry);
        if (!(lower < upper)) unmet.push_back(entry);
    }
    return unmet;
}

}  // namespace myo::prediction
