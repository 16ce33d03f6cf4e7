#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/pack.hpp"

namespace myo::material {

/// 3 x 3 tensor over a scalar type: double, or Pack for one cell per lane.
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
/// 9 x 9 tangent dP/dF, index i + 3 j for the entry (i, j) of a tensor.
template <class T>
using Matrix9 = Eigen::Matrix<T, 9, 9>;
using Matrix9d = Matrix9<double>;

/// Scalar function of the deformation gradient F with its derivatives.
template <class T>
struct TensorFunctionOf {
    T value = T(0.0);                                    // W(F)
    Matrix3<T> gradient = Matrix3<T>::Constant(T(0.0));  // (i, j): dW / dF_ij
    Matrix9<T> hessian;  // (i + 3 j, k + 3 l): d2W / dF_ij dF_kl; unset unless requested
};
using TensorFunction = TensorFunctionOf<double>;

/// Volumetric energy U(theta) with its derivatives.
template <class T>
struct ScalarFunctionOf {
    T value = T(0.0);   // U
    T first = T(0.0);   // U'
    T second = T(0.0);  // U''
};
using ScalarFunction = ScalarFunctionOf<double>;

/// Both parts of a law at one F. They are evaluated together because they share most of their work.
template <class T>
struct LawResponse {
    TensorFunctionOf<T> distortion;  // energy density [J/m3], derivative by F: first Piola-Kirchhoff stress [Pa]
    TensorFunctionOf<T> volume;  // theta; for laws without a split the factor of kappa in the distortion (no hessian)
};

/// A number of a law besides the moduli. It is a key of [material] in experiments and project files, is fitted where
/// material.calibrate names it, and can be set in the window.
struct LawParameter {
    std::string name;                 // key, ends with its unit where it has one
    std::string unit;                 // for display; empty: a plain number
    std::string label, meaning;       // for display: a row's label, and what the number does
    double usual = 0.0;               // value where none is declared
    double lower = 0.0, upper = 0.0;  // bounds of declarations and fits
    double scale = 1.0;               // a typical change, for fits
    bool over_decades = false;        // known to a factor rather than to a difference
};

class Material;
using MaterialPointer = std::shared_ptr<const Material>;

/// Hyperelastic law with energy per rest volume W(F) = distortion(F) + bulk(volume_measure(F)).
///
/// The split lets an element replace the volume measure by its cell average, which removes volumetric locking. Both
/// parts are linear in the moduli (mu, kappa): the derivative with respect to the moduli is the same function at (d mu,
/// d kappa). mu and kappa are the small-strain moduli, except for the projective law. A law may have further
/// parameters; an object of it holds their values. Errors: none. A degenerate F gives non-finite values; the line
/// search rejects the step.
class Material {
public:
    virtual ~Material() = default;

    /// Name in project files.
    virtual std::string id() const = 0;
    /// Name for display.
    virtual std::string label() const = 0;
    /// Energy as a formula in one line, for display.
    virtual std::string formula() const = 0;
    /// The letters of the formula, range of use and source, for display.
    virtual std::string explanation() const = 0;

    /// Parameters besides the moduli; the order is that of values(), with_values() and by_parameter().
    virtual std::vector<LawParameter> parameters() const { return {}; }
    /// Their values.
    virtual std::vector<double> values() const { return {}; }
    /// Copy of the law with other values of its parameters. Asserts one value for each.
    virtual MaterialPointer with_values(const std::vector<double>& values) const;
    /// The derivative of the energy with respect to parameter k, as a law with the same split. Laws without parameters
    /// have none (asserted).
    virtual MaterialPointer by_parameter(std::size_t k) const;

    /// True if the volumetric part is separate. Otherwise theta and bulk() are zero.
    virtual bool has_split() const { return true; }

    /// Distortional energy density and volume measure theta at F.
    ///
    /// theta is 0 at rest, with d theta = tr(strain) for small strain.
    /// @param mu            shear modulus [Pa]
    /// @param kappa         bulk modulus [Pa], used by laws without a split
    /// @param with_hessian  also compute second derivatives
    virtual void respond(const Matrix3<double>& F, const double& mu, const double& kappa, bool with_hessian,
                         LawResponse<double>& out) const = 0;
    /// As above, for one cell per lane.
    virtual void respond(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, bool with_hessian,
                         LawResponse<Pack>& out) const = 0;

    /// Energy density [J/m3] and first Piola-Kirchhoff stress [Pa] of the complete law at F. By default from respond()
    /// and bulk(); laws override it if a joint evaluation is cheaper.
    virtual void respond_whole(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, Pack& energy,
                               Matrix3<Pack>& stress) const;

    /// Volumetric energy U(theta) [J/m3] with U''(0) = kappa. Zero for laws without a split.
    virtual ScalarFunctionOf<double> bulk(const double& theta, const double& kappa) const = 0;
    /// As above, for one cell per lane.
    virtual ScalarFunctionOf<Pack> bulk(const Pack& theta, const Pack& kappa) const = 0;

    /// Distortional part of respond() at one point.
    TensorFunction distortion(const Eigen::Matrix3d& F, double mu, double kappa, bool with_hessian) const;
    /// Volume measure of respond() at one point; zero for laws without a split.
    TensorFunction volume_measure(const Eigen::Matrix3d& F, bool with_hessian) const;
};

/// Implements the virtual functions for double and Pack from one template. `Law` provides, static or const,
///   void respond_at(const Matrix3<T>& F, const T& mu, const T& kappa, bool with_hessian, LawResponse<T>& out)
///   ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa).
template <class Law>
class MaterialOf : public Material {
public:
    void respond(const Matrix3<double>& F, const double& mu, const double& kappa, bool with_hessian,
                 LawResponse<double>& out) const final {
        law().respond_at(F, mu, kappa, with_hessian, out);
    }
    void respond(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, bool with_hessian,
                 LawResponse<Pack>& out) const final {
        law().respond_at(F, mu, kappa, with_hessian, out);
    }
    ScalarFunctionOf<double> bulk(const double& theta, const double& kappa) const final {
        return law().bulk_at(theta, kappa);
    }
    ScalarFunctionOf<Pack> bulk(const Pack& theta, const Pack& kappa) const final {
        return law().bulk_at(theta, kappa);
    }

private:
    const Law& law() const { return static_cast<const Law&>(*this); }
};

}  // namespace myo::material
