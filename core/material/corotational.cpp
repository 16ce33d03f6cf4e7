#include "material/catalogue.hpp"
#include "material/polar.hpp"

namespace myo {
namespace {

using Eigen::Matrix3d;

/// Corotational linear elasticity mu |F - R|^2 + lambda/2 tr(R'F - I)^2, written with kappa = lambda + 2/3 mu:
/// mu |F - R|^2 - mu/3 theta^2 + kappa/2 theta^2, theta = tr(R'F) - 3.
/// Source: Sifakis & Barbič 2012, sec. 3.4.
class Corotational final : public Material {
public:
    std::string id() const override { return "corotational"; }
    std::string formula() const override { return "μ |F − R|² + λ/2 tr(RᵀF − I)²"; }

    TensorFunction distortion(const Matrix3d& F, double mu, double, bool with_hessian) const override {
        const Matrix3d R = polar_rotation(F);
        const double theta = (R.transpose() * F).trace() - 3.0;
        TensorFunction W;
        W.value = mu * (F - R).squaredNorm() - mu / 3.0 * theta * theta;
        W.gradient = 2.0 * mu * (F - R) - 2.0 / 3.0 * mu * theta * R;
        if (!with_hessian) return W;
        const Matrix9d dR = polar_rotation_derivative(F, R);
        const Eigen::Map<const Eigen::Matrix<double, 9, 1>> r(R.data());
        // mu |F - R|^2 has the gradient 2 mu (F - R) because R'dR is skew.
        W.hessian = 2.0 * mu * (Matrix9d::Identity() - dR) - 2.0 / 3.0 * mu * (r * r.transpose() + theta * dR);
        return W;
    }

    TensorFunction volume_measure(const Matrix3d& F, bool with_hessian) const override {
        const Matrix3d R = polar_rotation(F);
        TensorFunction theta;
        theta.value = (R.transpose() * F).trace() - 3.0;
        theta.gradient = R;
        if (with_hessian) theta.hessian = polar_rotation_derivative(F, R);
        return theta;
    }

    ScalarFunction bulk(double theta, double kappa) const override { return {kappa / 2.0 * theta * theta, kappa * theta, kappa}; }
};

}  // namespace

MaterialPointer corotational() { return std::make_shared<Corotational>(); }

}  // namespace myo
