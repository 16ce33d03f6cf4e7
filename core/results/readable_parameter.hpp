#pragma once

#include <string>

#include "prediction/prediction.hpp"

namespace myo::results {

/// A parameter as a person reads it, in the report and in the window.
struct ReadableParameter {
    std::string name;     // "Young’s modulus E"
    std::string unit;     // "kPa"; empty for a plain number
    double factor = 1.0;  // shown = factor * SI value
};
ReadableParameter readable_parameter(const prediction::ModelParameter& parameter, const setup::Setup& setup);

/// A name that ends in its SI unit: "coefficient_kg_m3" is "coefficient" in kg/m³.
ReadableParameter readable_quantity(const std::string& name);

/// "quadratic_drag" -> "Quadratic drag".
std::string effect_name(const std::string& id);

}  // namespace myo::results
