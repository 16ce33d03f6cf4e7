#pragma once

#include <string>

#include "prediction/prediction.hpp"

namespace myo::results {

/// A parameter as it is shown in reports and in the window.
struct ReadableParameter {
    std::string name;     // "Young’s modulus E"
    std::string unit;     // "kPa"; empty for a plain number
    double factor = 1.0;  // shown value = factor * SI value
};
/// Name, unit and factor of a fitted parameter.
ReadableParameter readable_parameter(const prediction::ModelParameter& parameter, const setup::Setup& setup);

/// Name and unit from a name that ends in its SI unit: "coefficient_kg_m3" is "coefficient" in kg/m³.
ReadableParameter readable_quantity(const std::string& name);

/// Readable name of an effect: "quadratic_drag" -> "Quadratic drag".
std::string effect_name(const std::string& id);

}  // namespace myo::results
