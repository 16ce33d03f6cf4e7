#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/model.hpp"

namespace myo::model {

/// The strain rate of a step as a function of its end: rate = factor * strain(x) + history (strain_count entries).
struct StrainRate {
    double factor = 0.0;
    const Eigen::VectorXd* history = nullptr;
};

/// Stiffness the internal energy is evaluated with. It is the model's own, or, because the energy is linear in it,
/// a derivative of it with respect to a parameter.
struct Stiffness {
    std::vector<material::Moduli> elastic;  // per cell; empty: left out
    Eigen::VectorXd elastic_factors;        // of them, at the body's points; empty: 1
    std::vector<material::Moduli>
        viscous;  // viscous_scale() times moduli, per cell [Pa s], or [Pa] of a creeping body; empty: left out
    Eigen::VectorXd viscous_factors;  // of them, at the body's points; empty: 1
    bool fibres = true;
};
Stiffness stiffness(const Model& model);

/// What viscous stresses are besides 2 mu dev(rate): the damping [s]. Of a creeping body 1, as its rates are sums of
/// strain rates and strains that have their factors with them.
double viscous_scale(const Model& model);

/// Products of factors at the points, where empty ones are 1.
Eigen::VectorXd times_factors(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

enum class HessianKind {
    none,
    exact,
    positive_fibres,  // that of the fibres projected on the positive semi-definite ones: enough where muscles push
    positive,         // each cell's matrix projected, too
};

struct InternalEnergy {
    double energy = 0.0;              // [J]
    Eigen::Matrix3Xd gradient;        // dW/dx = minus the internal forces, 3 x n [N]; not zero on clamped nodes
    solver::SymmetricSparse hessian;  // over the free unknowns [N/m]; empty unless asked for
};

struct InternalInput {
    const Stiffness* stiffness = nullptr;
    const std::vector<double>* activation = nullptr;  // per fibre group
    StrainRate rate;                                  // used when stiffness->viscous is not empty
    const Eigen::VectorXd* pressure = nullptr;        // volume_points entries; see PackInput
};

/// Elastic, viscous and fibre energy at the positions x (3 x n [m]) with its derivatives.
/// Errors: none. An inverted cell gives non-finite values; the solver rejects the step.
InternalEnergy internal_energy(const Model& model, const Eigen::Matrix3Xd& x, const InternalInput& input,
                               HessianKind hessian);

/// U'(theta) of every volume point at x for the elastic moduli of a stiffness, and its linear prediction at x + dx.
Eigen::VectorXd pressures(const Model& model, const Stiffness& stiffness, const Eigen::Matrix3Xd& x);
Eigen::VectorXd predicted_pressures(const Model& model, const Stiffness& stiffness, const Eigen::Matrix3Xd& x,
                                    const Eigen::Matrix3Xd& dx);

/// Green strains of all points at x, and their derivative along dx.
Eigen::VectorXd strains(const Model& model, const Eigen::Matrix3Xd& x);
Eigen::VectorXd strain_tangent(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& dx);

/// Gradient of the viscous energy for a given strain rate, 3 x n [N]; linear in the rate.
Eigen::Matrix3Xd viscous_gradient(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rate);

/// Derivative of the gradient with respect to the activations along d_activation (per group), 3 x n [N]; it is
/// linear in the activations, so their values do not matter.
Eigen::Matrix3Xd activation_gradient(const Model& model, const Eigen::Matrix3Xd& x,
                                     const std::vector<double>& d_activation);

}  // namespace myo::model
