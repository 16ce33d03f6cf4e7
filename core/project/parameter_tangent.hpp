#pragma once

#include <optional>

#include "project/prediction.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo {

/// Whether a number changes the motion of a trial.
bool moves_the_body(const Study& study, std::size_t trial, const StudyValues& values, const StudyParameter& parameter);

/// What a number does to a trial's model; where effects act it is told by the models on both sides, as they may change anything in them: see
/// affected_tangent().
std::optional<ModelTangent> parameter_tangent(const Study& study, std::size_t trial, const StudyValues& values, const StudyParameter& parameter);

/// A change of a number that is `part` of what matters of it.
double difference_step(const StudyParameter& parameter, double value, double part);

}  // namespace myo
