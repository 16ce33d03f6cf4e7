#include "sensitivity/model_tangent.hpp"

#include <cassert>

namespace myo::sensitivity {

ModelTangent youngs_modulus_tangent(const model::Model& model, double youngs_modulus_Pa) {
    assert(youngs_modulus_Pa > 0.0);
    ModelTangent tangent;
    for (const material::Moduli& m : model.moduli)
        tangent.moduli.push_back({m.mu / youngs_modulus_Pa, m.kappa / youngs_modulus_Pa});
    return tangent;
}

ModelTangent damping_tangent() {
    ModelTangent tangent;
    tangent.damping_s = 1.0;
    return tangent;
}

ModelTangent law_tangent(std::size_t k) {
    ModelTangent tangent;
    tangent.law = k;
    return tangent;
}

Eigen::Matrix3Xd force_element_tangent(const model::Model& model, const ModelTangent& tangent,
                                       const model::ForceState& at) {
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, at.x.cols());
    for (std::size_t e = 0; e < tangent.force_elements.size(); ++e)
        if (tangent.force_elements[e].size() > 0)
            model.force_elements[e]->add_tangent(*model.body, at, tangent.force_elements[e], gradient);
    return gradient;
}

model::Stiffness stiffness_tangent(const model::Model& model, const ModelTangent& tangent) {
    model::Stiffness derivative;
    // The activation is a separate part of the tangent.
    derivative.fibres = false;
    derivative.elastic = tangent.moduli;
    derivative.elastic_factors = derivative.viscous_factors = model.point_factors;
    if (tangent.law) {
        // The viscous stress does not depend on the law.
        assert(tangent.moduli.empty() && tangent.damping_s == 0.0);
        derivative.law = model.material->by_parameter(*tangent.law);
        derivative.elastic = model.moduli;
        return derivative;
    }
    // With creep the viscous stress is 2 mu dev of the effective rate, which already contains damping.
    if (model.creep) {
        // The effective rate of creep.hpp has unit viscosity: viscous moduli are the moduli themselves.
        derivative.viscous = tangent.moduli;
        return derivative;
    }
    if (tangent.damping_s == 0.0 && (!model::is_viscous(model) || tangent.moduli.empty())) return derivative;
    // Product rule for the viscous moduli damping * (mu, kappa).
    for (std::size_t c = 0; c < model.moduli.size(); ++c) {
        const material::Moduli d = tangent.moduli.empty() ? material::Moduli{} : tangent.moduli[c];
        const double scale = model::viscous_scale(model, c);
        derivative.viscous.push_back({tangent.damping_s * model.moduli[c].mu + scale * d.mu,
                                      tangent.damping_s * model.moduli[c].kappa + scale * d.kappa});
    }
    return derivative;
}

std::vector<double> activation_tangent(const ModelTangent& tangent, double time_s, bool before_jump) {
    std::vector<double> derivative;
    for (const fibre::Signal& signal : tangent.activation)
        derivative.push_back(before_jump ? signal.value_before(time_s) : signal.value(time_s));
    return derivative;
}

Eigen::Matrix3Xd gradient_tangent(const model::Model& model, const ModelTangent& tangent, const Eigen::Matrix3Xd& x,
                                  const Eigen::VectorXd& rate, double time_s, bool before_jump) {
    const model::Stiffness derivative = stiffness_tangent(model, tangent);
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
    if (!derivative.elastic.empty() || !derivative.viscous.empty()) {
        model::InternalInput input;
        input.stiffness = &derivative;
        // The strain rate is given: rate factor 0 and the rate as history.
        if (rate.size() > 0) input.rate = {0.0, &rate};
        gradient = model::internal_energy(model, x, input, model::HessianKind::none).gradient;
    }
    if (!tangent.activation.empty())
        gradient += model::activation_gradient(model, x, activation_tangent(tangent, time_s, before_jump));
    return gradient;
}

}  // namespace myo::sensitivity
