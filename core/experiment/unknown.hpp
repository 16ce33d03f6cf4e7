#pragma once

#include <optional>
#include <string>

namespace myo::experiment {

/// Declared bounds of a value that a fit may find, in the unit of its name.
struct UnknownDeclaration {
    std::string name;              // as in results: "damping_s", "spine.youngs_modulus_Pa", "actuation_level.bend.left"
    std::optional<double> lowest;  // empty: as without the declaration
    std::optional<double> highest;    // empty: as without the declaration
    std::optional<double> tolerance;  // half-width about the declared value; excludes the other two
};

}  // namespace myo::experiment
