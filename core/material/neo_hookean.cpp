#include <Eigen/LU>

#include <cmath>

#include "material/catalogue.hpp"

namespace myo {
namespace {

using Eigen::Matrix3d;

/// d2 J / dF2 = J (G_ij G_kl - G_il G_kj), G = F^-T.
Matrix9d determinant_hessian(const Matrix3d& G, double J) {
    Matrix9d H;
    for (int l = 0; l < 3; ++l)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) H(i + 3 * j, k + 3 * l) = J * (G(i, j) * G(k, l) - G(i, l) * G(k, j));
    return H;
}

/// Nearly incompressible neo-Hookean law: mu/2 (J^(-2/3) tr(F'F) - 3) + kappa/4 (J^2 - 1 - 2 ln J).
/// The isochoric part is the one of the experiment schema; the volume part is Simo's, which is infinite at J = 0.
/// Source: Bonet & Wood 2008, sec. 6.5; Simo & Hughes 1998, eq. 9.2.3.
class NeoHookean final : public Material {
public:
    std::string id() const override { return "neo_hookean"; }
    std::string formula() const override { return "μ/2 (J^(-2/3) tr(FᵀF) − 3) + κ/4 (J² − 1 − 2 ln J)"; }

    TensorFunction distortion(const Matrix3d& F, double mu, double, bool with_hessian) const override {
        const double J = F.determinant();
        const double I1 = F.squaredNorm();
        const double scale = mu * std::pow(J, -2.0 / 3.0);   // NaN for J < 0: the step is rejected
        const Matrix3d G = F.inverse().transpose();
        TensorFunction W;
        W.value = 0.5 * (scale * I1 - 3.0 * mu);
        W.gradient = scale * (F - I1 / 3.0 * G);
        if (!with_hessian) return W;
        const Eigen::Map<const Eigen::Matrix<double, 9, 1>> f(F.data());
        const Eigen::Map<const Eigen::Matrix<double, 9, 1>> g(G.data());
        W.hessian.noalias() = (-2.0 / 3.0) * (f * g.transpose() + g * f.transpose()) + (2.0 / 9.0 * I1) * g * g.transpose();
        W.hessian.diagonal().array() += 1.0;
        for (int l = 0; l < 3; ++l)
            for (int k = 0; k < 3; ++k)
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i < 3; ++i) W.hessian(i + 3 * j, k + 3 * l) += I1 / 3.0 * G(i, l) * G(k, j);
        W.hessian *= scale;
        return W;
    }

    TensorFunction volume_measure(const Matrix3d& F, bool with_hessian) const override {
        const double J = F.determinant();
        const Matrix3d G = F.inverse().transpose();
        TensorFunction theta;
        theta.value = J - 1.0;
        theta.gradient = J * G;
        if (with_hessian) theta.hessian = determinant_hessian(G, J);
        return theta;
    }

    ScalarFunction bulk(double theta, double kappa) const override {
        const double J = 1.0 + theta;
        return {kappa / 4.0 * (J * J - 1.0 - 2.0 * std::log(J)), kappa / 2.0 * (J - 1.0 / J), kappa / 2.0 * (1.0 + 1.0 / (J * J))};
    }
};

}  // namespace

MaterialPointer neo_hookean() { return std::make_shared<NeoHookean>(); }

}  // namespace myo
