#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment.hpp"
#include "model/model.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::setup {

// Actuators of an experiment are numbered: muscles first, then chambers, then tendons, each in the order of
// declaration. The signals of muscles are Model::activation; those of chambers and tendons are the commands of the
// first force elements of the model, in this order.

/// Names in the order of the numbers.
std::vector<std::string> actuator_names(const experiment::Experiment& experiment);

/// Index into Model::force_elements of an actuator; empty for a muscle.
std::optional<std::size_t> actuator_element(const experiment::Experiment& experiment, std::size_t actuator);

/// Signal of an actuator in a model of a trial: activation [-], pressure [Pa], tension [N] or shortening [m] over trial
/// time. Refers to the model.
const fibre::Signal& actuator_signal(const experiment::Experiment& experiment, const model::Model& model,
                                     std::size_t actuator);

/// Value of a signal at which the actuator does nothing: 1 of a muscle, 0 of a chamber or tendon.
double passive_level(const experiment::Experiment& experiment, std::size_t actuator);

/// Unit of a signal, empty of a muscle; see experiment::Actuator.
std::string signal_unit(const experiment::Experiment& experiment, std::size_t actuator);

/// Replaces the signal of an actuator, and of the muscles that follow it, by a step at t = 0 from passive to `level`.
void set_level(const experiment::Experiment& experiment, std::size_t actuator, double level, model::Model& model);

/// Derivative of a model after set_level() with respect to the level; exact.
sensitivity::ModelTangent level_model_tangent(const experiment::Experiment& experiment, std::size_t actuator,
                                              const model::Model& model);

/// Range and scale of a level that a fit may change.
struct LevelBounds {
    double lower = 0.0, upper = 0.0, scale = 1.0;  // in the unit of the signal
};
/// Bounds of the level of an actuator: physical limits of a chamber's pressure or a tendon's command, wide ones of a
/// muscle's activation. A chamber's depend on the modulus of the material.
LevelBounds level_bounds(const experiment::Experiment& experiment, std::size_t actuator);

}  // namespace myo::setup
