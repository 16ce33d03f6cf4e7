#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/box.hpp"
#include "effect/effect_declaration.hpp"
#include "fibre/painted_mask.hpp"

// What an experiment declares in addition to body, support, markers and trials, as the window shows and edits it. SI
// units, mesh frame.

namespace myo::ui::commands {

/// Effects of the experiment, and what can be added to it.
struct SceneEffects {
    std::vector<effect::EffectDeclaration> declared;  // in the order of the declaration
    std::vector<effect::EffectDeclaration> offered;   // the catalogue, with start values of all parameters
    std::vector<std::string> lacking;                 // per offered one: "a tendon"; empty: it can act
    std::vector<std::string> actuators;               // names that parameters may have
};

/// Rigid half-space.
struct ScenePlane {
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, towards the body
};
/// Rigid sphere.
struct SceneSphere {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    double radius_m = 0.0;
};
/// Rigid obstacle that stands still.
struct SceneObstacle {
    std::variant<ScenePlane, SceneSphere, Box> shape;
    double friction = 0.0;  // Coulomb coefficient
};

/// Part of the body with a material of its own.
struct ScenePart {
    std::string name;
    // Where it is: one of these four.
    std::optional<Box> box_m;
    std::filesystem::path file;                      // closed surface, resolved; empty: none
    std::optional<int> region;                       // number of its cells
    std::shared_ptr<const fibre::PaintedMask> mask;  // painted; empty if its file cannot be read
    double youngs_modulus_Pa = 0.0;
    double youngs_modulus_tolerance = 0.0;  // relative half-width of a fit
    double poissons_ratio = 0.0;
    double density_kg_m3 = 0.0;
    std::optional<double> damping_s;      // empty: the body's
    std::vector<std::string> calibrated;  // of youngs_modulus, damping
};

}  // namespace myo::ui::commands
