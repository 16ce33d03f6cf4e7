#include "model/force_element.hpp"

#include <algorithm>
#include <cassert>

#include "base/text.hpp"

namespace myo::model {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

// Default by unit changes: p . (tangent along each parameter).
void ForceElement::add_work(const Body& body, const ForceState& at, const Matrix3Xd& p, VectorXd& by_parameter) const {
    for (Eigen::Index k = 0; k < by_parameter.size(); ++k) {
        Matrix3Xd gradient = Matrix3Xd::Zero(3, p.cols());
        // One tangent per parameter. Elements with many parameters provide a direct implementation.
        add_tangent(body, at, VectorXd::Unit(by_parameter.size(), k), gradient);
        by_parameter(k) += gradient.cwiseProduct(p).sum();
    }
}

VectorXd parameter_values(const ForceElement& element) {
    const std::vector<ForceParameter> parameters = element.parameters();
    VectorXd values(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k) values(static_cast<Eigen::Index>(k)) = parameters[k].value;
    return values;
}

bool depends_on_velocity(const Model& model) {
    return std::any_of(model.force_elements.begin(), model.force_elements.end(),
                       [](const ForceElementPointer& e) { return e->depends_on_velocity(); });
}

bool has_potential(const Model& model) {
    return std::all_of(model.force_elements.begin(), model.force_elements.end(),
                       [](const ForceElementPointer& e) { return e->has_potential(); });
}

Matrix3Xd unsymmetric_product(const Model& model, const ForceState& at, const Matrix3Xd& field, StiffnessForm form) {
    assert(form != StiffnessForm::symmetric);
    Matrix3Xd result = Matrix3Xd::Zero(3, field.cols());
    for (const ForceElementPointer& element : model.force_elements)
        if (form == StiffnessForm::complete)
            element->add_unsymmetric_tangent(*model.body, at, field, result);
        else
            element->add_unsymmetric_pull(*model.body, at, field, result);
    return result;
}

std::string command_words(const Model& model, double time_s, bool before) {
    std::vector<std::string> words;
    for (const ForceElementPointer& element : model.force_elements) {
        const fibre::Signal* const command = element->command();
        if (command && (before ? command->value_before(time_s) : command->value(time_s)) != 0.0)
            words.push_back(element->command_words(time_s, before));
    }
    return join(words, " and ");
}

Model with_constant_commands(const Model& model, double factor, double time_s) {
    Model result = model;
    for (ForceElementPointer& element : result.force_elements)
        if (const fibre::Signal* const command = element->command())
            element = element->with_command(fibre::Signal::constant(factor * command->value_before(time_s)));
    return result;
}

bool has_commands(const Model& model, double time_s) {
    return std::any_of(model.force_elements.begin(), model.force_elements.end(), [&](const ForceElementPointer& e) {
        return e->command() && e->command()->value_before(time_s) != 0.0;
    });
}

void add_force_elements(const Model& model, const ForceState& at, HessianKind kind, InternalEnergy& out) {
    for (const ForceElementPointer& element : model.force_elements) element->add(*model.body, at, kind, out);
}

Matrix3Xd velocity_tangent(const Model& model, const ForceState& at, const Matrix3Xd& dv) {
    Matrix3Xd gradient = Matrix3Xd::Zero(3, at.x.cols());
    for (const ForceElementPointer& element : model.force_elements)
        element->add_velocity_tangent(*model.body, at, dv, gradient);
    return gradient;
}

Matrix3Xd velocity_pull(const Model& model, const ForceState& at, const Matrix3Xd& p) {
    Matrix3Xd by_v = Matrix3Xd::Zero(3, at.x.cols());
    for (const ForceElementPointer& element : model.force_elements)
        element->add_velocity_pull(*model.body, at, p, by_v);
    return by_v;
}

}  // namespace myo::model
