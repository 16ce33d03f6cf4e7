#include "dynamics/energy.hpp"

#include <cassert>

#include "model/internal_forces.hpp"

namespace myo {

Energy energy(const Model& model, const Eigen::SparseMatrix<double>& mass, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double time_s, bool before) {
    assert(x.cols() == model.body->node_count() && v.cols() == x.cols());
    const Stiffness moduli = stiffness(model);
    const std::vector<double> levels = activations(model, time_s, before);
    InternalInput input;   // without a strain rate: nothing viscous
    input.stiffness = &moduli;
    input.activation = &levels;
    Energy result;
    result.kinetic_J = 0.5 * times_mass(v, mass).cwiseProduct(v).sum();
    result.internal_J = internal_energy(model, x, input, HessianKind::none).energy;
    result.work_J = external_forces(model, mass, time_s, before).cwiseProduct(x - model.body->mesh.nodes).sum();
    return result;
}

}  // namespace myo
