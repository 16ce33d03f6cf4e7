#pragma once

#include <optional>

#include "prediction/prediction.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::prediction {

/// Whether a parameter changes the motion of a trial, so that its derivative needs the tangent of the simulation.
///
/// @param trial  index into Setup::trials
bool moves_the_body(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                    const ModelParameter& parameter);

/// Derivative of a trial's model with respect to a parameter that moves the body.
///
/// Exact for modulus, damping, levels, parameters of the law and numbers of effects that state their derivative. Of
/// others, with effects, it is a difference of the models at both
/// sides of the value, see affected_tangent().
/// @return  empty if the difference cannot be expressed as a model tangent
std::optional<sensitivity::ModelTangent> parameter_tangent(const setup::Setup& setup, std::size_t trial,
                                                           const ParameterValues& values,
                                                           const ModelParameter& parameter);

/// Step of a finite difference: `part` times the scale of the parameter, or times its value if it is scaled
/// logarithmically.
double difference_step(const ModelParameter& parameter, double value, double part);

}  // namespace myo::prediction
