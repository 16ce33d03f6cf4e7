#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "experiment/actuators.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "toml/toml_path.hpp"

namespace myo::experiment {
namespace {

/// Ends the reading with an error at the location of a key.
[[noreturn]] void fail(const Experiment& experiment, const std::string& key, const std::string& sentence) {
    throw toml::TomlFailure{declaration_error(experiment, key, sentence)};
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Names of the markers that recordings hold.
std::vector<std::string> recorded_names(const Experiment& experiment) {
    std::vector<std::string> names;
    for (const MarkerDeclaration& marker : recorded_markers(experiment.markers)) names.push_back(marker.name);
    return names;
}

// Names and labels are each unique; a label that repeats the name has no key of its own to point at.
void check_marker_names(const Experiment& experiment) {
    std::vector<std::string> names, paths, labels, label_paths;
    for (const auto* group : {&experiment.markers.on_body, &experiment.markers.fixed}) {
        const bool fixed = group == &experiment.markers.fixed;
        for (const MarkerDeclaration& marker : *group) {
            names.push_back(marker.name);
            paths.push_back((fixed          ? "markers.fixed_m."
                             : marker.probe ? "markers.probe_m."
                                            : "markers.rest_m.") +
                            marker.name);
            labels.push_back(marker.label);
            label_paths.push_back(marker.label == marker.name ? paths.back() : "markers.labels." + marker.name);
        }
    }
    check_unique(experiment, names, paths);
    check_unique(experiment, labels, label_paths);
}

/// Registration by the rest pose fits a rigid motion to the markers of a recording; too few leave a rotation free.
void check_rest_pose_fit(const Experiment& experiment) {
    if (experiment.registration.known || experiment.registration.method != RegistrationMethod::rest_pose) return;
    std::vector<Eigen::Vector3d> points;
    for (const MarkerDeclaration& marker : recorded_markers(experiment.markers)) points.push_back(marker.rest_m);
    if (!fix_a_rigid_motion(points))
        fail(experiment, "registration.method", "a rigid fit needs at least three markers that are not in one line");
}

/// Names are unique, leaders exist, and no chain of followers returns to its beginning.
void check_muscles(const Experiment& experiment) {
    const auto& muscles = experiment.muscles;
    std::vector<std::string> names, paths;
    for (std::size_t i = 0; i < muscles.size(); ++i) {
        names.push_back(muscles[i].name);
        paths.push_back(toml::element_text("muscle", i) + ".name");
    }
    check_unique(experiment, names, paths);
    for (std::size_t i = 0; i < muscles.size(); ++i) {
        if (!muscles[i].follows) continue;
        const std::string key = toml::element_text("muscle", i) + ".follows.muscle";
        // Follow the chain of leaders: it ends at a muscle that follows none, or it is a cycle.
        std::size_t at = i;
        for (std::size_t steps = 0; muscles[at].follows; ++steps) {
            const std::string& leader = muscles[at].follows->muscle;
            const auto found = std::find(names.begin(), names.end(), leader);
            if (found == names.end()) {
                if (at == i)
                    fail(experiment, key, "unknown muscle \"" + leader + "\"; " + toml::suggest(leader, names));
                break;  // reported at the muscle that names it
            }
            at = static_cast<std::size_t>(found - names.begin());
            if (at == i)
                fail(experiment, key,
                     steps == 0 ? "a muscle cannot follow itself" : "muscles follow each other in a ring");
            if (steps > muscles.size()) break;  // a cycle that does not contain this muscle, reported at its members
        }
    }
}

// A columns file lists its markers by name or by label; labels are replaced by names unless they are names themselves.
void check_columns(const Experiment& experiment, const std::string& trial_path, measurement::ColumnLayout& columns) {
    const std::string key = trial_path + ".columns.markers";
    const std::vector<std::string> names = recorded_names(experiment);
    // A word that is the name of one marker and the label of another means the name.
    for (std::string& word : columns.labels) {
        for (const MarkerDeclaration& marker : recorded_markers(experiment.markers))
            if (word == marker.label && !contains(names, word)) word = marker.name;
        if (!contains(names, word))
            fail(experiment, key, "\"" + word + "\" is not a declared marker; " + toml::suggest(word, names));
    }
    for (const std::string& name : names)
        if (!contains(columns.labels, name)) fail(experiment, key, "the declared marker \"" + name + "\" is missing");
    // All names are declared and all declared names occur, so equal counts exclude duplicates.
    std::set<std::string> unique(columns.labels.begin(), columns.labels.end());
    if (unique.size() != columns.labels.size()) fail(experiment, key, "names a marker twice");
}

/// Steps of a trial name actuators that can have a signal of their own, with levels that these can have.
void check_actuation(const Experiment& experiment, const std::string& trial_path, const TrialDeclaration& trial) {
    const std::vector<Actuator> all = actuators(experiment);
    std::vector<std::string> names;
    for (const Actuator& actuator : all) names.push_back(actuator.name);
    if (trial.actuation && names.empty())
        fail(experiment, trial_path + ".actuation", "there is no [[muscle]], [[chamber]] or [[tendon]] to actuate");
    for (const ActuationStep& step : trial.actuation_steps) {
        const std::string key = trial_path + ".actuation_step." + step.muscle;
        const auto found = std::find(names.begin(), names.end(), step.muscle);
        // The message names only what this experiment could have.
        const bool only_muscles = experiment.chambers.empty() && experiment.tendons.empty();
        if (found == names.end())
            fail(experiment, key,
                 std::string("unknown ") + (only_muscles ? "muscle" : "muscle, chamber or tendon") + "; " +
                     toml::suggest(step.muscle, names));
        const Actuator& actuator = all[static_cast<std::size_t>(found - names.begin())];
        if (actuator.kind == ActuatorKind::muscle && experiment.muscles[actuator.index].follows)
            fail(experiment, key,
                 "this muscle follows \"" + experiment.muscles[actuator.index].follows->muscle +
                     "\" and has no actuation of its own");
        if (actuator.kind == ActuatorKind::tendon_tension && step.level && *step.level < 0.0)
            fail(experiment, key, "a tension must not be negative: a tendon never pushes");
        // A free level that no fit determines would have no value.
        if (!step.level && !contains(experiment.material.calibrate, "actuation_level"))
            fail(experiment, key, "\"free\" needs \"actuation_level\" in material.calibrate");
    }
}

// Only markers on the body can be moved to a goal.
void check_goals(const Experiment& experiment, const std::string& trial_path, const TrialDeclaration& trial) {
    std::vector<std::string> names;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) names.push_back(marker.name);
    for (std::size_t g = 0; g < trial.goals.size(); ++g)
        if (!contains(names, trial.goals[g].marker))
            fail(experiment, trial_path + "." + toml::element_text("goal", g) + ".marker",
                 "\"" + trial.goals[g].marker + "\" is no marker on the body; " +
                     toml::suggest(trial.goals[g].marker, names));
}

// A free level has neither a number nor a recording.
bool has_free_level(const TrialDeclaration& trial, const std::string& muscle) {
    return std::any_of(trial.actuation_steps.begin(), trial.actuation_steps.end(),
                       [&](const ActuationStep& step) { return step.muscle == muscle && !step.level; });
}

/// A free level of a validation trial is interpolated from the fitted levels over a test condition, so at least one fit
/// trial must provide the same muscle with that condition. Over a condition that not all of them state the prediction
/// does not interpolate, but takes their mean level; that adds a warning.
void check_predicted_levels(Experiment& experiment, const std::string& trial_path, const TrialDeclaration& trial) {
    if (trial.role != TrialRole::validate) return;
    for (const ActuationStep& step : trial.actuation_steps) {
        if (step.level) continue;
        const std::string key = trial_path + ".actuation_step." + step.muscle;
        if (trial.condition.empty())
            fail(experiment, key,
                 "the free level of a validate trial is predicted from its `condition`, which is missing");
        std::vector<const TrialDeclaration*> sources;
        for (const TrialDeclaration& other : experiment.trials)
            if (other.role == TrialRole::fit && has_free_level(other, step.muscle)) sources.push_back(&other);
        std::size_t most = 0;  // sources that state one and the same condition of this trial
        for (const auto& entry : trial.condition) {
            std::size_t count = 0;
            for (const TrialDeclaration* const source : sources) count += source->condition.count(entry.first);
            most = std::max(most, count);
        }
        if (most == 0)
            fail(experiment, key,
                 "no fit trial has a free level of this muscle and the same `condition` to predict it from");
        if (most < sources.size())
            experiment.warnings.push_back(key + ": no `condition` of this trial stands in all " +
                                          std::to_string(sources.size()) +
                                          " fit trials with this free level, so that it is predicted as their mean");
    }
}

/// Everything in [[trial]] that refers to other tables. Labels of columns are replaced by names; may add a warning.
void check_trials(Experiment& experiment) {
    std::vector<std::string> names, paths;
    bool any_free = false;
    for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
        TrialDeclaration& trial = experiment.trials[i];
        const std::string path = toml::element_text("trial", i);
        names.push_back(trial.name);
        paths.push_back(path + ".name");
        if (trial.columns) check_columns(experiment, path, *trial.columns);
        check_actuation(experiment, path, trial);
        check_goals(experiment, path, trial);
        check_predicted_levels(experiment, path, trial);
        for (const ActuationStep& step : trial.actuation_steps) any_free = any_free || !step.level;
    }
    check_unique(experiment, names, paths);
    // Validation trials test a fit. Trials that are only simulated need none.
    const auto any_of_role = [&](TrialRole role) {
        return std::any_of(experiment.trials.begin(), experiment.trials.end(),
                           [&](const TrialDeclaration& trial) { return trial.role == role; });
    };
    if (any_of_role(TrialRole::validate) && !any_of_role(TrialRole::fit))
        fail(experiment, "trial[0].role", "all recorded trials are \"validate\"; at least one needs role = \"fit\"");
    if (!any_free && contains(experiment.material.calibrate, "actuation_level"))
        experiment.warnings.push_back(
            "material.calibrate: \"actuation_level\" has no effect, no trial has a level \"free\"");
}

// Zero tolerance fixes the modulus; calibrating it as well is contradictory but harmless.
void check_calibrate(Experiment& experiment) {
    const MaterialDeclaration& material = experiment.material;
    if (material.youngs_modulus_tolerance == 0.0 && contains(material.calibrate, "youngs_modulus"))
        experiment.warnings.push_back(
            "material.youngs_modulus_tolerance: 0 declares the modulus exact, so a fit does not move it");
}

// Laws, declared or candidates, may read test conditions, which are complete only after the trials have been read.
void check_laws(const Experiment& experiment) {
    for (const effect::LawPointer& law : experiment.laws)
        for (const std::string& condition : law->conditions)
            for (std::size_t t = 0; t < experiment.trials.size(); ++t)
                if (experiment.trials[t].condition.count(condition) == 0)
                    fail(experiment, toml::element_text("trial", t) + ".condition",
                         "\"" + condition + "\" is missing, which the law \"" + law->id + "\" reads");
}

// Effects may name trials and markers, which are complete only after all tables have been read.
void check_effects(const Experiment& experiment) {
    const std::vector<std::string> markers = recorded_names(experiment);
    std::vector<std::string> trials;
    for (const TrialDeclaration& trial : experiment.trials) trials.push_back(trial.name);
    std::vector<std::string> driven;
    for (const MuscleDeclaration& muscle : experiment.muscles) driven.push_back(muscle.name);
    for (const ChamberDeclaration& chamber : experiment.chambers) driven.push_back(chamber.name);
    for (const TendonDeclaration& tendon : experiment.tendons) driven.push_back(tendon.name);
    for (std::size_t i = 0; i < experiment.effects.size(); ++i) {
        const effect::EffectDeclaration& effect = experiment.effects[i];
        // A word that names nothing is reported at its parameter, with the closest known name.
        const auto check = [&](const std::string& parameter, const std::string& word,
                               const std::vector<std::string>& known, const char* what) {
            if (!contains(known, word))
                fail(experiment, toml::element_text("effect", i) + "." + parameter,
                     std::string("unknown ") + what + " \"" + word + "\"; " + toml::suggest(word, known));
        };
        // The kind of a parameter says which table its word names; an optional parameter may be absent.
        for (const effect::EffectParameterEntry& entry : effect::find_effect(effect)->parameters) {
            const auto found = effect.parameters.find(entry.name);
            if (found == effect.parameters.end()) continue;
            if (entry.kind == effect::EffectParameterKind::trial)
                check(entry.name, std::get<std::string>(found->second), trials, "trial");
            if (entry.kind == effect::EffectParameterKind::actuator)
                check(entry.name, std::get<std::string>(found->second), driven, "muscle, chamber or tendon");
            if (entry.kind == effect::EffectParameterKind::marker)
                check(entry.name, std::get<std::string>(found->second), markers, "marker");
            if (entry.kind == effect::EffectParameterKind::marker_pair)
                for (const std::string& name : std::get<std::vector<std::string>>(found->second))
                    check(entry.name, name, markers, "marker");
        }
    }
}

}  // namespace

bool fix_a_rigid_motion(const std::vector<Eigen::Vector3d>& points) {
    // The cross product vanishes for points in one line with the first; 1e-6 of the squared extent is an angle of 1e-6.
    double extent = 0.0, area = 0.0;
    for (const auto& p : points)
        for (const auto& q : points) {
            extent = std::max(extent, (p - points[0]).norm());
            area = std::max(area, (p - points[0]).cross(q - points[0]).norm());
        }
    return points.size() >= 3 && area > 1e-6 * extent * extent;
}

void check_unique(const Experiment& experiment, const std::vector<std::string>& names,
                  const std::vector<std::string>& paths) {
    for (std::size_t i = 0; i < names.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (names[i] == names[j])
                fail(experiment, paths[i], "duplicate name \"" + names[i] + "\", already used by " + paths[j]);
}

void check_declarations(Experiment& experiment) {
    check_muscles(experiment);
    check_marker_names(experiment);
    check_rest_pose_fit(experiment);
    check_robot_parts(experiment);
    check_trials(experiment);
    check_calibrate(experiment);
    check_laws(experiment);
    check_effects(experiment);
}

}  // namespace myo::experiment
