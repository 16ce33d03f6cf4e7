#include <cassert>

#include "material/catalogue.hpp"
#include "material/function_of_energy.hpp"

namespace myo::material {
namespace {

/// J, the value of I1 - 3 at which the energy is infinite.
const LawParameter limit{.name = "gent_limit",
                         .unit = "",
                         .label = "Limit Jₘ",
                         .meaning =
                             "Value of Ī₁ − 3 at which the chains are stretched out and the stress becomes "
                             "infinite. Silicones: 10 to 100; a large value is the neo-Hookean law.",
                         .usual = 30.0,
                         .lower = 0.1,
                         .upper = 1e4,
                         .scale = 10.0,
                         .over_decades = true};

/// g(w) = -J/2 ln(1 - 2 w / J) of w = (I1 - 3)/2, the neo-Hookean energy at mu = 1. Energy and stress are NaN beyond
/// the limit, where the quotient alone would be a stress of the wrong sign: the step is rejected.
struct GentEnergy {
    double J;

    static constexpr bool has_bulk = true;
    template <class T>
    ScalarFunctionOf<T> at(const T& w) const {
        const T left = T(1.0) - w * T(2.0 / J), log_left = logarithm(left);
        // Zero times NaN is NaN: beyond the limit the stress is undefined like the energy.
        const T inverse = T(1.0) / left + T(0.0) * log_left;
        return {T(-0.5 * J) * log_left, inverse, inverse * inverse * T(2.0 / J)};
    }
};

/// The derivative of g with respect to J, with its derivatives by w.
struct GentEnergyByLimit {
    double J;

    static constexpr bool has_bulk = false;
    template <class T>
    ScalarFunctionOf<T> at(const T& w) const {
        const T share = w * T(2.0 / J), inverse = T(1.0) / (T(1.0) - share);
        return {T(-0.5) * (logarithm(T(1.0) - share) + share * inverse), T(-1.0 / J) * share * inverse * inverse,
                T(-2.0 / (J * J)) * (T(1.0) + share) * inverse * inverse * inverse};
    }
};

/// Gent's law -mu J/2 ln(1 - (I1 - 3) / J) with the isochoric I1, and the volumetric part of the neo-Hookean law. For
/// rubber whose stress rises steeply once its chains are stretched out.
///
/// Source: Gent 1996, Rubber Chemistry and Technology 69, 59-61, eq. 3.
template <class Energy>
class Gent final : public MaterialOf<Gent<Energy>> {
public:
    explicit Gent(double J) : energy_{J} { assert(J > 0.0); }

    std::string id() const override { return "gent"; }
    std::string label() const override { return "Gent"; }
    std::string formula() const override { return "−μ Jₘ/2 ln(1 − (Ī₁ − 3) / Jₘ) + κ/4 (J² − 1 − 2 ln J)"; }
    std::string explanation() const override {
        return "μ = E / (2 (1 + ν)), κ = E / (3 (1 − 2ν)), Ī₁ = J^(-2/3) tr(FᵀF). Stiffens without bound where Ī₁ − 3 "
               "reaches Jₘ, for very large strain (Gent 1996).";
    }
    std::vector<LawParameter> parameters() const override { return {limit}; }
    std::vector<double> values() const override { return {energy_.J}; }
    MaterialPointer with_values(const std::vector<double>& values) const override {
        assert(values.size() == 1);
        return std::make_shared<Gent>(values[0]);
    }
    MaterialPointer by_parameter(std::size_t) const override {
        // The volumetric part does not depend on the limit.
        return std::make_shared<Gent<GentEnergyByLimit>>(energy_.J);
    }

    template <class T>
    void respond_at(const Matrix3<T>& F, const T& mu, const T&, bool with_hessian, LawResponse<T>& out) const {
        // For unit modulus the neo-Hookean distortion is w, of which the law is a function.
        LawResponse<T> unit;
        neo_hookean_->respond(F, T(1.0), T(0.0), with_hessian, unit);
        out.volume = unit.volume;
        out.distortion = {};
        if (with_hessian) out.distortion.hessian.setConstant(T(0.0));
        ScalarFunctionOf<T> g = energy_.at(unit.distortion.value);
        g.value *= mu;
        g.first *= mu;
        g.second *= mu;
        add_function_of(unit.distortion, g, with_hessian, out.distortion);
    }
    template <class T>
    ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa) const {
        return Energy::has_bulk ? neo_hookean_->bulk(theta, kappa) : ScalarFunctionOf<T>{};
    }

private:
    Energy energy_;
    MaterialPointer neo_hookean_ = neo_hookean();
};

}  // namespace

MaterialPointer gent() { return std::make_shared<Gent<GentEnergy>>(limit.usual); }

}  // namespace myo::material
