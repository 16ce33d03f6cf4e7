#pragma once

#include "inverse/design.hpp"

namespace myo::inverse {

struct PartModuliPolicy {
    /// Largest factor either way: cured silicones span from some ten kPa to about a MPa (Marechal et al. 2021, "Toward
    /// a common framework and database of materials for soft robotics").
    double most = 10.0;
};
inline constexpr PartModuliPolicy part_moduli_policy;

/// A material of the body whose modulus is sought.
struct SoughtModulus {
    std::string name;                     // of the part
    std::vector<material::Moduli> share;  // what it adds to the moduli of each cell as declared [Pa]
};

/// Young's moduli of parts of the body. Each value is the logarithm of a modulus over the declared one.
///
/// @param rest  what the other parts add to the moduli of each cell [Pa]
DesignVariablePointer part_moduli(std::vector<SoughtModulus> parts, std::vector<material::Moduli> rest);

}  // namespace myo::inverse
