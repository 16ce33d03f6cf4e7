#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Virtual work p . dW/dx of the internal energy along motions p, split into the parameters it is linear in: its
/// derivatives with respect to them, positions and strain rate held.
struct ModuliWork {
    std::vector<material::Moduli> elastic;  // per cell, per unit of mu and of kappa [m3]
    std::vector<double> viscous;            // per cell, per unit of damping times mu [m3/s]
};
ModuliWork no_moduli_work(const Model& model);

/// Adds the work of elastic and viscous forces at x (3 x n) along p (3 x n). rate.history null: no viscous part.
void add_moduli_work(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& p, const StrainRate& rate,
                     ModuliWork& work);

/// The work of the fibres per group.
struct FibreWork {
    std::vector<double> by_activation;  // derivative with respect to a [J]
    std::vector<double> by_stiffness;   // with respect to w [m3]
    std::vector<std::vector<Eigen::VectorXd>>
        by_shape;  // per group and point, with respect to FibrePoint::shape; empty unless asked for
};
FibreWork no_fibre_work(const Model& model, bool with_shapes);

/// activation: per group. Shapes are filled in when `work` has room for them.
void add_fibre_work(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& p,
                    const std::vector<double>& activation, FibreWork& work);

}  // namespace myo::model
