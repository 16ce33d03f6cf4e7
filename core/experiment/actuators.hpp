#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment.hpp"

namespace myo::experiment {

/// What drives a body; a tendon counts by its drive.
enum class ActuatorKind { muscle, chamber, tendon_tension, tendon_shortening };

/// Something that a signal drives.
struct Actuator {
    ActuatorKind kind = ActuatorKind::muscle;
    std::size_t index = 0;  // in Experiment::muscles, chambers or tendons
    std::string name;
    std::string column;  // in an actuation file: "<muscle>", "<chamber>_Pa", "<tendon>_N", "<tendon>_m"
    std::string unit;    // of the signal: "" for an activation, "Pa", "N", "m"
    double rest = 0.0;   // value without a command: 1 for a muscle, else 0
    bool sought = true;  // `sought` of its declaration
};

/// All actuators: muscles, then chambers, then tendons, each in the order of declaration.
/// Tables of actuation and rows of signals use this order everywhere.
std::vector<Actuator> actuators(const Experiment& experiment);

/// Index into actuators() of the actuator with this name, not of that with this column; empty if there is none.
std::optional<std::size_t> find_actuator(const Experiment& experiment, const std::string& name);

/// Table of a trial for constants of a kind: "activation", "pressure_Pa", "tension_N", "shortening_m".
std::string constant_key(ActuatorKind kind);
/// What the signal of a kind is: "activation", "pressure", "tension", "shortening".
std::string quantity_word(ActuatorKind kind);

}  // namespace myo::experiment
