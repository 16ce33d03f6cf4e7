#include <algorithm>

#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

/// Levels after a step at t = 0: a number, or "free" for a fitted one.
std::vector<ActuationStep> read_steps(const toml::TomlReader& trial) {
    std::vector<ActuationStep> steps;
    const toml::TomlReader table = trial.table_of_names("actuation_step");
    for (const std::string& name : table.keys()) {
        ActuationStep step;
        step.muscle = name;
        if (table.is_text(name)) {
            if (table.text(name) != "free")
                table.fail(name, "must be a number or \"free\", not \"" + table.text(name) + "\"");
        } else {
            step.level = table.number(name);
        }
        steps.push_back(step);
    }
    return steps;
}

/// Constants and curves of one unit; a name stands in one table only.
///
/// @param key    table of the trial: "activation", "pressure_Pa", "tension_N" or "shortening_m"
/// @param range  of constants, in the unit of the key
/// @param hold   the trial is one pose, in which nothing varies over time
void read_constants(const toml::TomlReader& trial, const std::string& key, const toml::NumberRange& range, bool hold,
                    std::vector<ConstantCommand>& commands) {
    if (!trial.has(key)) return;
    const toml::TomlReader table = trial.table_of_names(key);
    for (const std::string& name : table.keys()) {
        for (const ConstantCommand& other : commands)
            if (other.actuator == name) table.fail(name, "has a value in " + other.key + " already");
        if (!table.is_array(name)) {
            commands.push_back({name, table.number(name, range), key});
            continue;
        }
        // Muscles have signals of their own, and followers, which a curve would have to move as well.
        if (key == "activation") table.fail(name, "must be a number; the curve of a muscle is its signal");
        if (hold) table.fail(name, "must be a number in a trial with hold = true: the body is at rest all along");
        fibre::Signal curve = read_curve(table, name);
        if (key == "tension_N" && *std::min_element(curve.values.begin(), curve.values.end()) < 0.0)
            table.fail(name, "holds a negative tension; a tendon never pushes");
        // Equilibrium at the start is computed from the values at t = 0.
        const double at_start = curve.value(0.0);
        commands.push_back({name, at_start, key, std::move(curve)});
    }
}

/// Readings of sensors: a file, or numbers of a hold.
void read_readings(const toml::TomlReader& trial, const std::filesystem::path& folder, TrialDeclaration& declared) {
    if (trial.has("sensors")) declared.sensors = trial.file("sensors", folder);
    if (!trial.has("sensor")) return;
    if (!declared.hold) trial.fail("sensor", "belongs to a trial with hold = true; others have sensors = \"file.csv\"");
    if (declared.sensors) trial.fail("sensor", "cannot be combined with sensors; give the file or the numbers");
    const toml::TomlReader table = trial.table_of_names("sensor");
    for (const std::string& name : table.keys()) declared.sensor_values[name] = table.number(name);
}

}  // namespace

std::vector<std::string> command_keys() {
    return {"hold",        "start",     "actuation",    "actuation_step", "activation",
            "pressure_Pa", "tension_N", "shortening_m", "sensors",        "sensor"};
}

void read_commands(const toml::TomlReader& trial, const std::filesystem::path& folder, TrialDeclaration& declared) {
    declared.hold = trial.boolean_or("hold", false);
    // The start is not chosen in a hold: all of its samples are the equilibrium under constant commands.
    if (declared.hold) {
        trial.reject("start", "cannot be combined with hold: the body is at rest all along");
        for (const char* key : {"actuation", "actuation_step"})
            trial.reject(key, "cannot be combined with hold: its commands are constant");
        declared.start = StartState::equilibrium;
    } else {
        declared.start = trial.choice<StartState>(
            "start", {{"straight", StartState::straight}, {"equilibrium", StartState::equilibrium}});
    }
    if (trial.has("actuation")) declared.actuation = trial.file("actuation", folder);
    if (trial.has("actuation_step")) declared.actuation_steps = read_steps(trial);
    read_constants(trial, "activation", toml::positive(), declared.hold, declared.constant_commands);
    read_constants(trial, "pressure_Pa", toml::any_number(), declared.hold, declared.constant_commands);
    read_constants(trial, "tension_N", toml::not_negative(), declared.hold, declared.constant_commands);
    read_constants(trial, "shortening_m", toml::any_number(), declared.hold, declared.constant_commands);
    read_readings(trial, folder, declared);
}

}  // namespace myo::experiment
