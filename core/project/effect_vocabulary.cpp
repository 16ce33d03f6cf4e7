#include "project/effect_vocabulary.hpp"

namespace myo {
namespace {

constexpr double unbounded = std::numeric_limits<double>::max();
// A time constant, width or radius of zero divides by zero.
constexpr double tiny = std::numeric_limits<double>::min();

EffectParameterEntry number(const char* name) { return {name, EffectParameterKind::number, false, -unbounded, unbounded}; }
EffectParameterEntry not_negative_number(const char* name) { return {name, EffectParameterKind::number, false, 0.0, unbounded}; }
EffectParameterEntry positive_number(const char* name) { return {name, EffectParameterKind::number, false, tiny, unbounded}; }
EffectParameterEntry bounded(const char* name, double lowest, double highest) {
    return {name, EffectParameterKind::number, false, lowest, highest};
}
EffectParameterEntry of_kind(const char* name, EffectParameterKind kind, bool optional = false) {
    return {name, kind, optional, -unbounded, unbounded};
}

constexpr bool optional = true;

std::vector<EffectEntry> make_vocabulary() {
    using Kind = EffectParameterKind;
    return {
        // forces
        {"quadratic_drag", {not_negative_number("coefficient_kg_m3")}},
        {"linear_drag", {not_negative_number("coefficient_Pa_s_m")}},
        {"added_mass", {not_negative_number("surface_density_kg_m2")}},
        {"point_mass", {not_negative_number("mass_kg"), of_kind("position_m", Kind::vector3)}},
        {"cable_tug",
         {not_negative_number("stiffness_N_m"), of_kind("position_m", Kind::vector3), of_kind("anchor_m", Kind::vector3, optional)}},
        {"hung_mass", {not_negative_number("inertia_ratio")}},
        {"gravity_tilt", {bounded("tilt_deg", -180.0, 180.0), of_kind("axis", Kind::vector3)}},
        // support
        {"clamp_compliance", {positive_number("stiffness_Pa_per_m")}},
        {"clamp_slip", {not_negative_number("free_length_m")}},
        {"held_pose", {of_kind("offset_m", Kind::number_or_vector3), of_kind("trial", Kind::trial, optional)}},
        // material
        {"extra_damping", {not_negative_number("excess_damping_s")}},
        {"viscoelastic_creep", {not_negative_number("modulus_ratio"), positive_number("relaxation_time_s")}},
        {"strain_stiffening", {number("yeoh_c2")}},
        {"stress_softening", {bounded("damage_max", 0.0, 1.0), positive_number("energy_scale_J_m3")}},
        // below -2 the modulus would be negative at one end, below -1 in the middle of the patch
        {"stiffness_gradient", {bounded("relative_change", -2.0, 2.0), of_kind("axis", Kind::axis)}},
        {"soft_patch", {bounded("relative_change", -1.0, unbounded), of_kind("centre_m", Kind::vector3), positive_number("radius_m")}},
        {"modulus_drift", {number("rate_1_s")}},
        {"intrinsic_curvature", {number("curvature_1_m"), of_kind("axis", Kind::axis)}},
        // actuation
        {"actuation_lag", {not_negative_number("time_constant_s")}},
        {"actuation_delay", {not_negative_number("delay_s")}},
        {"actuation_gain", {number("relative_change")}},
        {"actuation_leak", {positive_number("time_constant_s")}},
        {"actuation_hysteresis", {bounded("fraction", 0.0, 1.0), positive_number("width")}},
        // measurement
        {"clock_offset", {number("offset_s")}},
        {"frame_rate_error", {bounded("relative_error", -0.5, unbounded)}},
        {"scale_error", {bounded("relative_error", -0.5, unbounded)}},
        {"marker_swap", {of_kind("markers", Kind::marker_pair), number("time_s"), of_kind("trial", Kind::trial, optional)}},
        {"marker_slip",
         {of_kind("marker", Kind::marker), of_kind("shift_m", Kind::vector3), number("time_s"),
          of_kind("trial", Kind::trial, optional)}},
    };
}

}  // namespace

const std::vector<EffectEntry>& effect_vocabulary() {
    static const std::vector<EffectEntry> vocabulary = make_vocabulary();
    return vocabulary;
}

const EffectEntry* find_effect_entry(const std::string& id) {
    for (const EffectEntry& entry : effect_vocabulary())
        if (entry.id == id) return &entry;
    return nullptr;
}

std::vector<std::string> effect_ids() {
    std::vector<std::string> ids;
    for (const EffectEntry& entry : effect_vocabulary()) ids.push_back(entry.id);
    return ids;
}

}  // namespace myo
