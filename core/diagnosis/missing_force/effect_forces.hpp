#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "prediction/prediction.hpp"

namespace myo::diagnosis {

/// Forces on a body's nodes at moments of a motion.
struct NodalForces {
    std::vector<double> times_s;
    std::vector<Eigen::Matrix3Xd> force_N;  // per time, 3 x n; zero on nodes that are held
    std::string failure;                    // why there are none; empty when there are
};

/// What effects add to the forces on the body, moment by moment of a motion: that of the model with them less that of
/// the model without, inertia included: (f1 - M1 a) - (f0 - M0 a). Along the motion of the model with them it is the
/// force that would have to act on the model without for it to move alike (d'Alembert).
///
/// Zero for effects of the measurement and of the start. What a body remembers (creep, softening) has no force of the
/// moment: failure.
/// @param first   of values.effects: these and those behind it are the effects
/// @param motion  with velocities; accelerations are their central differences
/// @param most    about so many moments, evenly over the motion's steps
NodalForces effect_forces(const setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                          std::size_t first, const dynamics::Trace& motion, int most);

/// A body's nodes in cubes of one size, for pictures: forces within each are added up.
struct BodyPatches {
    Eigen::VectorXi patch_of_node;  // n, 0 ... count - 1
    int count = 0;

    /// Sums over the nodes of each, 3 x count.
    Eigen::Matrix3Xd sums(const Eigen::Matrix3Xd& of_nodes) const;
};
/// Cubes of the size at which about `about` fill the body.
BodyPatches body_patches(const model::Body& body, int about);

}  // namespace myo::diagnosis
