#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "sensitivity/model_gradient.hpp"

namespace myo::inverse {

/// Values of a design variable: bounds, and the size of a typical change, in which different variables are comparable.
struct DesignRange {
    Eigen::VectorXd lower, upper;  // one entry per value
    double scale = 1.0;            // > 0
};

/// A quantity of the body that a search may change besides the signals of its actuators, such as the fibre direction of
/// a muscle. Its values are dimensionless numbers.
class DesignVariable {
public:
    virtual ~DesignVariable() = default;

    /// For people: "fibre direction of left".
    virtual std::string name() const = 0;
    /// Values of the declared body.
    virtual Eigen::VectorXd declared() const = 0;
    virtual DesignRange range() const = 0;
    /// Gives a model that has the declared values of this variable these ones instead.
    virtual void apply(const Eigen::VectorXd& values, model::Model& model) const = 0;
    /// Chain rule: derivative with respect to the values.
    ///
    /// @param model     with these values applied
    /// @param gradient  with the derivatives at the points of the fibres if changes_fibres()
    virtual Eigen::VectorXd gradient(const Eigen::VectorXd& values, const model::Model& model,
                                     const sensitivity::ModelGradient& gradient) const = 0;
    /// Whether gradient() needs the derivatives at the points of the fibres, which cost time.
    virtual bool changes_fibres() const { return false; }
    /// Dimensionless measure of how uneven the change over the body is. Adds `weight` times its derivative to
    /// `gradient`.
    virtual double roughness(const Eigen::VectorXd& values, double weight, Eigen::VectorXd& gradient) const;
};
using DesignVariablePointer = std::shared_ptr<const DesignVariable>;

/// The design variables of a search; their values stand in one vector, in this order.
using Design = std::vector<DesignVariablePointer>;

/// Values of the declared body.
Eigen::VectorXd declared_design(const Design& design);

/// The values of one variable within those of all.
Eigen::VectorXd values_of(const Design& design, std::size_t variable, const Eigen::VectorXd& values);

/// Bounds of all values; `scales`: one entry per value.
struct DesignBounds {
    Eigen::VectorXd lower, upper, scales;
};
DesignBounds design_bounds(const Design& design);

/// The model with these values.
model::Model designed_model(const Design& design, const Eigen::VectorXd& values, model::Model model);

/// Derivative with respect to all values; see DesignVariable::gradient().
Eigen::VectorXd design_gradient(const Design& design, const Eigen::VectorXd& values, const model::Model& model,
                                const sensitivity::ModelGradient& gradient);

/// Sum of the roughness of all variables. Adds `weight` times its derivative to `gradient`.
double design_roughness(const Design& design, const Eigen::VectorXd& values, double weight, Eigen::VectorXd& gradient);

}  // namespace myo::inverse
