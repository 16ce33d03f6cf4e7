#include "planning/trial_family.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "experiment/actuators.hpp"
#include "mesh/surface_mesh.hpp"
#include "planning/actuator_trials.hpp"
#include "planning/round_numbers.hpp"
#include "toml/toml_text.hpp"

namespace myo::planning {
namespace {

using experiment::LoadDeclaration;
using experiment::LoadKind;

/// Largest magnitude of a load of a kind over the trials; 0: none has one.
double largest_load(const experiment::Experiment& experiment, LoadKind kind) {
    double largest = 0.0;
    for (const experiment::TrialDeclaration& trial : experiment.trials)
        for (const LoadDeclaration& load : trial.loads)
            if (load.kind == kind)
                largest = std::max(largest, kind == LoadKind::mass ? load.mass_kg : load.force_N.norm());
    return largest;
}

/// Places of the declared loads, each once.
std::vector<Box> load_places(const experiment::Experiment& experiment, std::size_t most) {
    std::vector<Box> places;
    for (const experiment::TrialDeclaration& trial : experiment.trials)
        for (const LoadDeclaration& load : trial.loads) {
            const bool known = std::find(places.begin(), places.end(), load.box_m) != places.end();
            if (!known && places.size() < most) places.push_back(load.box_m);
        }
    return places;
}

/// The body as trials see it.
struct BodyShape {
    Box bounds;
    int axis = 0;           // along which it reaches from its support
    bool ends_high = true;  // its free end is the high one
    double kg = 0.0;
};

BodyShape shape_of(const setup::Setup& setup) {
    BodyShape shape{mesh::bounding_box(setup.surface.vertices)};
    shape.kg = setup.experiment.material.density_kg_m3 * setup.body->volume_m3;
    const Eigen::Vector3d size = shape.bounds.size(), middle = 0.5 * (shape.bounds.lowest + shape.bounds.highest);
    size.maxCoeff(&shape.axis);
    // Without a clamp the longest axis stands for that of the body.
    if (!experiment::has_clamp(setup.experiment)) return shape;
    const Box& clamp = setup.experiment.clamp_box_m;
    const Eigen::Vector3d held = (0.5 * (clamp.lowest + clamp.highest) - middle).cwiseQuotient(size);
    // The clamp is farthest off-centre along the axis of the body, relative to its size.
    held.cwiseAbs().maxCoeff(&shape.axis);
    shape.ends_high = held(shape.axis) < 0.0;
    return shape;
}

/// Box around the free end face.
Box free_end(const BodyShape& shape, const FamilyPolicy& policy) {
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(policy.end_depth * shape.bounds.size().maxCoeff());
    Box box{shape.bounds.lowest - margin, shape.bounds.highest + margin};
    if (shape.ends_high)
        box.lowest(shape.axis) = shape.bounds.highest(shape.axis) - margin(shape.axis);
    else
        box.highest(shape.axis) = shape.bounds.lowest(shape.axis) + margin(shape.axis);
    // Fewer digits than the margin has would move the box off the face.
    for (int i = 0; i < 3; ++i) {
        box.lowest(i) = rounded_down_to(box.lowest(i), margin(i));
        box.highest(i) = -rounded_down_to(-box.highest(i), margin(i));
    }
    return box;
}

/// A direction in words: "+z".
struct Direction {
    Eigen::Vector3d vector;
    std::string name;
};

/// Across the body: against and along its first cross axis, and along the second.
std::vector<Direction> directions_across(const BodyShape& shape, const Eigen::Vector3d& gravity) {
    const int first = (shape.axis + 1) % 3, second = (shape.axis + 2) % 3;
    // Gravity tells the two ways apart.
    const int vertical = std::abs(gravity(first)) > std::abs(gravity(second)) ? first : second;
    const std::string names = "xyz";
    const auto named = [&](int axis, double sign) {
        return Direction{sign * Eigen::Vector3d::Unit(axis),
                         (sign > 0.0 ? "+" : "-") + names.substr(static_cast<std::size_t>(axis), 1)};
    };
    return {named(vertical, 1.0), named(vertical, -1.0), named(vertical == first ? second : first, 1.0)};
}

/// Box of a load as a TOML key.
std::string box_key(const Box& box) {
    return "box_m = [" + toml::toml_vector(box.lowest) + ", " + toml::toml_vector(box.highest) + "]\n";
}

/// Table of a force on a box.
/// @param released  the force ends at t = 0, so that the body starts deflected and moves freely
std::string force_key(const Box& box, const Eigen::Vector3d& force_N, bool released) {
    return "[[trial.load]]\nkind = \"force\"\n" + box_key(box) + "force_N = " + toml::toml_vector(force_N) + "\n" +
           (released ? "until_s = 0.0\n" : "");
}

/// Keys of a trial with a motion.
/// @param start  "straight" or "equilibrium"
std::string moving_keys(double duration_s, const char* start) {
    return "duration_s = " + toml::toml_number(duration_s) + "\nstart = \"" + start + "\"\n";
}

/// Trials with loads at one place.
void add_loads(const setup::Setup& setup, const BodyShape& shape, const Box& place, const std::string& where,
               const experiment::LimitsDeclaration& limits, double duration_s, const FamilyPolicy& policy,
               std::vector<PossibleTrial>& family) {
    const experiment::Experiment& experiment = setup.experiment;
    const double seen_N = largest_load(experiment, LoadKind::force), seen_kg = largest_load(experiment, LoadKind::mass);
    const double weight_N = shape.kg * experiment.gravity_m_s2.norm();
    // A declared limit goes before what the trials had, and that before a share of the body's weight.
    const double most_N = limits.force_N.value_or(seen_N > 0.0 ? policy.beyond_seen * seen_N
                                                               : policy.force_of_weight * weight_N);
    const double most_kg = limits.mass_kg.value_or(seen_kg > 0.0 ? policy.beyond_seen * seen_kg
                                                                 : policy.mass_of_body * shape.kg);
    const std::vector<Direction> directions = directions_across(shape, experiment.gravity_m_s2);
    // Two sizes, since effects differ in how they grow with the deflection.
    for (const double part : {1.0, policy.smaller}) {
        const double force_N = rounded_down(part * most_N), mass_kg = rounded_down(part * most_kg);
        const std::string size = part < 1.0 ? "_light" : "";
        if (force_N > 0.0)
            for (const Direction& d : directions)
                family.push_back({"next_pull_" + d.name.substr(1) + (d.name[0] == '-' ? "_down" : "") + size + where,
                                  "a force of " + format_number(force_N) + " N along " + d.name + ", let go",
                                  moving_keys(duration_s, "equilibrium") + force_key(place, force_N * d.vector, true)});
        if (mass_kg > 0.0)
            family.push_back({"next_mass" + size + where,
                              "a mass of " + format_number(mass_kg) + " kg, held straight and let go",
                              moving_keys(duration_s, "straight") + "[[trial.load]]\nkind = \"mass\"\n" +
                                  box_key(place) + "mass_kg = " + toml::toml_number(mass_kg) + "\n"});
    }
    const double force_N = rounded_down(most_N);
    if (!(force_N > 0.0)) return;
    const Eigen::Vector3d steady_N = force_N * directions.front().vector;
    family.push_back({"next_steady_pull" + where,
                      "a force of " + format_number(force_N) + " N along " + directions.front().name +
                          " that stays on the body, which is let go from straight",
                      moving_keys(duration_s, "straight") + force_key(place, steady_N, false)});
    family.push_back({"next_hold" + where,
                      "at rest under a force of " + format_number(force_N) + " N along " + directions.front().name,
                      "hold = true\n" + force_key(place, steady_N, false)});
}

/// Names that no trial of the experiment has.
/// A number is appended where a name is taken.
void make_unique(const experiment::Experiment& experiment, std::vector<PossibleTrial>& family) {
    for (PossibleTrial& trial : family) {
        const std::string name = trial.name;
        const auto taken = [&](const std::string& wanted) {
            return std::any_of(experiment.trials.begin(), experiment.trials.end(),
                               [&](const experiment::TrialDeclaration& other) { return other.name == wanted; });
        };
        for (int n = 2; taken(trial.name); ++n) trial.name = name + "_" + std::to_string(n);
    }
}

}  // namespace

std::vector<PossibleTrial> trial_family(const setup::Setup& setup, const experiment::LimitsDeclaration& limits,
                                        const FamilyPolicy& policy) {
    const experiment::Experiment& experiment = setup.experiment;
    const BodyShape shape = shape_of(setup);
    // Times of the trials that exist: planned ones have the time stamps that they would be recorded at.
    double longest_s = 0.0, latest_s = 0.0;
    for (const setup::PreparedTrial& trial : setup.trials)
        if (!trial.hold) longest_s = std::max(longest_s, trial.measured.time_s(trial.measured.sample_count() - 1));
    for (const experiment::TrialDeclaration& trial : experiment.trials)
        latest_s = std::max(latest_s, trial.session_time_s);
    const double usual_s = rounded(longest_s > 0.0 ? longest_s : policy.planned_s);
    const double long_s = rounded_down(
        limits.duration_s.value_or(longest_s > 0.0 ? policy.beyond_seen * longest_s : policy.planned_s));
    const double short_s = std::min(usual_s, long_s);

    std::vector<PossibleTrial> family;
    family.push_back({"next_long_release", "held straight and let go, " + format_number(long_s) + " s long",
                      moving_keys(long_s, "straight")});
    std::vector<Box> places = load_places(experiment, policy.max_places);
    const bool driven = !experiment::actuators(experiment).empty();
    if (places.empty() && !driven) places.push_back(free_end(shape, policy));
    for (std::size_t i = 0; i < places.size(); ++i)
        add_loads(setup, shape, places[i], i == 0 ? "" : "_at_" + std::to_string(i + 1), limits, short_s, policy,
                  family);
    for (PossibleTrial& trial : actuator_trials(setup, limits, {short_s, long_s}, policy))
        family.push_back(std::move(trial));
    make_unique(experiment, family);
    // After everything that was done so far in the session.
    if (latest_s > 0.0)
        for (PossibleTrial& trial : family)
            trial.keys.insert(0, "session_time_s = " + toml::toml_number(latest_s) + "\n");
    // Releases and loads come first, so that trials of the last actuators are dropped.
    if (family.size() > policy.max_trials) family.resize(policy.max_trials);
    return family;
}

std::string trial_text(const PossibleTrial& trial) {
    return "# Proposed: " + trial.words +
           ".\n# Once it is recorded: role = \"fit\", trace = \"FILE\", format = \"...\", without duration_s.\n"
           "[[trial]]\nname = " +
           toml::toml_text(trial.name) + "\nrole = \"simulate\"\n" +
           (trial.signal ? "actuation = " + toml::toml_text(signal_file) + "\n" : "") + trial.keys;
}

}  // namespace myo::planning
