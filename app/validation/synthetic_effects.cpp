#include "validation/synthetic_effects.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace myo::validation {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::string marker_name(int index) { return "m" + std::to_string(index + 1); }

Vector3d direction(RandomStream& random) {
    return Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// Surface point in the outer part of the body, independent of the markers.
Vector3d outer_point(const SyntheticCase& c, RandomStream& random) { return drawn_markers(c.body, 2, random).back(); }

/// Axis y or z.
double across(RandomStream& random) { return random.chance(0.5) ? 1.0 : 2.0; }

effect::EffectParameters nothing(const SyntheticCase&, RandomStream&) { return {}; }
effect::EffectParameters place(const SyntheticCase& c, RandomStream& random) {
    return {{"position_m", VectorXd(outer_point(c, random))}};
}

/// A cable from a surface point to an anchor outside the body.
effect::EffectParameters cable(const SyntheticCase& c, RandomStream& random) {
    const Vector3d at = outer_point(c, random);
    return {{"position_m", VectorXd(at)},
            {"anchor_m", VectorXd(at + random.uniform(0.7, 1.5) * c.body.length_m() * direction(random))}};
}

/// A horizontal axis, as mounts tilt.
effect::EffectParameters level_axis(const SyntheticCase&, RandomStream& random) {
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    return {{"axis", VectorXd(Vector3d(std::cos(angle), std::sin(angle), 0.0))}};
}

/// An offset across the body, in the first trial that starts straight.
effect::EffectParameters held(const SyntheticCase& c, RandomStream& random) {
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    for (const SyntheticTrial& trial : c.trials)
        if (trial.start == experiment::StartState::straight)
            return {{"offset_m", VectorXd(1e-3 * Vector3d(0.0, std::cos(angle), std::sin(angle)))},
                    {"trial", trial.name}};
    return {{"offset_m", VectorXd(Vector3d(0.0, 0.0, 1e-3))}};
}

effect::EffectParameters creep(const SyntheticCase&, RandomStream& random) {
    return {{"relaxation_time_s", random.log_uniform(0.03, 0.5)}};
}

/// Energy scale of the order of the energy stored in a body bent by its own weight.
effect::EffectParameters softening(const SyntheticCase& c, RandomStream& random) {
    const double strain = c.material.density_kg_m3 * 9.81 * c.body.length_m() * c.body.length_m() * 3.0 /
                          (c.body.thickness_m * c.material.youngs_modulus_Pa);
    return {{"energy_scale_J_m3", random.log_uniform(0.1, 0.6) * c.material.youngs_modulus_Pa * strain * strain}};
}

effect::EffectParameters gradient(const SyntheticCase&, RandomStream& random) {
    return {{"axis", random.chance(0.6) ? 0.0 : across(random)}};
}

/// A sphere on the axis of the body, with a radius below its thickness.
effect::EffectParameters patch(const SyntheticCase& c, RandomStream& random) {
    const Vector3d size = c.body.bounds.size();
    Vector3d centre = c.body.bounds.lowest + 0.5 * size;
    centre.x() = c.body.held_m + random.uniform(0.1, 0.7) * (c.body.length_m() - c.body.held_m);
    if (c.body.family == BodyFamily::ell) centre.z() = 0.5 * c.body.thickness_m;
    return {{"centre_m", VectorXd(centre)}, {"radius_m", random.uniform(0.35, 0.8) * c.body.thickness_m}};
}

effect::EffectParameters bent(const SyntheticCase&, RandomStream& random) { return {{"axis", across(random)}}; }
effect::EffectParameters width(const SyntheticCase&, RandomStream& random) {
    return {{"width", random.log_uniform(0.02, 0.12)}};
}

std::string some_fit_trial(const SyntheticCase& c, RandomStream& random) {
    std::vector<std::string> names;
    for (const SyntheticTrial& trial : c.trials)
        if (trial.role == experiment::TrialRole::fit) names.push_back(trial.name);
    return names[static_cast<std::size_t>(random.below(static_cast<int>(names.size())))];
}

/// A sample time in the middle of the trial.
double some_time(const SyntheticCase& c, RandomStream& random) {
    return 0.01 * std::round(100.0 * random.uniform(0.25, 0.7) * c.trials.front().end_s);
}

effect::EffectParameters slipped(const SyntheticCase& c, RandomStream& random) {
    const int marker = random.below(static_cast<int>(c.markers.size()));
    return {{"marker", marker_name(marker)},
            {"shift_m", VectorXd(1e-3 * direction(random))},
            {"time_s", some_time(c, random)},
            {"trial", some_fit_trial(c, random)}};
}

/// Two different markers that exchange their labels at a time.
effect::EffectParameters swapped(const SyntheticCase& c, RandomStream& random) {
    const int count = static_cast<int>(c.markers.size()), first = random.below(count),
              second = (first + 1 + random.below(count - 1)) % count;
    return {{"markers", std::vector<std::string>{marker_name(first), marker_name(second)}},
            {"time_s", some_time(c, random)},
            {"trial", some_fit_trial(c, random)}};
}

/// The slipped clamp still holds a part.
double most_slip(const SyntheticCase& c) { return 0.8 * c.body.held_m; }

constexpr EffectNeeds none{}, muscles{.muscles = true}, straight{.straight_start = true};

/// Ranges of amounts per effect, in the unit of the parameter.
const std::map<std::string, EffectDraw>& draws() {
    static const std::map<std::string, EffectDraw> table = {
        {"quadratic_drag", {none, "coefficient_kg_m3", 30.0, 6000.0, true, nothing}},
        {"linear_drag", {none, "coefficient_Pa_s_m", 1.0, 500.0, true, nothing}},
        {"added_mass", {none, "surface_density_kg_m2", 0.3, 60.0, true, nothing}},
        {"point_mass", {none, "mass_kg", 5e-4, 0.05, true, place}},
        {"cable_tug", {none, "stiffness_N_m", 0.1, 100.0, true, cable}},
        {"dry_friction", {none, "friction_force_N", 2e-4, 0.5, true, place}},
        {"hung_mass", {{.hung_weight = true}, "inertia_ratio", 0.1, 3.0, true, nothing}},
        {"gravity_tilt", {none, "tilt_deg", 0.5, 20.0, true, level_axis}},
        {"clamp_compliance", {none, "stiffness_Pa_per_m", 5e5, 1e9, false, nothing}},
        {"clamp_slip", {{.deep_clamp = true}, "free_length_m", 1e-3, 0.02, true, nothing, most_slip}},
        {"held_pose", {straight, "offset_m", 3e-4, 0.02, true, held}},
        {"extra_damping", {{.known_damping = true}, "excess_damping_s", 2e-4, 0.03, true, nothing}},
        {"viscoelastic_creep", {none, "modulus_ratio", 0.02, 2.0, true, creep}},
        {"strain_stiffening", {none, "yeoh_c2", 0.05, 60.0, true, nothing}},
        {"stress_softening", {none, "damage_max", 0.03, 0.8, true, softening}},
        {"stiffness_gradient", {none, "relative_change", 0.05, 1.6, true, gradient}},
        {"soft_patch", {none, "relative_change", 0.1, 0.9, true, patch}},
        {"modulus_drift", {none, "rate_1_s", 1e-5, 1e-3, true, nothing}},
        {"intrinsic_curvature", {none, "curvature_1_m", 0.05, 8.0, true, bent}},
        {"actuation_lag", {muscles, "time_constant_s", 5e-3, 0.3, true, nothing}},
        {"actuation_delay", {muscles, "delay_s", 5e-3, 0.2, true, nothing}},
        {"actuation_gain", {muscles, "relative_change", 0.02, 0.5, true, nothing}},
        {"actuation_leak", {muscles, "time_constant_s", 0.1, 30.0, false, nothing}},
        {"actuation_hysteresis", {muscles, "fraction", 0.05, 0.9, true, width}},
        {"clock_offset", {none, "offset_s", 5e-4, 0.05, true, nothing}},
        {"frame_rate_error", {none, "relative_error", 5e-4, 0.08, true, nothing}},
        {"scale_error", {none, "relative_error", 1e-3, 0.05, true, nothing}},
        {"marker_swap", {none, "", 0.0, 0.0, true, swapped}},
        {"marker_slip", {none, "shift_m", 5e-4, 0.02, true, slipped}},
    };
    return table;
}

/// Amounts that may be negative.
bool has_sign(const std::string& id) {
    static const std::vector<std::string> ids = {"stiffness_gradient",  "soft_patch",     "modulus_drift",
                                                 "intrinsic_curvature", "actuation_gain", "clock_offset",
                                                 "frame_rate_error",    "scale_error"};
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

const EffectDraw* find_effect_draw(const std::string& id) {
    const auto at = draws().find(id);
    return at == draws().end() ? nullptr : &at->second;
}

double most_amount(const SyntheticCase& c) {
    const EffectDraw& draw = *find_effect_draw(c.effect->id);
    return draw.most ? std::min(draw.highest, draw.most(c)) : draw.highest;
}

effect::EffectDeclaration drawn_effect(const std::string& id, const SyntheticCase& c, RandomStream& random) {
    const EffectDraw* const draw = find_effect_draw(id);
    assert(draw != nullptr);
    effect::EffectDeclaration effect{id, draw->others(c, random)};
    if (draw->amount.empty()) return effect;
    if (effect.parameters.count(draw->amount) == 0)
        effect.parameters[draw->amount] = has_sign(id) ? random.sign() : 1.0;
    // Geometric mean of the plausible range: the search for a visible amount starts there.
    return with_amount(std::move(effect), std::sqrt(draw->lowest * draw->highest));
}

double effect_amount(const effect::EffectDeclaration& effect) {
    return std::abs(effect::number(effect.parameters, find_effect_draw(effect.id)->amount));
}

effect::EffectDeclaration with_amount(effect::EffectDeclaration effect, double amount) {
    effect::EffectParameter& value = effect.parameters.at(find_effect_draw(effect.id)->amount);
    if (auto* const v = std::get_if<VectorXd>(&value))
        *v *= amount / v->norm();
    else
        value = std::copysign(amount, std::get<double>(value));
    return effect;
}

}  // namespace myo::validation
