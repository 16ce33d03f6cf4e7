#include "dynamics/creep.hpp"

#include <cassert>

#include "model/internal_forces.hpp"

namespace myo::dynamics {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd with_dashpots(const material::MaxwellBranch& branch, double f, const Eigen::Ref<const MatrixXd>& strain,
                       const Eigen::Ref<const MatrixXd>& history) {
    assert(history.rows() == 2 * strain.rows() && history.cols() == strain.cols());
    const double tau = branch.relaxation_time_s;
    assert(tau > 0.0);
    MatrixXd result(2 * strain.rows(), strain.cols());
    // Closed form of implicit evolution, see creep.hpp: no extra unknowns in the stage.
    result.topRows(strain.rows()) = strain;
    result.bottomRows(strain.rows()) = (strain - tau * history.bottomRows(strain.rows())) / (1.0 + tau * f);
    return result;
}

double viscous_factor(const model::Model& model, double f) {
    const auto [g, tau] = *model.creep;
    return model.damping_s * f + g * tau * f / (1.0 + tau * f);
}

MatrixXd viscous_history(const model::Model& model, double f, const Eigen::Ref<const MatrixXd>& history) {
    const auto [g, tau] = *model.creep;
    const Eigen::Index count = history.rows() / 2;
    return model.damping_s * history.topRows(count) + g * tau / (1.0 + tau * f) * history.bottomRows(count);
}

double branch_energy(const model::Model& model, const Eigen::Matrix3Xd& x, const VectorXd& strain) {
    // The spring of the branch carries the strain E - E_v with the modulus ratio g. Passing E - E_v as a "strain rate"
    // with viscous moduli g mu makes the viscous potential equal to its elastic energy.
    model::Stiffness branch;
    branch.fibres = false;
    branch.viscous_factors = model.point_factors;
    for (const material::Moduli& m : model.moduli) branch.viscous.push_back({model.creep->modulus_ratio * m.mu, 0.0});
    const VectorXd dashpots = -strain.tail(strain.size() / 2);
    model::InternalInput input;  // rate := E - E_v; its potential is the energy of the branch
    input.stiffness = &branch;
    input.rate = {1.0, &dashpots};
    return model::internal_energy(model, x, input, model::HessianKind::none).energy;
}

}  // namespace myo::dynamics
