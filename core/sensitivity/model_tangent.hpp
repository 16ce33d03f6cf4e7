#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "model/force_element.hpp"
#include "model/internal_forces.hpp"
#include "model/model.hpp"
#include "sensitivity/model_change.hpp"

namespace myo::sensitivity {

/// Derivative of a model with respect to one parameter. Empty parts are zero.
struct ModelTangent {
    std::vector<material::Moduli> moduli;  // per cell, the factors at the points held
    double damping_s = 0.0;
    std::vector<fibre::Signal> activation;        // per fibre group: d a(t)
    std::vector<Eigen::VectorXd> force_elements;  // per element: change of its parameters; empty ones are zero
    std::shared_ptr<const ModelPair> between;     // for what has no part above: the models on both sides; null: nothing
    Eigen::Matrix3Xd start_m;                     // 3 x n, of positions of one's own at the start [m per unit]
};

/// d/dE: the moduli over E. Asserts youngs_modulus_Pa > 0.
ModelTangent youngs_modulus_tangent(const model::Model& model, double youngs_modulus_Pa);

/// d/d damping.
ModelTangent damping_tangent();

/// Derivative of the gradient of the force elements along the parameter, positions and velocities held, 3 x n.
Eigen::Matrix3Xd force_element_tangent(const model::Model& model, const ModelTangent& tangent,
                                       const model::ForceState& at);

/// Derivative of the stiffness along the parameter: the energy is linear in the moduli and in damping times moduli. The
/// damping of a creeping body is not among them: it changes the rate.
model::Stiffness stiffness_tangent(const model::Model& model, const ModelTangent& tangent);

/// Derivative of the activations along the parameter, per fibre group; empty: zero.
std::vector<double> activation_tangent(const ModelTangent& tangent, double time_s, bool before_jump);

/// Derivative of the gradient dW/dx of material and fibres along the parameter, positions and strain rate held, 3 x n
/// [N per unit of the parameter].
Eigen::Matrix3Xd gradient_tangent(const model::Model& model, const ModelTangent& tangent, const Eigen::Matrix3Xd& x,
                                  const Eigen::VectorXd& rate, double time_s, bool before_jump);

}  // namespace myo::sensitivity
