#include "sensitivity/model_tangent.hpp"

#include <cassert>

namespace myo {

ModelTangent youngs_modulus_tangent(const Model& model, double youngs_modulus_Pa) {
    assert(youngs_modulus_Pa > 0.0);
    ModelTangent tangent;
    for (const Moduli& m : model.moduli) tangent.moduli.push_back({m.mu / youngs_modulus_Pa, m.kappa / youngs_modulus_Pa});
    return tangent;
}

ModelTangent damping_tangent() {
    ModelTangent tangent;
    tangent.damping_s = 1.0;
    return tangent;
}

Eigen::Matrix3Xd gradient_tangent(const Model& model, const ModelTangent& tangent, const Eigen::Matrix3Xd& x,
                                  const Eigen::VectorXd& rate, double time_s, bool before_jump) {
    // The energy is linear in the moduli and in damping times moduli, so its derivative is itself at their derivatives.
    Stiffness derivative;
    derivative.fibres = false;
    derivative.elastic = tangent.moduli;
    if (rate.size() > 0 && (tangent.damping_s != 0.0 || (model.damping_s != 0.0 && !tangent.moduli.empty()))) {
        derivative.viscous.assign(model.moduli.size(), Moduli{});
        for (std::size_t c = 0; c < model.moduli.size(); ++c) {
            const Moduli d = tangent.moduli.empty() ? Moduli{} : tangent.moduli[c];
            derivative.viscous[c] = {tangent.damping_s * model.moduli[c].mu + model.damping_s * d.mu,
                                     tangent.damping_s * model.moduli[c].kappa + model.damping_s * d.kappa};
        }
    }
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
    if (!derivative.elastic.empty() || !derivative.viscous.empty()) {
        InternalInput input;
        input.stiffness = &derivative;
        input.rate = {0.0, &rate};
        gradient = internal_energy(model, x, input, HessianKind::none).gradient;
    }
    if (!tangent.activation.empty()) {
        std::vector<double> d_activation;
        for (const Signal& signal : tangent.activation)
            d_activation.push_back(before_jump ? signal.value_before(time_s) : signal.value(time_s));
        gradient += activation_gradient(model, x, d_activation);
    }
    return gradient;
}

}  // namespace myo
