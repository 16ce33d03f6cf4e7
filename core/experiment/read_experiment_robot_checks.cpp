#include <algorithm>

#include "experiment/actuators.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "toml/toml_path.hpp"

namespace myo::experiment {
namespace {

/// Ends the reading with an error at the location of a key.
[[noreturn]] void robot_fail(const Experiment& experiment, const std::string& key, const std::string& sentence) {
    throw toml::TomlFailure{declaration_error(experiment, key, sentence)};
}

/// Table of an actuator: "muscle[0]", "chamber[1]", "tendon[0]".
std::string actuator_key(const Actuator& actuator) {
    if (actuator.kind == ActuatorKind::muscle) return toml::element_text("muscle", actuator.index);
    return toml::element_text(actuator.kind == ActuatorKind::chamber ? "chamber" : "tendon", actuator.index);
}

// Names that differ may still head one column: a muscle "left_N" and a tendon "left".
void check_actuator_names(const Experiment& experiment) {
    std::vector<std::string> names, columns, paths;
    for (const Actuator& actuator : actuators(experiment)) {
        names.push_back(actuator.name);
        columns.push_back(actuator.column);
        paths.push_back(actuator_key(actuator) + ".name");
    }
    check_unique(experiment, names, paths);
    check_unique(experiment, columns, paths);
}

/// Chambers and parts suit the kind of geometry: a box has no cavity, no file's unit and no numbered cells.
void check_geometry(const Experiment& experiment) {
    const bool is_box = std::holds_alternative<BoxGeometry>(experiment.geometry);
    if (is_box && !experiment.chambers.empty())
        robot_fail(experiment, "chamber[0]", "a body with geometry.kind = \"box\" has no cavity");
    std::vector<std::string> names, paths;
    for (std::size_t i = 0; i < experiment.parts.size(); ++i) {
        const PartDeclaration& part = experiment.parts[i];
        const std::string key = toml::element_text("part", i);
        names.push_back(part.name);
        paths.push_back(key + ".name");
        if (is_box && std::holds_alternative<std::filesystem::path>(part.place))
            robot_fail(experiment, key + ".file", "has the geometry's unit, which kind = \"box\" does not declare");
        if (std::holds_alternative<PartDeclaration::Region>(part.place) &&
            !std::holds_alternative<VolumeGeometry>(experiment.geometry))
            robot_fail(experiment, key + ".region", "needs geometry.kind = \"volume\", whose cells carry numbers");
    }
    check_unique(experiment, names, paths);
}

/// A mount that moves with the fixed markers needs enough of them for a rigid motion, and a body that it holds.
void check_mount(const Experiment& experiment) {
    if (experiment.mount != MountMotion::markers) return;
    std::vector<Eigen::Vector3d> points;
    for (const MarkerDeclaration& marker : experiment.markers.fixed) points.push_back(marker.rest_m);
    if (points.size() < 3)
        robot_fail(experiment, "mount.motion",
                   "\"markers\" needs at least three markers in markers.fixed_m, not " + std::to_string(points.size()));
    if (!fix_a_rigid_motion(points))
        robot_fail(experiment, "mount.motion",
                   "\"markers\" needs three markers in markers.fixed_m that are not in one line");
    if (!is_held(experiment))
        robot_fail(experiment, "mount.motion", "needs a [clamp] or a [[support]], which moves with the mount");
}

/// Columns of a sensor in files of readings, with their unit. A reaction is a force and has three.
std::vector<std::string> sensor_columns(const SensorDeclaration& sensor) {
    switch (sensor.kind) {
        case SensorKind::reaction: return {sensor.name + "_x_N", sensor.name + "_y_N", sensor.name + "_z_N"};
        case SensorKind::chamber_volume: return {sensor.name + "_m3"};
        case SensorKind::tendon_tension: return {sensor.name + "_N"};
        case SensorKind::tendon_shortening: return {sensor.name + "_m"};
    }
    return {};
}

/// Names are unique, and `of` names a declared chamber or tendon.
void check_sensors(const Experiment& experiment) {
    std::vector<std::string> names, paths, chambers, tendons;
    for (const ChamberDeclaration& chamber : experiment.chambers) chambers.push_back(chamber.name);
    for (const TendonDeclaration& tendon : experiment.tendons) tendons.push_back(tendon.name);
    for (std::size_t i = 0; i < experiment.sensors.size(); ++i) {
        const SensorDeclaration& sensor = experiment.sensors[i];
        names.push_back(sensor.name);
        paths.push_back(toml::element_text("sensor", i) + ".name");
        if (sensor.kind == SensorKind::reaction) continue;
        const bool of_chamber = sensor.kind == SensorKind::chamber_volume;
        const std::vector<std::string>& known = of_chamber ? chambers : tendons;
        const std::string what = of_chamber ? "chamber" : "tendon";
        const std::string key = toml::element_text("sensor", i) + ".of";
        if (known.empty()) robot_fail(experiment, key, "there is no [[" + what + "]]");
        if (std::find(known.begin(), known.end(), sensor.of) == known.end())
            robot_fail(experiment, key,
                       "unknown " + what + " \"" + sensor.of + "\"; " + toml::suggest(sensor.of, known));
    }
    check_unique(experiment, names, paths);
}

/// Readings of a hold under the names of their columns; a sensor with one column may be named itself.
void check_readings(const Experiment& experiment, const std::string& path, TrialDeclaration& trial) {
    if (trial.sensors && experiment.sensors.empty())
        robot_fail(experiment, path + ".sensors", "there is no [[sensor]] that it could hold");
    std::vector<std::string> known;
    for (const SensorDeclaration& sensor : experiment.sensors)
        for (const std::string& column : sensor_columns(sensor)) known.push_back(column);
    std::map<std::string, double> by_column;
    // The name of a sensor and that of its column may both occur, which gives one reading twice.
    for (const auto& [name, value] : trial.sensor_values) {
        std::string column = name;
        for (const SensorDeclaration& sensor : experiment.sensors)
            if (sensor.name == name && sensor.kind != SensorKind::reaction) column = sensor_columns(sensor).front();
        const std::string key = path + ".sensor." + name;
        if (known.empty()) robot_fail(experiment, key, "there is no [[sensor]]");
        if (std::find(known.begin(), known.end(), column) == known.end())
            robot_fail(experiment, key, "is no column of a declared sensor; " + toml::suggest(column, known));
        if (!by_column.emplace(column, value).second) robot_fail(experiment, key, "is given twice");
    }
    trial.sensor_values = std::move(by_column);
}

/// A constant or curve names an actuator of the unit of its table that has no other command.
void check_constant(const Experiment& experiment, const std::string& path, const TrialDeclaration& trial,
                    const ConstantCommand& command) {
    const std::string key = path + "." + command.key + "." + command.actuator;
    const std::vector<Actuator> all = actuators(experiment);
    const std::optional<std::size_t> found = find_actuator(experiment, command.actuator);
    if (!found) {
        std::vector<std::string> names;
        for (const Actuator& actuator : all) names.push_back(actuator.name);
        if (names.empty()) robot_fail(experiment, key, "there is no [[muscle]], [[chamber]] or [[tendon]] to command");
        robot_fail(experiment, key, "unknown muscle, chamber or tendon; " + toml::suggest(command.actuator, names));
    }
    const Actuator& actuator = all[*found];
    // A value in the table of another unit would be wrong by orders of magnitude.
    if (const std::string wanted = constant_key(actuator.kind); wanted != command.key) {
        const bool tendon = actuator.kind == ActuatorKind::tendon_tension ||
                            actuator.kind == ActuatorKind::tendon_shortening;
        const std::string drive = actuator.kind == ActuatorKind::tendon_tension ? "tension" : "shortening";
        robot_fail(experiment, key,
                   (tendon ? "this tendon is driven by " + drive : "this is a " + actuator_key(actuator)) +
                       "; its constant stands in " + wanted);
    }
    if (actuator.kind == ActuatorKind::muscle) {
        const MuscleDeclaration& muscle = experiment.muscles[actuator.index];
        if (muscle.follows)
            robot_fail(experiment, key,
                       "this muscle follows \"" + muscle.follows->muscle + "\" and has no actuation of its own");
        if (muscle.signal) robot_fail(experiment, key, "this muscle has a signal of its own");
    }
    for (const ActuationStep& step : trial.actuation_steps)
        if (step.muscle == command.actuator) robot_fail(experiment, key, "has a step in actuation_step already");
}

}  // namespace

void check_robot_parts(Experiment& experiment) {
    check_actuator_names(experiment);
    check_geometry(experiment);
    check_mount(experiment);
    check_sensors(experiment);
    for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
        TrialDeclaration& trial = experiment.trials[i];
        const std::string path = toml::element_text("trial", i);
        for (const ConstantCommand& command : trial.constant_commands) check_constant(experiment, path, trial, command);
        check_readings(experiment, path, trial);
    }
}

}  // namespace myo::experiment
