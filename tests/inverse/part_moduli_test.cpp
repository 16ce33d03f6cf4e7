#include "inverse/part_moduli.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>

#include "support/differences.hpp"

namespace myo::inverse::part_moduli_test {
namespace {

using Eigen::VectorXd;

/// Three cells, the second one of both parts and of a rest that is not sought.
TEST(SoughtModuli, ScaleTheSharesOfTheirPartAlone) {
    const Design design = {
        part_moduli({{"root", {{3.0, 30.0}, {1.0, 10.0}, {0.0, 0.0}}}, {"tip", {{0.0, 0.0}, {2.0, 40.0}, {5.0, 50.0}}}},
                    {{0.0, 0.0}, {4.0, 5.0}, {0.0, 0.0}})};
    EXPECT_EQ(design[0]->name(), "Young's modulus of root, tip");
    EXPECT_EQ(declared_design(design), Eigen::Vector2d::Zero());
    const DesignBounds bounds = design_bounds(design);
    EXPECT_NEAR(std::exp(bounds.upper(0)), 10.0, 1e-12);
    EXPECT_NEAR(std::exp(bounds.lower(1)), 0.1, 1e-12);
    EXPECT_EQ(bounds.scales, Eigen::Vector2d::Ones());
    model::Model declared;
    // An effect has made the third cell twice as stiff.
    declared.moduli = {{3.0, 30.0}, {7.0, 55.0}, {10.0, 100.0}};
    const auto with = [&](const VectorXd& values) {
        model::Model model = declared;
        design[0]->apply(values, model);
        return model;
    };
    const model::Model same = with(Eigen::Vector2d::Zero()),
                       stiff = with(Eigen::Vector2d(std::log(2.0), std::log(3.0)));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(same.moduli[c].mu, declared.moduli[c].mu, 1e-12);
    EXPECT_NEAR(stiff.moduli[0].mu, 6.0, 1e-12);
    EXPECT_NEAR(stiff.moduli[1].mu, 2.0 * 1.0 + 3.0 * 2.0 + 4.0, 1e-12);
    EXPECT_NEAR(stiff.moduli[1].kappa, 2.0 * 10.0 + 3.0 * 40.0 + 5.0, 1e-12);
    EXPECT_NEAR(stiff.moduli[2].kappa, 300.0, 1e-12) << "still twice as stiff";
    sensitivity::ModelGradient gradient;
    gradient.moduli = {{0.3, -0.02}, {-0.5, 0.01}, {0.7, 0.03}};
    const auto loss = [&](const VectorXd& values) {
        const model::Model model = with(values);
        double sum = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            sum += gradient.moduli[c].mu * model.moduli[c].mu + gradient.moduli[c].kappa * model.moduli[c].kappa;
        return VectorXd::Constant(1, sum).eval();
    };
    const VectorXd at = Eigen::Vector2d(0.4, -0.8);
    test::expect_derivative(design_gradient(design, at, with(at), gradient).transpose(),
                            test::central_differences(loss, at, 1e-5), 1e-8, "moduli");
}

}  // namespace
}  // namespace myo::inverse::part_moduli_test
