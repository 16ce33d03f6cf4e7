#include "dynamics/energy.hpp"

#include <cassert>

#include "model/force_element.hpp"

namespace myo::dynamics {

Energy energy(const model::Model& model, const model::MassMatrix& mass, const Eigen::Matrix3Xd& x,
              const Eigen::Matrix3Xd& v, double time_s, bool before) {
    return energy(model, model::stiffness(model), mass, x, v, time_s, before);
}

Energy energy(const model::Model& model, const model::Stiffness& moduli, const model::MassMatrix& mass,
              const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double time_s, bool before) {
    assert(x.cols() == model.body->node_count() && v.cols() == x.cols());
    const std::vector<double> levels = model::activations(model, time_s, before);
    model::InternalInput input;  // no strain rate: viscous stresses store no energy
    input.stiffness = &moduli;
    input.activation = &levels;
    Energy result;
    result.kinetic_J = 0.5 * model::times_mass(v, mass).cwiseProduct(v).sum();
    model::InternalEnergy internal = model::internal_energy(model, x, input, model::HessianKind::none);
    // Elements with a potential are evaluated at rest, for the same reason.
    model::add_force_elements(model, {x, nullptr, 0.0, time_s, before}, model::HessianKind::none, internal);
    result.internal_J = internal.energy;
    result.work_J = model::external_forces(model, mass, time_s, before).cwiseProduct(x - model.body->mesh.nodes).sum();
    return result;
}

}  // namespace myo::dynamics
