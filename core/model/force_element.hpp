#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "fibre/signal.hpp"
#include "model/internal_forces.hpp"

namespace myo::model {

/// State at which a force element is evaluated.
struct ForceState {
    const Eigen::Matrix3Xd& x;            // node positions, 3 x n [m]
    const Eigen::Matrix3Xd* v = nullptr;  // node velocities, 3 x n [m/s]; null: at rest
    double velocity_factor_1_s = 0.0;     // [1/s] dv/dx of the time step
    double time_s = 0.0;                  // [s]
    bool before_jump = false;             // use the left limit of signals at time_s
};

/// Parameter by which a force element can be differentiated.
struct ForceParameter {
    std::string name;    // key with unit
    double value = 0.0;  // current value
    double scale = 1.0;  // typical magnitude of a change, for scaling
};

/// External force on a body in addition to material, fibres and dead loads: a spring, a pressure, a drag. Immutable.
///
/// The force is usually the gradient of a potential, like all terms of a time step. A velocity-dependent force has the
/// potential D(v) / velocity_factor, with gradient dD/dv and Hessian velocity_factor d2D/dv2. A force without
/// potential, such as friction that grows with a normal force, has a Hessian that is the symmetric part of its
/// stiffness that Newton's method may factor; the rest is given by add_unsymmetric_tangent().
class ForceElement {
public:
    virtual ~ForceElement() = default;

    /// Adds potential [J], gradient (minus the force, 3 x n [N]) and, unless `kind` is none, the Hessian [N/m].
    ///
    /// The Hessian may couple only nodes of one cell. For kinds other than exact it must be positive semidefinite.
    virtual void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const = 0;

    /// True if the force changes with the velocity.
    virtual bool depends_on_velocity() const { return false; }
    /// Adds the derivative of the gradient along dv [m/s] at fixed positions.
    virtual void add_velocity_tangent(const Body&, const ForceState&, const Eigen::Matrix3Xd&,
                                      Eigen::Matrix3Xd&) const {}
    /// Transpose of add_velocity_tangent(): adds the adjoint of v for the adjoint p of the gradient, both 3 x n. The
    /// same for the symmetric operators that dissipation potentials have.
    virtual void add_velocity_pull(const Body& body, const ForceState& at, const Eigen::Matrix3Xd& p,
                                   Eigen::Matrix3Xd& by_v) const {
        add_velocity_tangent(body, at, p, by_v);
    }

    /// Whether the force is the gradient of the potential that add() adds.
    virtual bool has_potential() const { return true; }
    /// Adds what the derivative of the gradient along dx (3 x n [m]) has beyond the Hessian.
    virtual void add_unsymmetric_tangent(const Body&, const ForceState&, const Eigen::Matrix3Xd&,
                                         Eigen::Matrix3Xd&) const {}
    /// Transpose of add_unsymmetric_tangent(): adds the adjoint of x for the adjoint p of the gradient, both 3 x n.
    virtual void add_unsymmetric_pull(const Body&, const ForceState&, const Eigen::Matrix3Xd&,
                                      Eigen::Matrix3Xd&) const {}

    /// Signal that drives the element: pressure of a chamber, tension or shortening of a tendon. Its knots are the
    /// first parameters. Null: none.
    virtual const fibre::Signal* command() const { return nullptr; }
    /// Copy with another command; null if the element has none.
    virtual std::shared_ptr<const ForceElement> with_command(const fibre::Signal&) const { return nullptr; }
    /// The command at an instant in words, for messages: "12000 Pa in chamber upper"; empty if there is none.
    virtual std::string command_words(double, bool) const { return {}; }

    /// Parameters in the order of changed() and add_tangent().
    virtual std::vector<ForceParameter> parameters() const = 0;
    /// Copy with other parameter values.
    virtual std::shared_ptr<const ForceElement> changed(const Eigen::VectorXd& values) const = 0;
    /// Adds the derivative of the gradient along a change of the parameters, 3 x n [N].
    virtual void add_tangent(const Body& body, const ForceState& at, const Eigen::VectorXd& change,
                             Eigen::Matrix3Xd& gradient) const = 0;
    /// Transpose of add_tangent(): by_parameter(k) += p . (derivative of the gradient by parameter k), p of 3 x n.
    virtual void add_work(const Body& body, const ForceState& at, const Eigen::Matrix3Xd& p,
                          Eigen::VectorXd& by_parameter) const;

    /// True if the potential is the same function of positions throughout the interval (from_s, to_s).
    virtual bool steady(double, double) const { return true; }
    /// Times [s] at which the force is discontinuous.
    virtual std::vector<double> jumps() const { return {}; }
};

/// Values of all parameters in order.
Eigen::VectorXd parameter_values(const ForceElement& element);

/// True if any force element of the model depends on the velocity.
bool depends_on_velocity(const Model& model);

/// True if all force elements of the model have a potential: the stiffness matrix of the body is then symmetric.
bool has_potential(const Model& model);

/// The stiffness of a body with forces without potential: complete, its transpose, or its symmetric part alone, the
/// Hessian, as for vibrations. Without such forces all are the same.
enum class StiffnessForm { complete, transposed, symmetric };

/// Product of the part of the stiffness that the Hessian lacks with a nodal field, 3 x n; asserts that the form has
/// such a part.
Eigen::Matrix3Xd unsymmetric_product(const Model& model, const ForceState& at, const Eigen::Matrix3Xd& field,
                                     StiffnessForm form);

/// Commands of all force elements at an instant in words, those at zero left out: "12000 Pa in chamber upper".
///
/// @param before  left limit at a discontinuity
std::string command_words(const Model& model, double time_s, bool before = false);

/// Copy of the model in which every command is constant: `factor` times its value just before `time_s`.
Model with_constant_commands(const Model& model, double factor, double time_s);

/// True if any command differs from zero just before `time_s`.
bool has_commands(const Model& model, double time_s);

/// Adds all force elements of the model to `out`.
void add_force_elements(const Model& model, const ForceState& at, HessianKind kind, InternalEnergy& out);

/// Derivative of the gradient of all force elements along dv (3 x n [m/s]), 3 x n [N].
Eigen::Matrix3Xd velocity_tangent(const Model& model, const ForceState& at, const Eigen::Matrix3Xd& dv);

/// Transpose of velocity_tangent(): adjoint of v for the adjoint p of the gradient, both 3 x n.
Eigen::Matrix3Xd velocity_pull(const Model& model, const ForceState& at, const Eigen::Matrix3Xd& p);

}  // namespace myo::model
