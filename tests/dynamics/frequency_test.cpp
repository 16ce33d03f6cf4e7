#include <gtest/gtest.h>

#include <numbers>

#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo {
namespace {

using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

test::BeamSpec slender(const char* element, double nu) {
    test::BeamSpec spec;
    spec.kind = test::element(element);
    spec.size = {0.4, 0.024, 0.02};   // bends along z first; length to height 20
    // Poisson's ratio is left out of the strains that vary within a cell, so nu > 0 needs more layers than one.
    const int layers = nu > 0.0 ? 4 : 2;
    spec.cells = spec.kind == ElementKind::tet10 ? Eigen::Vector3i(30, layers - 1, layers - 1) : Eigen::Vector3i(40, layers, layers);
    spec.poissons_ratio = nu;
    return spec;
}

/// Smallest root of 1 + cos b cosh b + r b (cos b sinh b - sin b cosh b) = 0: clamped beam with r times its mass at the tip.
double tip_mass_root(double r) {
    const auto f = [&](double b) {
        return 1.0 + std::cos(b) * std::cosh(b) + r * b * (std::cos(b) * std::sinh(b) - std::sin(b) * std::cosh(b));
    };
    double low = 0.1, high = 2.0;
    for (int i = 0; i < 100; ++i) (f(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    return low;
}

/// omega = b^2 sqrt(E I / (rho A L^4)). Source: Blevins 1979, table 8-1.
double euler_bernoulli(const test::BeamSpec& spec, double root) {
    return root * root * std::sqrt(spec.youngs_modulus_Pa * test::second_moment(spec) /
                                   (spec.density_kg_m3 * test::section_area(spec) * std::pow(spec.size(0), 4)));
}

/// Bends the beam by a hundredth of its length until t = 0.
void hold_until_zero(Model& model, const test::BeamSpec& spec) {
    const double force = 3e-2 * spec.youngs_modulus_Pa * test::second_moment(spec) / (spec.size(0) * spec.size(0));
    test::push_tip(model, spec, {0.0, 0.0, -force});
    model.forces.back().until_s = 0.0;
}

TEST(FirstFrequency, RootWithoutTipMassIsTheTextbooks) { EXPECT_NEAR(tip_mass_root(0.0), 1.8751041, 1e-7); }

TEST(FirstFrequency, OfMassAndStiffnessMeetsBeamTheory) {
    for (const char* element : {"hex8", "tet10"})
        for (const double nu : {0.0, 0.3}) {
            const test::BeamSpec spec = slender(element, nu);
            const double error = test::first_mode(test::make_beam(spec)).omega / euler_bernoulli(spec, tip_mass_root(0.0)) - 1.0;
            test::record(std::string(element) + (nu > 0.0 ? "_nu03" : "_nu0"), error);
            EXPECT_LT(std::abs(error), 0.01) << element << " " << nu;
        }
}

TEST(FirstFrequency, OfTheReleasedBeamMeetsBeamTheory) {
    const test::BeamSpec spec = slender("hex8", 0.0);
    Model model = test::make_beam(spec);
    hold_until_zero(model, spec);
    const double exact = euler_bernoulli(spec, tip_mass_root(0.0));
    const double h = 2.0 * pi / exact / 60.0;
    const test::Mode mode = test::first_mode(model);
    const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 120);
    ASSERT_GT(q.size(), 0);
    const test::Oscillation motion = test::fit_oscillation(q, h);
    test::record("error_to_beam_theory", motion.omega_damped / exact - 1.0);
    test::record("error_to_the_mode", motion.omega_damped / mode.omega - 1.0);
    EXPECT_LT(std::abs(motion.omega_damped / exact - 1.0), 0.01);
    EXPECT_LT(std::abs(motion.omega_damped / mode.omega - 1.0), 5e-4);

    // Zero crossings of the tip itself, without the mode shape: quarter period, then half periods.
    std::vector<double> crossings;
    for (Eigen::Index k = 1; k < q.size(); ++k)
        if ((q(k - 1) < 0.0) != (q(k) < 0.0)) crossings.push_back(h * (static_cast<double>(k) - q(k) / (q(k) - q(k - 1))));
    ASSERT_GE(crossings.size(), 3u);
    const double half_period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    EXPECT_NEAR(pi / half_period / exact, 1.0, 0.01);
}

/// Weight and inertia of an attached mass: deflection and frequency.
TEST(AttachedMass, DeflectsAndSlowsTheBeamAsTheFormulasSay) {
    for (const double ratio : {0.5, 2.0}) {
        test::BeamSpec spec = slender("hex8", 0.0);
        Model model = test::make_beam(spec);
        const double body = spec.density_kg_m3 * spec.size.prod();
        model.masses.push_back({test::tip_share(model, spec), ratio * body});
        const double error = test::first_mode(model).omega / euler_bernoulli(spec, tip_mass_root(ratio)) - 1.0;
        test::record("frequency_error_ratio_" + std::to_string(static_cast<int>(10 * ratio)), error);
        EXPECT_LT(std::abs(error), 0.01) << ratio;

        const double g = 1e-3;   // small, so that the deflection stays small
        model.gravity_m_s2 = {0.0, 0.0, -g};
        StageSolver solver(model);
        Eigen::Matrix3Xd x = model.body->mesh.nodes;
        ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
        const double EI = spec.youngs_modulus_Pa * test::second_moment(spec), L3 = std::pow(spec.size(0), 3);
        const double exact = body * g * L3 / (8.0 * EI) + ratio * body * g * L3 / (3.0 * EI);
        const double deflection_error = -test::tip_displacement(model, spec, x)(2) / exact - 1.0;
        test::record("deflection_error_ratio_" + std::to_string(static_cast<int>(10 * ratio)), deflection_error);
        EXPECT_LT(std::abs(deflection_error), 0.01) << ratio;
    }
}

}  // namespace
}  // namespace myo
