#include "material/strain_stiffening.hpp"

#include <sstream>

#include "material/function_of_energy.hpp"

namespace myo::material {
namespace {

/// Decorator that adds the Yeoh term to the distortion of another law.
class StrainStiffening : public Material {
public:
    StrainStiffening(MaterialPointer base, double c2) : base_(std::move(base)), c2_(c2) {}

    std::string id() const override { return base_->id(); }
    std::string label() const override { return base_->label(); }
    std::string explanation() const override { return base_->explanation(); }
    std::string formula() const override {
        std::ostringstream words;
        words << base_->formula() << " + mu/2 " << c2_ << " (I1 - 3)^2";
        return words.str();
    }
    bool has_split() const override { return base_->has_split(); }

    void respond(const Matrix3<double>& F, const double& mu, const double& kappa, bool with_hessian,
                 LawResponse<double>& out) const override {
        respond_with(F, mu, kappa, with_hessian, out);
    }
    void respond(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, bool with_hessian,
                 LawResponse<Pack>& out) const override {
        respond_with(F, mu, kappa, with_hessian, out);
    }
    ScalarFunctionOf<double> bulk(const double& theta, const double& kappa) const override {
        return base_->bulk(theta, kappa);
    }
    ScalarFunctionOf<Pack> bulk(const Pack& theta, const Pack& kappa) const override {
        return base_->bulk(theta, kappa);
    }

private:
    /// mu (w' + 2 c2 w'^2) with the energy w' at mu = 1, which keeps the law linear in the moduli.
    template <class T>
    void respond_with(const Matrix3<T>& F, const T& mu, const T& kappa, bool with_hessian, LawResponse<T>& out) const {
        base_->respond(F, mu, kappa, with_hessian, out);
        LawResponse<T> unit;
        // A second evaluation at unit modulus: w^2 / mu is not defined at mu = 0, where the derivative by kappa is
        // evaluated.
        base_->respond(F, T(1.0), T(0.0), with_hessian, unit);
        const T curvature = mu * (4.0 * c2_), slope = curvature * unit.distortion.value;
        add_function_of(unit.distortion, {0.5 * slope * unit.distortion.value, slope, curvature}, with_hessian,
                        out.distortion);
    }

    MaterialPointer base_;
    double c2_;
};

}  // namespace

MaterialPointer strain_stiffening(MaterialPointer base, double yeoh_c2) {
    return std::make_shared<StrainStiffening>(std::move(base), yeoh_c2);
}

}  // namespace myo::material
