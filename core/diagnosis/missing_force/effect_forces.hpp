#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "prediction/prediction.hpp"

namespace myo::diagnosis {

/// Nodal forces at several times of a motion.
struct NodalForces {
    std::vector<double> times_s;
    std::vector<Eigen::Matrix3Xd> force_N;  // per time, 3 x n; zero on clamped nodes
    std::string failure;                    // reason why there are none; empty: computed
};

/// Forces that effects add along a motion: those of the model with the effects minus those without, inertia included,
/// (f1 - M1 a) - (f0 - M0 a). Along the motion of the model with the effects this is the force with which the model
/// without them moves equally (d'Alembert).
///
/// Zero for effects of measurement and start. Creep and softening depend on the past motion and have no instantaneous
/// force: failure.
/// @param first   index of the first effect in values.effects; it and all later ones are the effects
/// @param motion  with velocities; accelerations are their central differences
/// @param most    approximate number of times, evenly over the steps of the motion
NodalForces effect_forces(const setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                          std::size_t first, const dynamics::Trace& motion, int most);

/// Nodes of a body in cubes of equal size, for display; the forces in a cube are summed.
struct BodyPatches {
    Eigen::VectorXi patch_of_node;  // n, 0 ... count - 1
    int count = 0;

    /// Sums over the nodes of each cube, 3 x count; of_nodes 3 x n.
    Eigen::Matrix3Xd sums(const Eigen::Matrix3Xd& of_nodes) const;
};
/// Cubes whose size is chosen so that about `about` of them fill the body.
BodyPatches body_patches(const model::Body& body, int about);
/// The patches of a body on another mesh of it: those of the nearest nodes.
BodyPatches patches_on(const model::Body& other, const model::Body& body, const BodyPatches& patches);

}  // namespace myo::diagnosis
