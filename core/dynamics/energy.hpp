#pragma once

#include <Eigen/Core>

#include "model/internal_forces.hpp"
#include "model/model.hpp"

namespace myo::dynamics {

/// Mechanical energy of a state. The loads are those of one instant and count as dead loads.
struct Energy {
    double kinetic_J = 0.0;
    double internal_J = 0.0;  // material, fibres and force elements; not finite where
                              // the law is not defined, e.g. at an inverted cell
    double work_J = 0.0;      // of gravity and active forces, from the rest shape to x

    /// Constant in time for a conservative body under constant loads and activations; damping only reduces it.
    double total_J() const { return kinetic_J + internal_J - work_J; }
};

/// Energy of a state of the virgin (unsoftened) body.
///
/// @param mass    mass_matrix(model)
/// @param x       node positions, 3 x n [m], world frame
/// @param v       node velocities, 3 x n [m/s]
/// @param time_s  instant of the loads and activations
/// @param before  at a jump, take loads and activations from the left of `time_s`
Energy energy(const model::Model& model, const model::MassMatrix& mass, const Eigen::Matrix3Xd& x,
              const Eigen::Matrix3Xd& v, double time_s, bool before = false);

/// Energy of a state for the given cell stiffness, e.g. that of a softened body. Parameters as above.
Energy energy(const model::Model& model, const model::Stiffness& stiffness, const model::MassMatrix& mass,
              const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double time_s, bool before = false);

}  // namespace myo::dynamics
