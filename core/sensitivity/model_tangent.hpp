#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "model/force_element.hpp"
#include "model/internal_forces.hpp"
#include "model/model.hpp"
#include "sensitivity/model_change.hpp"

namespace myo::sensitivity {

/// Derivative of a model with respect to one parameter. Empty members are zero.
struct ModelTangent {
    std::vector<material::Moduli> moduli;         // per cell; the factors at the points are held
    double damping_s = 0.0;                       // derivative of the damping time
    std::optional<std::size_t> law = {};          // parameter of the constitutive law that changes, with unit rate
    std::vector<fibre::Signal> activation;        // per fibre group: d a(t)
    std::vector<Eigen::VectorXd> force_elements;  // per element: derivative of its parameters
    std::shared_ptr<const ModelPair>
        between;               // models on both sides, for parameters that have no member above; null: none
    Eigen::Matrix3Xd start_m;  // 3 x n [m per unit]: derivative of given start positions
};

/// Tangent with respect to Young's modulus at fixed Poisson's ratio: moduli / E. Asserts youngs_modulus_Pa > 0.
ModelTangent youngs_modulus_tangent(const model::Model& model, double youngs_modulus_Pa);

/// Tangent with respect to the damping time [s].
ModelTangent damping_tangent();

/// Tangent with respect to parameter k of the constitutive law.
ModelTangent law_tangent(std::size_t k);

/// Derivative of the energy gradient of the force elements along the parameter, 3 x n [N per unit]; positions and
/// velocities are held.
Eigen::Matrix3Xd force_element_tangent(const model::Model& model, const ModelTangent& tangent,
                                       const model::ForceState& at);

/// Derivative of the stiffness along the parameter. The energy is linear in the moduli and in damping times moduli. For
/// a creeping body damping is not included, because it changes the effective rate.
model::Stiffness stiffness_tangent(const model::Model& model, const ModelTangent& tangent);

/// Derivative of the activations at `time_s` along the parameter, per fibre group; empty: zero.
std::vector<double> activation_tangent(const ModelTangent& tangent, double time_s, bool before_jump);

/// Derivative of the gradient dW/dx of material and fibres along the parameter, 3 x n [N per unit]; positions and
/// strain rate are held.
Eigen::Matrix3Xd gradient_tangent(const model::Model& model, const ModelTangent& tangent, const Eigen::Matrix3Xd& x,
                                  const Eigen::VectorXd& rate, double time_s, bool before_jump);

}  // namespace myo::sensitivity
