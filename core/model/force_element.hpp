#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Where, how fast and when a force element is asked.
struct ForceState {
    const Eigen::Matrix3Xd& x;            // 3 x n [m]
    const Eigen::Matrix3Xd* v = nullptr;  // 3 x n [m/s]; null: at rest
    double velocity_factor_1_s = 0.0;     // dv/dx of the step
    double time_s = 0.0;
    bool before_jump = false;  // signals from the left of time_s
};

/// A number a force element can be differentiated by.
struct ForceParameter {
    std::string name;  // with its unit
    double value = 0.0;
    double scale = 1.0;  // a change of this size matters
};

/// A force on a body beside its material, its fibres and dead loads: a spring, a pressure, a drag. Immutable.
///
/// It is the gradient of a potential, as all in a step is. One that depends on the velocity has the potential
/// D(v) / velocity_factor, whose gradient is dD/dv and whose Hessian velocity_factor d2D/dv2.
class ForceElement {
public:
    virtual ~ForceElement() = default;

    /// Adds potential [J], its gradient (minus the force, 3 x n [N]) and, unless `kind` is none, its Hessian; the
    /// Hessian couples only nodes of one cell. Kinds other than exact ask for positive semi-definite parts alone.
    virtual void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const = 0;

    virtual bool depends_on_velocity() const { return false; }
    /// Derivative of the gradient along dv [m/s], positions held; symmetric in dv and what it is multiplied by.
    virtual void add_velocity_tangent(const Body&, const ForceState&, const Eigen::Matrix3Xd&,
                                      Eigen::Matrix3Xd&) const {}

    virtual std::vector<ForceParameter> parameters() const = 0;
    /// The same with other values of the parameters.
    virtual std::shared_ptr<const ForceElement> changed(const Eigen::VectorXd& values) const = 0;
    /// Derivative of the gradient along a change of the parameters.
    virtual void add_tangent(const Body& body, const ForceState& at, const Eigen::VectorXd& change,
                             Eigen::Matrix3Xd& gradient) const = 0;
    /// Adds p . (derivative of the gradient) for each parameter; p is 3 x n.
    virtual void add_work(const Body& body, const ForceState& at, const Eigen::Matrix3Xd& p,
                          Eigen::VectorXd& by_parameter) const;

    /// Whether its potential is the same function of positions at both times.
    virtual bool steady(double, double) const { return true; }
    /// Times at which it jumps.
    virtual std::vector<double> jumps() const { return {}; }
};

/// Values of its parameters.
Eigen::VectorXd parameter_values(const ForceElement& element);

/// Whether any element of the model depends on the velocity.
bool depends_on_velocity(const Model& model);

/// Adds all elements of the model.
void add_force_elements(const Model& model, const ForceState& at, HessianKind kind, InternalEnergy& out);

/// Derivative of their gradient along dv, 3 x n [N].
Eigen::Matrix3Xd velocity_tangent(const Model& model, const ForceState& at, const Eigen::Matrix3Xd& dv);

}  // namespace myo::model
