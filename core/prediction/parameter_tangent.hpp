#pragma once

#include <optional>

#include "prediction/prediction.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::prediction {

/// Whether a number changes the motion of a trial.
bool moves_the_body(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                    const ModelParameter& parameter);

/// What a number does to a trial's model; where effects act it is told by the models on both sides, as they may change
/// anything in them: see affected_tangent().
std::optional<sensitivity::ModelTangent> parameter_tangent(const setup::Setup& setup, std::size_t trial,
                                                           const ParameterValues& values,
                                                           const ModelParameter& parameter);

/// A change of a number that is `part` of what matters of it.
double difference_step(const ModelParameter& parameter, double value, double part);

}  // namespace myo::prediction
