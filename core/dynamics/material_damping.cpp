#include "dynamics/material_damping.hpp"

#include "model/internal_forces.hpp"

namespace myo::dynamics {

double damping_factor(const model::Model& model, const Eigen::Matrix3Xd& x, const NaturalMode& mode) {
    model::Model viscous = model;
    viscous.creep.reset();  // the branch is not part of Kelvin-Voigt damping
    // The whole damping for a damping time of the body of 1 s; parts keep their ratio to it.
    for (double& excess : viscous.damping_excess_s) excess /= model.damping_s > 0.0 ? model.damping_s : 1.0;
    viscous.damping_s = 1.0;
    const Eigen::Matrix3Xd force = model::viscous_gradient(viscous, x, model::strain_tangent(model, x, mode.shape));
    // Dissipation of the mode shape at unit rate and unit damping time, phi' C phi, relative to its stiffness omega^2.
    return force.cwiseProduct(mode.shape).sum() / (mode.omega_rad_s * mode.omega_rad_s);  // shape' M shape = 1
}

}  // namespace myo::dynamics
