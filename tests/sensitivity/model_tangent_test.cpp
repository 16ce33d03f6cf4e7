#include "sensitivity/model_tangent.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <vector>

#include "sensitivity/driven_beam.hpp"
#include "support/meshes.hpp"

namespace myo::sensitivity::model_tangent_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;
using fibre::Signal;

/// The driven beam somewhat out of shape, with a strain rate.
struct Bent {
    model::Model model = test::driven_beam(fem::ElementKind::hex8);
    Matrix3Xd x;
    VectorXd rate;

    Bent() {
        const Matrix3Xd& X = model.body->mesh.nodes;
        x = X + 5e-4 * test::rough_field(X.cols(), 0.2);
        rate = model::strain_tangent(model, x, test::rough_field(X.cols(), 1.4));
    }
    /// Gradient of material and fibres at x under the strain rate.
    Matrix3Xd gradient(const model::Model& of, double time_s, bool before = false) const {
        const model::Stiffness own = model::stiffness(of);
        const std::vector<double> activation = model::activations(of, time_s, before);
        model::InternalInput input;
        input.stiffness = &own;
        input.activation = &activation;
        input.rate = {0.0, &rate};
        return model::internal_energy(of, x, input, model::HessianKind::none).gradient;
    }
    void expect_tangent(const ModelTangent& tangent, const model::Model& up, const model::Model& down, double width,
                        const char* what, double time_s = 0.015, bool before = false) const {
        const Matrix3Xd exact = gradient_tangent(model, tangent, x, rate, time_s, before);
        const Matrix3Xd difference = (gradient(up, time_s, before) - gradient(down, time_s, before)) / width;
        EXPECT_GT(difference.norm(), 0.0) << what;
        EXPECT_LT((exact - difference).norm(), 1e-9 * difference.norm()) << what;
    }
};

/// Forces are linear in Young's modulus, in damping times and in activations: large differences are exact.
TEST(ModelTangents, AreTheDerivativesOfTheForces) {
    const Bent bent;
    const double E = 2.6e5;
    const auto with = [&](double by_modulus, double by_damping) {
        model::Model changed = bent.model;
        for (material::Moduli& m : changed.moduli) m = {m.mu * (1.0 + by_modulus), m.kappa * (1.0 + by_modulus)};
        changed.poissons_ratio = model::poissons_ratios(bent.model.moduli);
        changed.damping_s += by_damping;
        return changed;
    };
    bent.expect_tangent(youngs_modulus_tangent(bent.model, E), with(0.3, 0.0), with(-0.3, 0.0), 0.6 * E, "modulus");
    bent.expect_tangent(damping_tangent(), with(0.0, 1e-3), with(0.0, -1e-3), 2e-3, "damping");
    ModelTangent both = youngs_modulus_tangent(bent.model, E);
    EXPECT_NEAR(both.moduli[0].mu * E, bent.model.moduli[0].mu, 1e-9);
    both.damping_s = 1e-6;
    const Matrix3Xd sum = gradient_tangent(bent.model, both, bent.x, bent.rate, 0.0, false),
                    parts = gradient_tangent(bent.model, youngs_modulus_tangent(bent.model, E), bent.x, bent.rate, 0.0,
                                             false) +
                            1e-6 * gradient_tangent(bent.model, damping_tangent(), bent.x, bent.rate, 0.0, false);
    EXPECT_LT((sum - parts).norm(), 1e-12 * parts.norm());
}

TEST(ModelTangents, OfActivationsFollowTheirSignalOnItsSide) {
    const Bent bent;
    ModelTangent tangent;
    tangent.activation = {Signal::step(0.015, 2.0, -1.0), Signal::constant(0.5)};
    EXPECT_EQ(activation_tangent(tangent, 0.015, true), (std::vector<double>{2.0, 0.5}));
    EXPECT_EQ(activation_tangent(tangent, 0.015, false), (std::vector<double>{-1.0, 0.5}));
    EXPECT_TRUE(activation_tangent(ModelTangent{}, 0.015, false).empty());
    const auto moved = [&](double by) {
        model::Model changed = bent.model;
        for (std::size_t g = 0; g < 2; ++g) {
            // Constant activations about those of the instant, changed by the signal of the tangent.
            const double now = bent.model.activation[g].value(0.015), change = tangent.activation[g].value(0.015);
            changed.activation[g] = Signal::constant(now + by * change);
        }
        return changed;
    };
    bent.expect_tangent(tangent, moved(0.1), moved(-0.1), 0.2, "activation");
}

TEST(ModelTangents, OfStiffnessKnowDampingAndCreep) {
    Bent bent;
    model::Model& model = bent.model;
    const ModelTangent modulus = youngs_modulus_tangent(model, 2.6e5);
    EXPECT_NEAR(stiffness_tangent(model, modulus).viscous.at(1).mu, 0.003 * modulus.moduli[1].mu, 1e-15);
    EXPECT_FALSE(stiffness_tangent(model, modulus).fibres) << "activations are a part of their own";
    EXPECT_TRUE(stiffness_tangent(model, damping_tangent()).elastic.empty());
    EXPECT_EQ(stiffness_tangent(model, damping_tangent()).viscous.at(1).kappa, model.moduli[1].kappa);
    model.damping_excess_s = std::vector<double>(model.moduli.size(), 0.0);
    model.damping_excess_s[1] = 0.02;
    EXPECT_NEAR(stiffness_tangent(model, modulus).viscous.at(1).mu, 0.023 * modulus.moduli[1].mu, 1e-15);
    model.damping_excess_s.clear();
    model.damping_s = 0.0;
    EXPECT_TRUE(stiffness_tangent(model, modulus).viscous.empty()) << "nothing is viscous";
    EXPECT_EQ(stiffness_tangent(model, damping_tangent()).viscous.size(), model.moduli.size());
    model.creep = material::MaxwellBranch{0.5, 0.1};
    EXPECT_EQ(stiffness_tangent(model, modulus).viscous.at(1).mu, modulus.moduli[1].mu) << "rates have their factors";
}

TEST(ModelTangents, OfForceElementsAddThoseOfEachElement) {
    const model::Model model = test::blown_block(fem::ElementKind::hex8);
    const Matrix3Xd X = model.body->mesh.nodes, v = test::rough_field(X.cols(), 0.5);
    const Matrix3Xd x = X + 1e-4 * test::rough_field(X.cols(), 0.1);
    const model::ForceState at{x, &v, 100.0, 0.005};
    ModelTangent tangent;
    EXPECT_EQ(force_element_tangent(model, tangent, at).norm(), 0.0);
    tangent.force_elements = {VectorXd::Constant(1, 1e5), VectorXd(), VectorXd(Eigen::Vector4d(1e3, 0.0, 0.0, 2e3))};
    Matrix3Xd expected = Matrix3Xd::Zero(3, X.cols());
    model.force_elements[0]->add_tangent(*model.body, at, tangent.force_elements[0], expected);
    model.force_elements[2]->add_tangent(*model.body, at, tangent.force_elements[2], expected);
    EXPECT_GT(expected.norm(), 0.0);
    EXPECT_EQ(force_element_tangent(model, tangent, at), expected) << "an empty change is none";
}

}  // namespace
}  // namespace myo::sensitivity::model_tangent_tests
