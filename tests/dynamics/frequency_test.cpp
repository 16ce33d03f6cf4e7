#include <gtest/gtest.h>

#include <atomic>
#include <numbers>

#include "base/cancellation.hpp"
#include "dynamics/statics.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo::dynamics {
namespace {

using Eigen::VectorXd;

using std::numbers::pi;

test::BeamSpec slender(const char* element, double nu) {
    test::BeamSpec spec;
    spec.kind = test::element(element);
    spec.size = {0.4, 0.024, 0.02};  // bends along z first; length to height 20
    // Poisson's ratio is left out of the strains that vary within a cell, so nu > 0 needs more layers than one.
    const int layers = nu > 0.0 ? 4 : 2;
    spec.cells = spec.kind == fem::ElementKind::tet10 ? Eigen::Vector3i(30, layers - 1, layers - 1)
                                                      : Eigen::Vector3i(40, layers, layers);
    spec.poissons_ratio = nu;
    return spec;
}

/// Smallest root of 1 + cos b cosh b + r b (cos b sinh b - sin b cosh b) = 0: clamped beam with r times its mass at the
/// tip.
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
    return root * root *
           std::sqrt(spec.youngs_modulus_Pa * test::second_moment(spec) /
                     (spec.density_kg_m3 * test::section_area(spec) * std::pow(spec.size(0), 4)));
}

TEST(FirstFrequency, RootWithoutTipMassIsTheTextbooks) { EXPECT_NEAR(tip_mass_root(0.0), 1.8751041, 1e-7); }

TEST(FirstFrequency, OfMassAndStiffnessMeetsBeamTheory) {
    for (const char* element : {"hex8", "tet10"})
        for (const double nu : {0.0, 0.3}) {
            const test::BeamSpec spec = slender(element, nu);
            const double error = test::first_mode(test::make_beam(spec)).omega_rad_s /
                                     euler_bernoulli(spec, tip_mass_root(0.0)) -
                                 1.0;
            test::record(std::string(element) + (nu > 0.0 ? "_nu03" : "_nu0"), error);
            EXPECT_LT(std::abs(error), 0.01) << element << " " << nu;
        }
}

/// Rounding ends the iteration early there; a wide cantilever vibrates between a beam and a plate that bends to a
/// cylinder.
TEST(FirstFrequency, OfAThinNearlyIncompressiblePlateIsFound) {
    test::BeamSpec spec;
    spec.kind = test::element("tet10");
    spec.size = {0.0164, 0.0076, 0.0011};
    spec.cells = {15, 7, 2};
    spec.poissons_ratio = 0.4995;
    spec.youngs_modulus_Pa = 2e7;
    const model::Model model = test::make_beam(spec);
    StageSolver solver(model);
    const NaturalModes modes = natural_modes(solver, model.body->mesh.nodes, 2);
    ASSERT_TRUE(modes.ok()) << modes.residual;
    const double beam = euler_bernoulli(spec, tip_mass_root(0.0));
    const double cylinder = beam / std::sqrt(1.0 - spec.poissons_ratio * spec.poissons_ratio);
    EXPECT_GT(modes.modes[0].omega_rad_s, 0.97 * beam);
    EXPECT_LT(modes.modes[0].omega_rad_s, 1.02 * cylinder);
    EXPECT_GT(modes.modes[1].omega_rad_s, modes.modes[0].omega_rad_s);
}

TEST(FirstFrequency, IsNotSoughtFurtherWhereTheTaskIsCancelled) {
    const model::Model model = test::make_beam(slender("hex8", 0.0));
    std::atomic<bool> stop{true};
    const Progress progress({}, &stop);
    const CancellationScope scope(&progress);
    StageSolver solver(model);
    EXPECT_FALSE(natural_modes(solver, model.body->mesh.nodes, 1).ok());
    stop = false;
    EXPECT_TRUE(natural_modes(solver, model.body->mesh.nodes, 1).ok());
}

TEST(FirstFrequency, OfTheReleasedBeamMeetsBeamTheory) {
    const test::BeamSpec spec = slender("hex8", 0.0);
    model::Model model = test::make_beam(spec);
    test::hold_until_zero(model, spec);
    const double exact = euler_bernoulli(spec, tip_mass_root(0.0));
    const double h = 2.0 * pi / exact / 60.0;
    const NaturalMode mode = test::first_mode(model);
    const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 120);
    ASSERT_GT(q.size(), 0);
    const test::Oscillation motion = test::fit_oscillation(q, h);
    test::record("error_to_beam_theory", motion.omega_damped / exact - 1.0);
    test::record("error_to_the_mode", motion.omega_damped / mode.omega_rad_s - 1.0);
    EXPECT_LT(std::abs(motion.omega_damped / exact - 1.0), 0.01);
    EXPECT_LT(std::abs(motion.omega_damped / mode.omega_rad_s - 1.0), 5e-4);

    // Zero crossings of the tip itself, without the mode shape: quarter period, then half periods.
    std::vector<double> crossings;
    for (Eigen::Index k = 1; k < q.size(); ++k)
        if ((q(k - 1) < 0.0) != (q(k) < 0.0))
            crossings.push_back(h * (static_cast<double>(k) - q(k) / (q(k) - q(k - 1))));
    ASSERT_GE(crossings.size(), 3u);
    const double half_period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    EXPECT_NEAR(pi / half_period / exact, 1.0, 0.01);
}

