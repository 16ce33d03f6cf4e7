#include "dynamics/material_damping.hpp"

#include "model/internal_forces.hpp"

namespace myo::dynamics {

double damping_factor(const model::Model& model, const Eigen::Matrix3Xd& x, const NaturalMode& mode) {
    model::Model viscous = model;
    viscous.creep.reset();  // its branch is no damping by this time
    viscous.damping_s = 1.0;
    const Eigen::Matrix3Xd force = model::viscous_gradient(viscous, x, model::strain_tangent(model, x, mode.shape));
    return force.cwiseProduct(mode.shape).sum() / (mode.omega_rad_s * mode.omega_rad_s);  // shape' M shape = 1
}

}  // namespace myo::dynamics
