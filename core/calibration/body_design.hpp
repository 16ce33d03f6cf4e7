#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calibration/sought_items.hpp"
#include "fibre/painted_mask.hpp"
#include "inverse/design.hpp"
#include "setup/setup.hpp"

namespace myo::calibration {

/// A quantity of the body that is sought, and what its values mean.
struct DesignedItem {
    SoughtItem item;
    std::size_t variable = 0;  // in BodyDesign::variables
    Eigen::Index value = 0;    // moduli: its value among those of the variable
    std::size_t index = 0;     // of the muscle or part in the experiment; without meaning for the body's material
    fibre::CellPaint paint{};  // of a painted muscle as declared; empty: the muscle is a box or has one direction
};

/// What a search may change of a body; empty if it seeks signals only.
struct BodyDesign {
    inverse::Design variables;
    std::vector<DesignedItem> items;  // what the values of the variables mean, in the order of muscles, then moduli
};

/// Design variables of a setup for the sought items other than signals. In the models of all trials, fibres of painted
/// muscles become such as a mask painted on this mesh gives, and those whose weights are sought get points without
/// volume in the cells next to their paint, into which they may grow.
///
/// Errors: a mesh of truncated voxels, on which paint has no place of its own; a muscle without material on the mesh.
Result<BodyDesign> body_design(setup::Setup& setup, const std::vector<SoughtItem>& seek);

/// The setup with these values of the design in the models of all trials; the models must have the declared ones.
///
/// @param values  of all variables, one after another; dimensionless, see inverse::DesignVariable
setup::Setup with_design(setup::Setup setup, const inverse::Design& design, const Eigen::VectorXd& values);

/// A value of the experiment that a search changed.
struct FoundItem {
    SoughtItem item;
    std::size_t index = 0;                                // as in DesignedItem
    std::optional<Eigen::Vector3d> fibre = {};            // the one direction of a muscle, unit
    std::shared_ptr<const fibre::PaintedMask> mask = {};  // paint of a muscle, directions and weights; else null
    double youngs_modulus_Pa = 0.0;                       // of a part or the body's material; 0: of a muscle
    // The change in one number: largest angle of a direction from the declared one, volume of a muscle, modulus.
    double before = 0.0, after = 0.0;
    std::string unit = {};    // "°", "cm³", "kPa"
    std::string change = {};  // for people: "turned by up to 23°", "from 270 to 310 kPa"
};

/// What the values mean for the experiment, in the order of BodyDesign::items. A muscle whose direction and weights
/// were sought has both in one mask, in each of its items.
std::vector<FoundItem> found_items(const setup::Setup& setup, const BodyDesign& design, const Eigen::VectorXd& values);

}  // namespace myo::calibration
