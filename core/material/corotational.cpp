#include "material/catalogue.hpp"
#include "material/polar.hpp"
#include "material/tensors.hpp"

namespace myo::material {
namespace {

/// Corotational linear elasticity mu |F - R|^2 + lambda/2 tr(R'F - I)^2. With kappa = lambda + 2/3 mu it reads mu |F -
/// R|^2 - mu/3 theta^2 + kappa/2 theta^2, theta = tr(R'F) - 3.
/// Source: Sifakis & Barbič 2012, sec. 3.4.
class Corotational final : public MaterialOf<Corotational> {
public:
    std::string id() const override { return "corotational"; }
    std::string label() const override { return "Corotational"; }
    std::string formula() const override { return "μ |F − R|² + λ/2 tr(RᵀF − I)²"; }
    std::string explanation() const override {
        return "μ = E / (2 (1 + ν)), λ = E ν / ((1 + ν) (1 − 2ν)), F = R U with the rotation R. Linear in strain, for "
               "large rotations (Sifakis & Barbič 2012, sec. 3.4).";
    }

    template <class T>
    static void respond_at(const Matrix3<T>& F, const T& mu, const T&, bool with_hessian, LawResponse<T>& out) {
        const Matrix3<T> R = polar_rotation(F);
        const Matrix3<T> D = F - R;
        const T theta = double_dot(R, F) - T(3.0);
        out.distortion.value = mu * (double_dot(D, D) - T(1.0 / 3.0) * theta * theta);
        out.distortion.gradient = (D * T(2.0) - R * (T(2.0 / 3.0) * theta)) * mu;
        out.volume.value = theta;
        // d tr(R'F) = R : dF, since R'dR is skew and R'F symmetric.
        out.volume.gradient = R;
        if (!with_hessian) return;
        out.volume.hessian = polar_rotation_derivative(F, R);
        // R'dR is skew, so mu |F - R|^2 has the gradient 2 mu (F - R), without a term in dR.
        const T spin = T(2.0) + T(2.0 / 3.0) * theta;
        for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            T entry = T(-2.0 / 3.0) * R(i, j) * R(k, l) - spin * out.volume.hessian(row, column);
            if (row == column) entry += T(2.0);
            out.distortion.hessian(row, column) = mu * entry;
        });
    }

    template <class T>
    static ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa) {
        return {T(0.5) * kappa * theta * theta, kappa * theta, kappa};
    }
};

}  // namespace

MaterialPointer corotational() { return std::make_shared<Corotational>(); }

}  // namespace myo::material