/// The lowest modes of a slender beam: bending along z and y, whose frequencies are as height to width, then second
/// bending.
TEST(NaturalModes, OfABeamAreThoseOfBeamTheory) {
    const test::BeamSpec spec = slender("hex8", 0.0);
    const model::Model model = test::make_beam(spec);
    StageSolver solver(model);
    const NaturalModes found = natural_modes(solver, model.body->mesh.nodes, 4);
    ASSERT_TRUE(found.ok());
    const double first = euler_bernoulli(spec, 1.8751041), second = euler_bernoulli(spec, 4.6940911);
    const std::vector<double> theory = {first, 1.2 * first, second, 1.2 * second};
    std::vector<double> error;
    for (std::size_t k = 0; k < theory.size(); ++k) error.push_back(found.modes[k].omega_rad_s / theory[k] - 1.0);
    test::record("errors", error);
    test::record("iterations", found.iterations);
    for (const double e : error) EXPECT_LT(std::abs(e), 0.03);  // the second ones shear visibly
    for (std::size_t k = 0; k < theory.size(); ++k)
        for (std::size_t l = 0; l < theory.size(); ++l) {
            const double product = model::times_mass(found.modes[k].shape, solver.mass(0.0))
                                       .cwiseProduct(found.modes[l].shape)
                                       .sum();
            EXPECT_NEAR(product, k == l ? 1.0 : 0.0, 1e-8);
        }
}

/// About a bent equilibrium: the frequency is that of a small swing about it.
TEST(NaturalModes, AboutALoadedEquilibriumAreThoseOfTheSwing) {
    test::BeamSpec spec = test::ringing_beam();
    spec.gravity_m_s2 = 30.0;  // sags by a fifth of its length
    model::Model model = test::make_beam(spec);
    StageSolver solver(model);
    Eigen::Matrix3Xd x = model.body->mesh.nodes;
    ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
    const NaturalModes found = natural_modes(solver, x, 1);
    ASSERT_TRUE(found.ok());
    const NaturalMode& mode = found.modes.front();
    test::push_tip(model, spec, {0.0, 0.0, -1e-3});
    model.forces.back().until_s = 0.0;
    const double h = 2.0 * pi / mode.omega_rad_s / 60.0;
    const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 60);
    ASSERT_GT(q.size(), 0);
    const double rest = model::times_mass(mode.shape, solver.mass(0.0)).cwiseProduct(x - model.body->mesh.nodes).sum();
    EXPECT_NEAR(test::fit_oscillation(q.array() - rest, h).omega_damped / mode.omega_rad_s, 1.0, 1e-3);
    EXPECT_GT(std::abs(mode.omega_rad_s / test::first_mode(test::make_beam(test::ringing_beam())).omega_rad_s - 1.0),
              5e-3);
}

TEST(NaturalModes, OfABodyThatIsNotHeldAreRefused) {
    test::BeamSpec spec;
    spec.clamped = false;
    const model::Model model = test::make_beam(spec);
    StageSolver solver(model);
    EXPECT_FALSE(natural_modes(solver, model.body->mesh.nodes, 1).ok());
}

/// Weight and inertia of an attached mass: deflection and frequency.
TEST(AttachedMass, DeflectsAndSlowsTheBeamAsTheFormulasSay) {
    for (const double ratio : {0.5, 2.0}) {
        test::BeamSpec spec = slender("hex8", 0.0);
        model::Model model = test::make_beam(spec);
        const double body = spec.density_kg_m3 * spec.size.prod();
        model.masses.push_back({test::tip_share(model, spec), ratio * body});
        const double error = test::first_mode(model).omega_rad_s / euler_bernoulli(spec, tip_mass_root(ratio)) - 1.0;
        test::record("frequency_error_ratio_" + std::to_string(static_cast<int>(10 * ratio)), error);
        EXPECT_LT(std::abs(error), 0.01) << ratio;

        const double g = 1e-3;  // small, so that the deflection stays small
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
}  // namespace myo::dynamics
