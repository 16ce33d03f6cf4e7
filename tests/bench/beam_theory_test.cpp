#include "bench/beam_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench/bench_case.hpp"
#include "material/moduli.hpp"

// Closed forms with which the solver is compared: their limits, symmetries and orders.

namespace myo::bench::beam_theory_test {
namespace {

BarShape bar_of(double length_m, double width_m, double height_m, double poissons_ratio = 0.3) {
    BarShape bar;
    bar.length_m = length_m;
    bar.width_m = width_m;
    bar.height_m = height_m;
    bar.poissons_ratio = poissons_ratio;
    return bar;
}

TEST(BeamTheory, SectionsHaveTheirAreaAndStiffness) {
    BarShape bar = bar_of(0.2, 0.01, 0.004, 0.25);
    bar.youngs_modulus_Pa = 1e6;
    EXPECT_DOUBLE_EQ(bar.area_m2(), 4e-5);
    EXPECT_NEAR(bar.bending_stiffness_N_m2(), 1e6 * 0.01 * std::pow(0.004, 3) / 12.0, 1e-18);
    EXPECT_DOUBLE_EQ(bar.shear_modulus_Pa(), 4e5);
}

/// q L^4 / (8 E I) of a slender bar; what remains is the shear, which goes with the square of the length.
TEST(BeamTheory, TheSagIsThatOfACantileverPlusItsShear) {
    const BarShape slender = bar_of(1.0, 0.01, 1e-3), stout = bar_of(0.03, 0.01, 0.01);
    const auto bending = [](const BarShape& bar) {
        return bar.density_kg_m3 * 9.81 * bar.area_m2() * std::pow(bar.length_m, 4) /
               (8.0 * bar.bending_stiffness_N_m2());
    };
    EXPECT_NEAR(sag_under_gravity(slender, 9.81) / bending(slender), 1.0, 1e-5);
    const double shear = sag_under_gravity(stout, 9.81) - bending(stout);
    EXPECT_NEAR(shear, 1070.0 * 9.81 * 0.03 * 0.03 / (2.0 * 5.0 / 6.0 * stout.shear_modulus_Pa()), 1e-12);
    BarShape twice = stout;
    twice.length_m *= 2.0;
    EXPECT_NEAR((sag_under_gravity(twice, 9.81) - bending(twice)) / shear, 4.0, 1e-9);
    // Linear in gravity, and the width does not matter.
    twice = stout;
    twice.width_m *= 3.0;
    EXPECT_NEAR(sag_under_gravity(twice, 2.0 * 9.81), 2.0 * sag_under_gravity(stout, 9.81), 1e-15);
}

TEST(BeamTheory, TheFirstFrequencyFallsFromThatOfASlenderBar) {
    const auto slender = [](const BarShape& bar) {
        return std::pow(1.8751041 / bar.length_m, 2) *
               std::sqrt(bar.bending_stiffness_N_m2() / (bar.density_kg_m3 * bar.area_m2()));
    };
    // cos k cosh k = -1
    EXPECT_NEAR(std::cos(1.8751041) * std::cosh(1.8751041), -1.0, 1e-6);
    double before = 1.0;
    for (const double height : {1e-4, 1e-3, 1e-2, 2e-2}) {
        const BarShape bar = bar_of(0.1, 0.01, height);
        const double share = first_bending_rad_s(bar) / slender(bar);
        EXPECT_LT(share, before) << height;
        before = share;
    }
    // The difference is of second order in the slenderness.
    const auto missing = [&](double height) {
        const BarShape bar = bar_of(0.1, 0.01, height);
        return 1.0 - first_bending_rad_s(bar) / slender(bar);
    };
    EXPECT_NEAR(missing(2e-3) / missing(1e-3), 4.0, 0.05);
}

/// Saint-Venant: 0.1406 a^4 of a square, and a b^3 / 3 less 0.63 b / a of a strip.
TEST(BeamTheory, TorsionIsThatOfTheSquareAndTheStrip) {
    const BarShape square = bar_of(0.1, 0.01, 0.01), strip = bar_of(0.1, 0.05, 0.001);
    EXPECT_NEAR(torsion_stiffness_N_m(square), square.shear_modulus_Pa() * 0.140577 * 1e-8 / 0.1, 5e-9)
        << "the tabulated factor has six digits";
    EXPECT_NEAR(
        torsion_stiffness_N_m(strip) / (strip.shear_modulus_Pa() * 0.05 * 1e-9 / 3.0 * (1.0 - 0.630249 / 50.0) / 0.1),
        1.0, 1e-5);
    EXPECT_DOUBLE_EQ(torsion_stiffness_N_m(strip), torsion_stiffness_N_m(bar_of(0.1, 0.001, 0.05)));
    EXPECT_NEAR(torsion_stiffness_N_m(bar_of(0.2, 0.01, 0.01)), 0.5 * torsion_stiffness_N_m(square), 1e-15);
}

TEST(BeamTheory, SmallStrainsGiveYoungsModulus) {
    for (const double nu : {0.0, 0.3, 0.49}) {
        const BarShape bar = bar_of(0.1, 0.01, 0.01, nu);
        EXPECT_NEAR(uniaxial_stress(bar, {}, 0.0), 0.0, 1e-6);
        const double slope = (uniaxial_stress(bar, {}, 1e-4) - uniaxial_stress(bar, {}, -1e-4)) / 2e-4;
        EXPECT_NEAR(slope / bar.youngs_modulus_Pa, 1.0, 1e-6) << nu;
    }
}

/// Nominal stress of an incompressible neo-Hookean bar: mu (l - 1/l^2), times 1 + 2 c2 (I1 - 3) with Yeoh's term.
TEST(BeamTheory, LargeStrainsFollowTheIncompressibleLaw) {
    const BarShape bar = bar_of(0.1, 0.01, 0.01, 0.4999);
    const double mu = material::moduli_from_young(bar.youngs_modulus_Pa, bar.poissons_ratio).mu;
    for (const double strain : {-0.3, -0.1, 0.2, 0.5}) {
        const double l = 1.0 + strain, neo = mu * (l - 1.0 / (l * l)), isochoric = l * l + 2.0 / l - 3.0;
        EXPECT_NEAR(uniaxial_stress(bar, {}, strain) / neo, 1.0, 2e-3) << strain;
        EXPECT_NEAR(uniaxial_stress(bar, {.yeoh_c2 = 0.7}, strain) / (neo * (1.0 + 1.4 * isochoric)), 1.0, 2e-3)
            << strain;
        // Softened by nearly all of its limit at energies far beyond the scale, and by nothing far below it.
        EXPECT_NEAR(uniaxial_stress(bar, {.damage_max = 0.4, .energy_scale_J_m3 = 1.0}, strain) / neo, 0.6, 2e-3);
        EXPECT_NEAR(uniaxial_stress(bar, {.damage_max = 0.4, .energy_scale_J_m3 = 1e12}, strain) / neo, 1.0, 2e-3);
        const double energy = 0.5 * mu * isochoric;
        EXPECT_NEAR(uniaxial_stress(bar, {.damage_max = 0.4, .energy_scale_J_m3 = energy}, strain) / neo,
                    1.0 - 0.4 * (1.0 - std::exp(-1.0)), 2e-3);
    }
}

TEST(BeamTheory, AnEndLoadBendsByTheCubeOfTheLength) {
    const BarShape bar = bar_of(0.1, 0.01, 0.01);
    const double linear = 1e-4 * std::pow(bar.length_m, 3) / (3.0 * bar.bending_stiffness_N_m2());
    EXPECT_NEAR(end_load_deflection(bar, {}, 1e-4) / linear, 1.0, 1e-3);
    EXPECT_NEAR(end_load_deflection(bar, {}, -1e-4), -end_load_deflection(bar, {}, 1e-4), 1e-9 * linear);
    // A stiffening law bends less, a softening one more.
    const double force = 0.1;
    EXPECT_LT(end_load_deflection(bar, {.yeoh_c2 = 20.0}, force), end_load_deflection(bar, {}, force));
    EXPECT_GT(end_load_deflection(bar, {.damage_max = 0.3, .energy_scale_J_m3 = 10.0}, force),
              end_load_deflection(bar, {}, force));
}

/// The stress of the bent section has the pull as its force, and no moment about the middle.
TEST(BeamTheory, AGradedBarBendsTowardsItsStifferSide) {
    const BarShape bar = bar_of(0.1, 0.01, 0.01);
    EXPECT_EQ(deflection_of_graded_bar(bar, 0.0, 0.1), 0.0);
    const double pull = 0.05, bent = deflection_of_graded_bar(bar, 0.5, pull);
    EXPECT_GT(bent, 0.0);
    EXPECT_DOUBLE_EQ(deflection_of_graded_bar(bar, -0.5, pull), -bent);
    EXPECT_DOUBLE_EQ(deflection_of_graded_bar(bar, 0.5, 2.0 * pull), 2.0 * bent);
    // Sums over thin layers, with the stiffer side on the inside of the bend.
    const double curvature = 2.0 * bent / (bar.length_m * bar.length_m), r = 0.5, h = bar.height_m;
    double force = 0.0, moment = 0.0, even = 0.0, first = 0.0;
    constexpr int parts = 2000;
    for (int i = 0; i < parts; ++i) {
        const double z = ((i + 0.5) / parts - 0.5) * h,
                     E = bar.youngs_modulus_Pa * (1.0 + r * z / h) * bar.area_m2() / parts;
        even += E, first += E * z;
        force -= E * curvature * z, moment -= E * curvature * z * z;
    }
    const double strain = (pull - force) / even;
    EXPECT_NEAR((moment + strain * first) / (even * strain * h), 0.0, 1e-6);
}

/// A weak muscle bends as its force does at the arm of h/4: M = w c b h^2 / 8.
TEST(BeamTheory, HalfAMuscleBendsLikeItsForceOffTheAxis) {
    const BarShape bar = bar_of(0.1, 0.01, 0.01);
    const double weak = 1e-3 * bar.youngs_modulus_Pa, contraction = 0.01;
    const double moment = weak * contraction * bar.width_m * bar.height_m * bar.height_m / 8.0;
    const double linear = 0.5 * moment / bar.bending_stiffness_N_m2() * bar.length_m * bar.length_m;
    EXPECT_NEAR(deflection_by_half_muscle(bar, weak, contraction) / linear, 1.0, 2e-3);
    EXPECT_NEAR(deflection_by_half_muscle(bar, weak, -contraction), -deflection_by_half_muscle(bar, weak, contraction),
                1e-15);
    // A strong one also stiffens the bar, which bends less than in proportion.
    EXPECT_LT(deflection_by_half_muscle(bar, bar.youngs_modulus_Pa, contraction),
              1000.0 * deflection_by_half_muscle(bar, weak, contraction));
}

TEST(BenchFigures, RatesOfNothingAreZero) {
    BenchFigures figures;
    EXPECT_EQ(figures.ms_per_step(), 0.0);
    EXPECT_EQ(figures.real_time_factor(), 0.0);
    EXPECT_EQ(figures.us_per_dof_and_step(), 0.0);
    EXPECT_EQ(figures.share_of_limit(), 0.0);
    figures.steps = 200;
    figures.h_s = 0.01;
    figures.run_s = 4.0;
    figures.dofs = 50;
    figures.limit_ms = 5.0;
    EXPECT_DOUBLE_EQ(figures.ms_per_step(), 20.0);
    EXPECT_DOUBLE_EQ(figures.real_time_factor(), 0.5);
    EXPECT_DOUBLE_EQ(figures.us_per_dof_and_step(), 400.0);
    EXPECT_DOUBLE_EQ(figures.share_of_limit(), 0.25);
    BenchQuantity quantity{.name = "tip", .value = 9.0, .unit = "mm", .expected = 10.0};
    EXPECT_NEAR(*quantity.error(), -0.1, 1e-15);
    quantity.expected.reset();
    EXPECT_FALSE(quantity.error());
}

}  // namespace
}  // namespace myo::bench::beam_theory_test
