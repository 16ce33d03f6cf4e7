#include "material/catalogue.hpp"
#include "material/tensors.hpp"

namespace myo::material {
namespace {

/// Nearly incompressible neo-Hookean law: mu/2 (J^(-2/3) tr(F'F) - 3) + kappa/4 (J^2 - 1 - 2 ln J).
///
/// The isochoric part is that of the project file. The volumetric part is Simo's, which is infinite at J = 0.
/// Source: Bonet & Wood 2008, sec. 6.5; Simo & Hughes 1998, eq. 9.2.3.
class NeoHookean final : public MaterialOf<NeoHookean> {
public:
    std::string id() const override { return "neo_hookean"; }
    std::string label() const override { return "Neo-Hookean"; }
    std::string formula() const override { return "μ/2 (J^(-2/3) tr(FᵀF) − 3) + κ/4 (J² − 1 − 2 ln J)"; }
    std::string explanation() const override {
        return "μ = E / (2 (1 + ν)), κ = E / (3 (1 − 2ν)), J = det F. Nearly incompressible, for large strain (Bonet & "
               "Wood 2008, sec. 6.5; Simo & Hughes 1998).";
    }

    template <class T>
    static void respond_at(const Matrix3<T>& F, const T& mu, const T&, bool with_hessian, LawResponse<T>& out) {
        const Matrix3<T> C = cofactor(F);
        const T J = F(0, 0) * C(0, 0) + F(1, 0) * C(1, 0) + F(2, 0) * C(2, 0);
        const T I1 = double_dot(F, F);
        const T cube_root = inverse_cube_root(J);  // NaN for J <= 0: the step is rejected
        const T scale = mu * cube_root * cube_root;
        const Matrix3<T> G = C * (T(1.0) / J);
        out.distortion.value = T(0.5) * (scale * I1 - T(3.0) * mu);
        out.distortion.gradient = (F - G * (I1 * T(1.0 / 3.0))) * scale;
        out.volume.value = J - T(1.0);
        out.volume.gradient = C;
        if (!with_hessian) return;
        const T third = I1 * T(1.0 / 3.0);
        // G = F^-T: d(F^-T)_ij / dF_kl = -G_il G_kj gives the crossed terms.
        for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            const T GG = G(i, j) * G(k, l), crossed = G(i, l) * G(k, j);
            T entry = T(2.0 / 3.0) * (third * GG - F(i, j) * G(k, l) - G(i, j) * F(k, l)) + third * crossed;
            if (row == column) entry += T(1.0);
            out.distortion.hessian(row, column) = scale * entry;
            out.volume.hessian(row, column) = J * (GG - crossed);
        });
    }

    /// Energy and stress in one pass: isochoric and volumetric parts share J and its inverse, and stress = scale F + c
    /// cof F.
    void respond_whole(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, Pack& energy,
                       Matrix3<Pack>& stress) const override {
        const Matrix3<Pack> C = cofactor(F);
        const Pack J = F(0, 0) * C(0, 0) + F(1, 0) * C(1, 0) + F(2, 0) * C(2, 0), inverse = 1.0 / J;
        const Pack I1 = double_dot(F, F), cube_root = inverse_cube_root(J), scale = mu * cube_root * cube_root;
        const Pack of_cofactor = 0.5 * kappa * (J - inverse) - scale * I1 * (1.0 / 3.0) * inverse;
        energy = 0.5 * (scale * I1 - 3.0 * mu) + 0.25 * kappa * (J * J - 1.0 - 2.0 * logarithm(J));
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) stress(i, j) = scale * F(i, j) + of_cofactor * C(i, j);
    }

    template <class T>
    static ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa) {
        const T J = T(1.0) + theta, inverse = T(1.0) / J;
        return {kappa * T(0.25) * (J * J - T(1.0) - T(2.0) * logarithm(J)), kappa * T(0.5) * (J - inverse),
                kappa * T(0.5) * (T(1.0) + inverse * inverse)};
    }
};

}  // namespace

MaterialPointer neo_hookean() { return std::make_shared<NeoHookean>(); }

}  // namespace myo::material
