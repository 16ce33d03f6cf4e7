#include <cassert>

#include "material/catalogue.hpp"
#include "material/function_of_energy.hpp"
#include "material/tensors.hpp"

namespace myo::material {
namespace {

/// s, the share of the second invariant in the shear modulus.
const LawParameter share{.name = "mooney_rivlin_share",
                         .unit = "",
                         .label = "Share of Ī₂",
                         .meaning =
                             "Part s of the small-strain shear modulus of the second invariant: C₁₀ = "
                             "(1 − s) μ/2, C₀₁ = s μ/2. Rubbers: 0 to 0.5.",
                         .usual = 0.2,
                         .lower = 0.0,
                         .upper = 1.0,
                         .scale = 0.1,
                         .over_decades = false};

/// (J^(-4/3) I2 - 3) / 2 with I2 = |cof F|^2, and its derivatives by F.
template <class T>
void second_invariant(const Matrix3<T>& F, bool with_hessian, TensorFunctionOf<T>& out) {
    const Matrix3<T> C = cofactor(F);
    const T J = F(0, 0) * C(0, 0) + F(1, 0) * C(1, 0) + F(2, 0) * C(2, 0);
    const T cube_root = inverse_cube_root(J), square = cube_root * cube_root, scale = square * square;
    const T I1 = double_dot(F, F), I2 = double_dot(C, C);
    const Matrix3<T> G = C * (T(1.0) / J), FFt = F * F.transpose(), FtF = F.transpose() * F;
    const Matrix3<T> D = F * I1 - FFt * F;  // half of dI2/dF
    out.value = T(0.5) * (scale * I2 - T(3.0));
    out.gradient = (D - G * (I2 * T(2.0 / 3.0))) * scale;
    if (!with_hessian) return;
    for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
        T entry = T(2.0) * F(i, j) * F(k, l) - F(i, l) * F(k, j) -
                  T(4.0 / 3.0) * (G(i, j) * D(k, l) + D(i, j) * G(k, l)) +
                  I2 * (T(8.0 / 9.0) * G(i, j) * G(k, l) + T(2.0 / 3.0) * G(i, l) * G(k, j));
        if (row == column) entry += I1;
        if (i == k) entry -= FtF(l, j);
        if (j == l) entry -= FFt(i, k);
        out.hessian(row, column) = scale * entry;
    });
}

/// mu ((1 - s) (I1 - 3) + s (I2 - 3)) / 2 with isochoric invariants, and the volumetric part of the neo-Hookean law; or
/// the derivative of it by s, with weights that add up to zero.
///
/// Source: Mooney 1940; Rivlin 1948; Bonet & Wood 2008, sec. 6.5, with s = C01 / (C10 + C01).
class MooneyRivlin final : public MaterialOf<MooneyRivlin> {
public:
    MooneyRivlin(double first, double second, bool has_bulk) : first_(first), second_(second), has_bulk_(has_bulk) {}

    std::string id() const override { return "mooney_rivlin"; }
    std::string label() const override { return "Mooney–Rivlin"; }
    std::string formula() const override { return "μ/2 ((1 − s) (Ī₁ − 3) + s (Ī₂ − 3)) + κ/4 (J² − 1 − 2 ln J)"; }
    std::string explanation() const override {
        return "μ = E / (2 (1 + ν)), κ = E / (3 (1 − 2ν)), Ī₁ = J^(-2/3) tr(FᵀF), Ī₂ = J^(-4/3) |cof F|². Its second "
               "part softens in extension and stiffens in compression (Mooney 1940, Rivlin 1948).";
    }
    std::vector<LawParameter> parameters() const override { return {share}; }
    std::vector<double> values() const override { return {second_}; }
    MaterialPointer with_values(const std::vector<double>& values) const override {
        assert(values.size() == 1);
        return std::make_shared<MooneyRivlin>(1.0 - values[0], values[0], true);
    }
    MaterialPointer by_parameter(std::size_t) const override {
        // d/ds of (1 - s) and s; the volumetric part does not depend on s.
        return std::make_shared<MooneyRivlin>(-1.0, 1.0, false);
    }

    template <class T>
    void respond_at(const Matrix3<T>& F, const T& mu, const T&, bool with_hessian, LawResponse<T>& out) const {
        // The first invariant is that of the neo-Hookean law; the second is added with its own weight.
        neo_hookean_->respond(F, T(first_) * mu, T(0.0), with_hessian, out);
        TensorFunctionOf<T> invariant;
        second_invariant(F, with_hessian, invariant);
        const T weight = T(second_) * mu;
        add_function_of(invariant, {weight * invariant.value, weight, T(0.0)}, with_hessian, out.distortion);
    }
    template <class T>
    ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa) const {
        return has_bulk_ ? neo_hookean_->bulk(theta, kappa) : ScalarFunctionOf<T>{};
    }

private:
    double first_, second_;
    bool has_bulk_;
    MaterialPointer neo_hookean_ = neo_hookean();
};

}  // namespace

MaterialPointer mooney_rivlin() { return std::make_shared<MooneyRivlin>(1.0 - share.usual, share.usual, true); }

}  // namespace myo::material
