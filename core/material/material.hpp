#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>

namespace myo {

using Matrix9d = Eigen::Matrix<double, 9, 9>;

/// A scalar function of the deformation gradient F with its derivatives.
///
/// gradient(i, j) = d value / d F(i, j). hessian(i + 3 j, k + 3 l) = d2 value / dF(i, j) dF(k, l); left unset unless asked for.
struct TensorFunction {
    double value = 0.0;
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    Matrix9d hessian;
};

/// U(theta) with its derivatives.
struct ScalarFunction {
    double value = 0.0;
    double first = 0.0;
    double second = 0.0;
};

/// A hyperelastic law, energy per rest volume W(F) = distortion(F) + bulk(volume_measure(F)).
///
/// The split lets an element replace the volume measure by its mean over the cell, which removes volumetric locking.
/// Both parts are linear in the moduli (mu, kappa), so that their derivative with respect to the moduli is the same function
/// at (d mu, d kappa). The small-strain moduli are mu and kappa, but for the projective law. A degenerate F gives non-finite
/// values, and the line search rejects the step.
class Material {
public:
    virtual ~Material() = default;

    virtual std::string id() const = 0;
    /// One line for a person: the energy as a formula.
    virtual std::string formula() const = 0;

    /// Distortional energy density [J/m3]. mu: shear modulus [Pa]; kappa: bulk modulus [Pa], used by laws without a split.
    virtual TensorFunction distortion(const Eigen::Matrix3d& F, double mu, double kappa, bool with_hessian) const = 0;

    /// Volume measure theta(F), 0 in the rest state, d theta = tr(strain) for small strain.
    virtual TensorFunction volume_measure(const Eigen::Matrix3d& F, bool with_hessian) const = 0;

    /// U(theta) [J/m3], U''(0) = kappa. Zero for laws without a split.
    virtual ScalarFunction bulk(double theta, double kappa) const = 0;
};

using MaterialPointer = std::shared_ptr<const Material>;

}  // namespace myo
