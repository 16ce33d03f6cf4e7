#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>

#include "base/pack.hpp"

namespace myo::material {

template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <class T>
using Matrix9 = Eigen::Matrix<T, 9, 9>;
using Matrix9d = Matrix9<double>;

/// A scalar function of the deformation gradient F with its derivatives.
///
/// gradient(i, j) = d value / d F(i, j). hessian(i + 3 j, k + 3 l) = d2 value / dF(i, j) dF(k, l); left unset unless
/// asked for.
template <class T>
struct TensorFunctionOf {
    T value = T(0.0);
    Matrix3<T> gradient = Matrix3<T>::Constant(T(0.0));
    Matrix9<T> hessian;
};
using TensorFunction = TensorFunctionOf<double>;

/// U(theta) with its derivatives.
template <class T>
struct ScalarFunctionOf {
    T value = T(0.0);
    T first = T(0.0);
    T second = T(0.0);
};
using ScalarFunction = ScalarFunctionOf<double>;

/// Both parts of a law at one F: they share most of their work.
template <class T>
struct LawResponse {
    TensorFunctionOf<T> distortion;  // [J/m3]
    TensorFunctionOf<T>
        volume;  // the measure theta; of laws without a split: what kappa multiplies in the distortion (no hessian)
};

/// A hyperelastic law, energy per rest volume W(F) = distortion(F) + bulk(volume_measure(F)).
///
/// The split lets an element replace the volume measure by its mean over the cell, which removes volumetric locking.
/// Both parts are linear in the moduli (mu, kappa), so that their derivative with respect to the moduli is the same
/// function at (d mu, d kappa). The small-strain moduli are mu and kappa, but for the projective law. A degenerate F
/// gives non-finite values, and the line search rejects the step.
class Material {
public:
    virtual ~Material() = default;

    virtual std::string id() const = 0;
    /// One line for a person: the energy as a formula.
    virtual std::string formula() const = 0;
    /// Whether the volume part is separate. Without a split theta and bulk() are zero.
    virtual bool has_split() const { return true; }

    /// Distortional energy density and volume measure (0 in the rest state, d theta = tr(strain) for small strain) at
    /// F. mu: shear modulus [Pa]; kappa: bulk modulus [Pa], used by laws without a split.
    virtual void respond(const Matrix3<double>& F, const double& mu, const double& kappa, bool with_hessian,
                         LawResponse<double>& out) const = 0;
    virtual void respond(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, bool with_hessian,
                         LawResponse<Pack>& out) const = 0;

    /// The whole law at F: energy density and first Piola stress. By respond() and bulk(), unless a law saves work by
    /// doing both at once.
    virtual void respond_whole(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, Pack& energy,
                               Matrix3<Pack>& stress) const;

    /// U(theta) [J/m3], U''(0) = kappa. Zero for laws without a split.
    virtual ScalarFunctionOf<double> bulk(const double& theta, const double& kappa) const = 0;
    virtual ScalarFunctionOf<Pack> bulk(const Pack& theta, const Pack& kappa) const = 0;

    /// The parts of respond() at one point.
    TensorFunction distortion(const Eigen::Matrix3d& F, double mu, double kappa, bool with_hessian) const;
    TensorFunction volume_measure(const Eigen::Matrix3d& F, bool with_hessian) const;
};

/// Writes a law once for numbers and packs: `Law` gives the templates
///   static void respond_at(const Matrix3<T>& F, const T& mu, const T& kappa, bool with_hessian, LawResponse<T>& out)
///   static ScalarFunctionOf<T> bulk_at(const T& theta, const T& kappa).
template <class Law>
class MaterialOf : public Material {
public:
    void respond(const Matrix3<double>& F, const double& mu, const double& kappa, bool with_hessian,
                 LawResponse<double>& out) const final {
        Law::respond_at(F, mu, kappa, with_hessian, out);
    }
    void respond(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, bool with_hessian,
                 LawResponse<Pack>& out) const final {
        Law::respond_at(F, mu, kappa, with_hessian, out);
    }
    ScalarFunctionOf<double> bulk(const double& theta, const double& kappa) const final {
        return Law::bulk_at(theta, kappa);
    }
    ScalarFunctionOf<Pack> bulk(const Pack& theta, const Pack& kappa) const final { return Law::bulk_at(theta, kappa); }
};

using MaterialPointer = std::shared_ptr<const Material>;

}  // namespace myo::material
