#include "inverse/design.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Calls visit(variable, first, count) for the range of each variable in the vector of all values.
template <class Visit>
void for_each_variable(const Design& design, const Visit& visit) {
    Index first = 0;
    for (const DesignVariablePointer& variable : design) {
        const Index count = variable->declared().size();
        visit(*variable, first, count);
        first += count;
    }
}

}  // namespace

double DesignVariable::roughness(const VectorXd&, double, VectorXd&) const { return 0.0; }

VectorXd declared_design(const Design& design) {
    VectorXd all;
    for_each_variable(design, [&](const DesignVariable& variable, Index first, Index count) {
        all.conservativeResize(first + count);
        all.tail(count) = variable.declared();
    });
    return all;
}

VectorXd values_of(const Design& design, std::size_t variable, const VectorXd& values) {
    VectorXd own;
    for_each_variable(design, [&](const DesignVariable& each, Index first, Index count) {
        if (&each == design[variable].get()) own = values.segment(first, count);
    });
    return own;
}

DesignBounds design_bounds(const Design& design) {
    const Index count = declared_design(design).size();
    DesignBounds bounds{VectorXd(count), VectorXd(count), VectorXd(count)};
    for_each_variable(design, [&](const DesignVariable& variable, Index first, Index own) {
        const DesignRange range = variable.range();
        bounds.lower.segment(first, own) = range.lower;
        bounds.upper.segment(first, own) = range.upper;
        bounds.scales.segment(first, own).setConstant(range.scale);
    });
    return bounds;
}

model::Model designed_model(const Design& design, const VectorXd& values, model::Model model) {
    // Derivatives by moduli hold the thinning of the cells, so the model must, too.
    if (!design.empty() && model.poissons_ratio.empty()) model.poissons_ratio = model::poissons_ratios(model.moduli);
    for_each_variable(design, [&](const DesignVariable& variable, Index first, Index count) {
        variable.apply(values.segment(first, count), model);
    });
    return model;
}

VectorXd design_gradient(const Design& design, const VectorXd& values, const model::Model& model,
                         const sensitivity::ModelGradient& gradient) {
    VectorXd all = VectorXd::Zero(values.size());
    for_each_variable(design, [&](const DesignVariable& variable, Index first, Index count) {
        all.segment(first, count) = variable.gradient(values.segment(first, count), model, gradient);
    });
    return all;
}

double design_roughness(const Design& design, const VectorXd& values, double weight, VectorXd& gradient) {
    double sum = 0.0;
    for_each_variable(design, [&](const DesignVariable& variable, Index first, Index count) {
        VectorXd own = VectorXd::Zero(count);
        sum += variable.roughness(values.segment(first, count), weight, own);
        gradient.segment(first, count) += own;
    });
    return sum;
}

}  // namespace myo::inverse
