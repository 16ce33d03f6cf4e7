#pragma once

#include <string>

namespace myo::effect {

/// A quantity as it is shown in reports and in the window.
struct ReadableQuantity {
    std::string name;     // "Young's modulus E"
    std::string unit;     // "kPa"; empty for a plain number
    double factor = 1.0;  // shown value = factor * SI value
};

/// Name and unit from a name that ends in its SI unit: "coefficient_kg_m3" is "coefficient" in kg/m³.
ReadableQuantity readable_quantity(const std::string& name);

/// Readable name of an effect: "quadratic_drag" -> "Quadratic drag".
std::string effect_name(const std::string& id);

}  // namespace myo::effect
