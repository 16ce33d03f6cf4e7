#include "sensitivity/creep_adjoint.hpp"

#include <utility>

namespace myo::sensitivity {

using Eigen::Index;
using Eigen::VectorXd;

// H = damping h + g tau / (1 + tau f) h_v and E_v = (E - tau h_v) / (1 + tau f).
VectorXd history_adjoint(const model::Model& model, double f, const VectorXd& of_rate, const VectorXd& of_strains) {
    if (!model.creep) return of_rate;
    const auto [g, tau] = *model.creep;
    const Index count = of_rate.size();
    VectorXd result(2 * count);
    result.head(count) = model.damping_s * of_rate;
    result.tail(count) = g * tau / (1.0 + tau * f) * of_rate;
    if (of_strains.size() > 0) result.tail(count) -= tau / (1.0 + tau * f) * of_strains.tail(count);
    return result;
}

VectorXd body_strain_adjoint(const model::Model& model, double f, const VectorXd& of_strains) {
    if (!model.creep || of_strains.size() == 0) return of_strains;
    const Index count = of_strains.size() / 2;
    return of_strains.head(count) + of_strains.tail(count) / (1.0 + model.creep->relaxation_time_s * f);
}

StartStrainAdjoint start_strain_adjoint(const model::Model& model, bool relaxed, VectorXd of_strains,
                                        VectorXd of_rates) {
    if (!model.creep) return {std::move(of_strains), std::move(of_rates)};
    // dE_v/dt = (E - E_v) / tau, with E_v = E if relaxed and constant otherwise.
    const Index count = (of_strains.size() > 0 ? of_strains : of_rates).size() / 2;
    StartStrainAdjoint result{VectorXd::Zero(count), VectorXd::Zero(count)};
    if (of_strains.size() > 0) {
        result.strain = of_strains.head(count);
        if (relaxed) result.strain += of_strains.tail(count);
    }
    if (of_rates.size() > 0) {
        result.rate = of_rates.head(count);
        if (!relaxed) result.strain += of_rates.tail(count) / model.creep->relaxation_time_s;
    }
    return result;
}

}  // namespace myo::sensitivity
