#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace myo::effect {

/// Value of a parameter: number, vector, one name (marker, trial) or several names (the markers of marker_swap).
using EffectParameter = std::variant<double, Eigen::VectorXd, std::string, std::vector<std::string>>;
/// Values by parameter name. Vectors and positions are in the mesh frame of the rest shape.
using EffectParameters = std::map<std::string, EffectParameter>;

/// An effect with its parameter values: declared by an experiment, or a candidate of a diagnosis.
struct EffectDeclaration {
    std::string id;
    EffectParameters parameters;
    bool calibrate = false;  // the parameters are fitted

    /// Whether id, all values and calibrate agree; vectors may differ in length.
    bool operator==(const EffectDeclaration& other) const;
};

}  // namespace myo::effect
