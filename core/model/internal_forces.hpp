#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/model.hpp"

namespace myo::model {

/// Strain rate of a time step as a function of its end position: rate = factor * strain(x) + history.
struct StrainRate {
    double factor = 0.0;                       // [1/s]
    const Eigen::VectorXd* history = nullptr;  // [1/s] strain_count entries; null: no viscous part
};

/// Moduli with which the internal energy is evaluated: those of the model or, since the energy is linear in them, their
/// derivative with respect to a parameter.
struct Stiffness {
    material::MaterialPointer law = {};     // instead of the model's, for the derivative by a parameter of it
    std::vector<material::Moduli> elastic;  // [Pa] per cell; empty: no elastic part
    Eigen::VectorXd elastic_factors;        // scale the elastic moduli at the points; empty: 1
    std::vector<material::Moduli>
        viscous;                      // viscous_scale() times moduli per cell [Pa s], or [Pa] with creep; empty: none
    Eigen::VectorXd viscous_factors;  // scale the viscous moduli at the points; empty: 1
    bool fibres = true;               // include the fibres
};
/// Moduli of the model itself.
Stiffness stiffness(const Model& model);

/// Ratio of viscous moduli to elastic moduli of a cell.
///
/// @return  the damping time of the cell [s]; 1 for a body with creep, because its rates are combinations of strain
///          rates and strains that already contain their factors
double viscous_scale(const Model& model, std::size_t cell);
/// Whether any cell has Kelvin-Voigt damping.
bool is_viscous(const Model& model);

/// Product of two fields of factors at the points; an empty field is 1.
Eigen::VectorXd times_factors(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Second derivatives requested from an energy.
enum class HessianKind {
    none,
    exact,
    positive_fibres,  // fibres clipped to positive semidefinite: sufficient for fibres in compression
    positive,         // in addition the matrix of each cell projected
};

/// Energy with its derivatives.
struct InternalEnergy {
    double energy = 0.0;              // [J]
    Eigen::Matrix3Xd gradient;        // dW/dx, minus the internal forces, 3 x n [N]; not zero on clamped nodes
    solver::SymmetricSparse hessian;  // over the free unknowns [N/m]; empty unless requested
};

/// Input of internal_energy().
struct InternalInput {
    const Stiffness* stiffness = nullptr;             // required
    const std::vector<double>* activation = nullptr;  // per fibre group; required with fibres
    StrainRate rate;                                  // used if stiffness->viscous is not empty
    const Eigen::VectorXd* pressure = nullptr;        // volume_points entries, see PackInput; null: current pressure
};

/// Elastic, viscous and fibre energy with its derivatives.
///
/// @param x        node positions, 3 x n [m]
/// @param hessian  second derivatives to compute
/// Errors: none. An inverted cell gives non-finite values; the solver rejects the step.
InternalEnergy internal_energy(const Model& model, const Eigen::Matrix3Xd& x, const InternalInput& input,
                               HessianKind hessian);

/// Pressures of all volume points at x, for the elastic moduli of `stiffness`.
///
/// @param x  node positions, 3 x n [m]
/// @return   U'(theta) [Pa], volume_points entries; zero for laws without volumetric split
Eigen::VectorXd pressures(const Model& model, const Stiffness& stiffness, const Eigen::Matrix3Xd& x);
/// Linear prediction of pressures() at x + dx: U'(theta) + U''(theta) dtheta/dx dx.
///
/// @param dx  displacement, 3 x n [m]
/// @return    [Pa], volume_points entries
Eigen::VectorXd predicted_pressures(const Model& model, const Stiffness& stiffness, const Eigen::Matrix3Xd& x,
                                    const Eigen::Matrix3Xd& dx);

/// Green strains of all points.
///
/// @param x  node positions, 3 x n [m]
/// @return   strain_count entries in the layout of PackedCells; xx, yy, zz, xy, yz, zx per point
Eigen::VectorXd strains(const Model& model, const Eigen::Matrix3Xd& x);
/// Derivative of strains() along a displacement.
///
/// @param dx  3 x n [m]
/// @return    strain_count entries
Eigen::VectorXd strain_tangent(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& dx);

/// Gradient of the viscous energy for a given strain rate; linear in the rate.
///
/// @param rate  strain_count entries [1/s]
/// @return      3 x n [N]
Eigen::Matrix3Xd viscous_gradient(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rate);

/// Derivative of the gradient along a change of the activations, 3 x n [N]. The gradient is linear in the activations,
/// so their values are not needed.
/// @param d_activation  per fibre group
Eigen::Matrix3Xd activation_gradient(const Model& model, const Eigen::Matrix3Xd& x,
                                     const std::vector<double>& d_activation);

}  // namespace myo::model
