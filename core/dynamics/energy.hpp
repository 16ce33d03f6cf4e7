#pragma once

#include <Eigen/Core>

#include "model/internal_forces.hpp"
#include "model/model.hpp"

namespace myo::dynamics {

/// Mechanical energy of a state under the loads of one moment, all dead.
struct Energy {
    double kinetic_J = 0.0;
    double internal_J = 0.0;  // of the material, the fibres and the force elements; not finite where the law knows no
                              // such deformation
    double work_J = 0.0;      // of gravity and the active forces along the way from the rest shape

    /// Constant in time for a conservative body under constant loads and activations; dampers only take from it.
    double total_J() const { return kinetic_J + internal_J - work_J; }
};

/// @param mass  mass_matrix(model)
/// @param x     node positions, 3 x n [m]
/// @param v     node velocities, 3 x n [m/s]
/// before: loads and activations are taken from the left of `time_s`.
Energy energy(const model::Model& model, const model::MassMatrix& mass, const Eigen::Matrix3Xd& x,
              const Eigen::Matrix3Xd& v, double time_s, bool before = false);

/// The same of cells with another stiffness than the virgin one.
Energy energy(const model::Model& model, const model::Stiffness& stiffness, const model::MassMatrix& mass,
              const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double time_s, bool before = false);

}  // namespace myo::dynamics
