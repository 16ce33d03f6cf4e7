#pragma once

#include <Eigen/Core>

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace myo::effect {

/// Value of a parameter: number, vector, one name (marker, trial) or several names (the markers of marker_swap).
using EffectParameter = std::variant<double, Eigen::VectorXd, std::string, std::vector<std::string>>;
/// Values by parameter name. Vectors and positions are in the mesh frame of the rest shape.
using EffectParameters = std::map<std::string, EffectParameter>;

struct Effect;
/// An entry that an experiment adds to the catalogue by a file of its own.
using LawPointer = std::shared_ptr<const Effect>;
/// All entries that an experiment adds, in the order of their files.
using Laws = std::vector<LawPointer>;

/// An effect with its parameter values: declared by an experiment, or a candidate of a diagnosis.
struct EffectDeclaration {
    std::string id;
    EffectParameters parameters;
    bool calibrate = false;  // the parameters are fitted
    LawPointer law{};        // its entry if a file of the experiment states it; null: the catalogue has it

    /// Whether id, all values and calibrate agree, whatever the law; vectors may differ in length.
    bool operator==(const EffectDeclaration& other) const;
};

}  // namespace myo::effect
