#pragma once

#include <string>

#include "effect/readable_quantity.hpp"
#include "prediction/prediction.hpp"

namespace myo::results {

/// A parameter as it is shown in reports and in the window.
using ReadableParameter = effect::ReadableQuantity;
using effect::effect_name;
using effect::readable_quantity;

/// Name, unit and factor of a fitted parameter.
/// Shown value = factor times the SI value.
ReadableParameter readable_parameter(const prediction::ModelParameter& parameter, const setup::Setup& setup);

}  // namespace myo::results
