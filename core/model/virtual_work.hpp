#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Virtual work p . dW/dx along nodal motions p by parameters in which the internal energy is linear: the derivatives
/// with respect to them at fixed positions and strain rate.
struct ModuliWork {
    std::vector<material::Moduli> elastic;  // [m3] per cell, per unit of mu and of kappa
    std::vector<double> viscous;            // [m3/s] per cell, per unit of damping times mu
};
/// Zero work for all cells of a model, to be passed to add_moduli_work().
ModuliWork no_moduli_work(const Model& model);

/// Adds the work of elastic and viscous forces.
/// @param x, p  node positions [m] and motions, 3 x n
/// @param rate  history null: no viscous part
void add_moduli_work(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& p, const StrainRate& rate,
                     ModuliWork& work);

/// Virtual work of the fibres by parameters.
struct FibreWork {
    std::vector<double> by_activation;  // per group: derivative by activation a [J]
    std::vector<double> by_stiffness;   // per group: derivative by stiffness w [m3]
    // per group and point: derivative by FibrePoint::shape; empty unless requested
    std::vector<std::vector<Eigen::VectorXd>> by_shape;
    std::vector<std::vector<double>> by_volume;  // likewise by FibrePoint::volume [J/m3]
};
/// Zero work for all fibre groups.
/// @param at_points  also allocate by_shape and by_volume
FibreWork no_fibre_work(const Model& model, bool at_points);

/// Adds the work of the fibres.
///
/// by_shape and by_volume are computed only if `work` has them allocated.
///
/// @param x, p        node positions [m] and motions, 3 x n
/// @param activation  per group
void add_fibre_work(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& p,
                    const std::vector<double>& activation, FibreWork& work);

}  // namespace myo::model
