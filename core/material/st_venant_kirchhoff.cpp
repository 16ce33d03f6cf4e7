#include "material/catalogue.hpp"
#include "material/tensors.hpp"

namespace myo::material {
namespace {

/// St. Venant-Kirchhoff law mu |E|^2 + lambda/2 tr(E)^2 with Green strain E. With kappa = lambda + 2/3 mu it reads mu
/// (|E|^2 - theta^2 / 3) + kappa/2 theta^2, theta = tr E.
///
/// Softens in compression and does not resist inversion: for small strain with large rotations.
/// Source: Bonet & Wood 2008, sec. 6.4.
class StVenantKirchhoff final : public MaterialOf<StVenantKirchhoff> {
public:
    std::string id() const override { return "st_venant_kirchhoff"; }
    std::string label() const override { return "St. Venant–Kirchhoff"; }
    std::string formula() const override { return "μ |E|² + λ/2 tr(E)²"; }
    std::string explanation() const override {
        return "μ = E / (2 (1 + ν)), λ = E ν / ((1 + ν) (1 − 2ν)), Green's strain E = (FᵀF − I) / 2. Softens in "
               "compression: for small strain (Bonet & Wood 2008, sec. 6.4).";
    }

    template <class T>
    static void respond_at(const Matrix3<T>& F, const T& mu, const T&, bool with_hessian, LawResponse<T>& out) {
        Matrix3<T> E, B;  // Green strain and F F'
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                T inner = T(i == j ? -1.0 : 0.0), outer = T(0.0);
                for (int k = 0; k < 3; ++k) {
                    inner += F(k, i) * F(k, j);
                    outer += F(i, k) * F(j, k);
                }
                E(i, j) = T(0.5) * inner;
                B(i, j) = outer;
            }
        const T theta = E(0, 0) + E(1, 1) + E(2, 2);
        Matrix3<T> S = E * T(2.0);  // second Piola-Kirchhoff stress over mu
        for (int i = 0; i < 3; ++i) S(i, i) -= T(2.0 / 3.0) * theta;
        out.distortion.value = mu * (double_dot(E, E) - T(1.0 / 3.0) * theta * theta);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const T sum = F(i, 0) * S(0, j) + F(i, 1) * S(1, j) + F(i, 2) * S(2, j);
                out.distortion.gradient(i, j) = mu * sum;
            }
        out.volume.value = theta;
        out.volume.gradient = F;
        if (!with_hessian) return;
        for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            T entry = F(i, l) * F(k, j) - T(2.0 / 3.0) * F(i, j) * F(k, l);
            // Last comes the geometric part of the tangent: the stress at the present F.
            if (j == l) entry += B(i, k);
            if (i == k) entry += S(j, l);
            out.distortion.hessian(row, column) = mu * entry;
            out.volume.hessian(row, column) = T(row == column ? 1.0 : 0.0);
        });
    }

    template <class T>
    static ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa) {
        return {T(0.5) * kappa * theta * theta, kappa * theta, kappa};
    }
};

}  // namespace

MaterialPointer st_venant_kirchhoff() { return std::make_shared<StVenantKirchhoff>(); }

}  // namespace myo::material
