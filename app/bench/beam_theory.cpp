#include "bench/beam_theory.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/moduli.hpp"

namespace myo::bench {
namespace {

/// Shear coefficient of a rectangle without the influence of nu: Cowper's (1966) differs by less than 3 % of a term
/// that is below 0.2 % here.
constexpr double shear_share = 5.0 / 6.0;

/// Root of an increasing function by bisection between values of different sign; 60 halvings reach rounding.
template <class Function>
double root_between(double low, double high, const Function& f) {
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Moment of a section of this curvature [N m].
double moment_of(const BarShape& bar, const StretchLaw& law, double curvature_1_m) {
    constexpr int parts = 60;  // midpoint rule of second order: 1e-4 of the effects
    double moment = 0.0;
    for (int i = 0; i < parts; ++i) {
        const double z = ((i + 0.5) / parts - 0.5) * bar.height_m;
        moment += uniaxial_stress(bar, law, curvature_1_m * z) * z * bar.area_m2() / parts;
    }
    return moment;
}

/// Curvature of a section under a moment, by the secant method, starting from the linear solution.
double curvature_of(const BarShape& bar, const StretchLaw& law, double moment_N_m) {
    double before = 0.0, missing_before = -moment_N_m, now = moment_N_m / bar.bending_stiffness_N_m2();
    for (int i = 0; i < 30; ++i) {
        const double missing = moment_of(bar, law, now) - moment_N_m;
        if (std::abs(missing) < 1e-9 * std::abs(moment_N_m)) break;
        const double next = now - missing * (now - before) / (missing - missing_before);
        before = now, missing_before = missing, now = next;
    }
    return now;
}

}  // namespace

double BarShape::bending_stiffness_N_m2() const { return youngs_modulus_Pa * area_m2() * height_m * height_m / 12.0; }

double BarShape::shear_modulus_Pa() const { return 0.5 * youngs_modulus_Pa / (1.0 + poissons_ratio); }

double sag_under_gravity(const BarShape& bar, double gravity_m_s2) {
    const double load = bar.density_kg_m3 * gravity_m_s2 * bar.area_m2(), L2 = bar.length_m * bar.length_m;
    return load * L2 * L2 / (8.0 * bar.bending_stiffness_N_m2()) +
           load * L2 / (2.0 * shear_share * bar.shear_modulus_Pa() * bar.area_m2());
}

double first_bending_rad_s(const BarShape& bar) {
    // First root of cos(k) cosh(k) = -1 and the constant of its mode, Blevins 1979, table 8-1.
    constexpr double root = 1.87510407, sigma = 0.73409551;
    const double L2 = bar.length_m * bar.length_m;
    const double slender = root * root / L2 *
                           std::sqrt(bar.bending_stiffness_N_m2() / (bar.density_kg_m3 * bar.area_m2()));
    // L^2 times the integral of the squared slope over that of the squared deflection of the mode: rotary inertia. By
    // the symmetry between this mode and its second derivative also squared shear force over squared moment.
    constexpr double slopes = root * sigma * (2.0 + root * sigma);
    const double flatness = bar.height_m * bar.height_m / (12.0 * L2);
    const double shear = bar.youngs_modulus_Pa / (shear_share * bar.shear_modulus_Pa());
    return slender / std::sqrt(1.0 + flatness * slopes * (1.0 + shear));
}

double torsion_stiffness_N_m(const BarShape& bar) {
    constexpr double pi = std::numbers::pi;
    const double a = std::max(bar.width_m, bar.height_m), b = std::min(bar.width_m, bar.height_m);
    double series = 0.0;
    // Terms fall with the fifth power: ten of them suffice.
    for (int n = 1; n < 20; n += 2) series += std::tanh(0.5 * n * pi * a / b) / std::pow(n, 5);
    const double J = a * b * b * b / 3.0 * (1.0 - 192.0 / std::pow(pi, 5) * b / a * series);
    return bar.shear_modulus_Pa() * J / bar.length_m;
}

double uniaxial_stress(const BarShape& bar, const StretchLaw& law, double strain) {
    const material::Moduli moduli = material::moduli_from_young(bar.youngs_modulus_Pa, bar.poissons_ratio);
    const double stretch = 1.0 + strain;
    struct Stress {
        double along, across, isochoric;  // the last: I1 - 3
    };
    // Nominal stresses along and across the fibre for a given lateral stretch.
    const auto at = [&](double sideways) -> Stress {
        const double J = stretch * sideways * sideways, I1 = stretch * stretch + 2.0 * sideways * sideways;
        const double scale = std::pow(J, -2.0 / 3.0), isochoric = scale * I1 - 3.0;
        const double distortion = moduli.mu * (1.0 + 2.0 * law.yeoh_c2 * isochoric) * scale;
        const double pressure = 0.5 * moduli.kappa * (J - 1.0 / J) * J;
        return {(distortion * (stretch * stretch - I1 / 3.0) + pressure) / stretch,
                (distortion * (sideways * sideways - I1 / 3.0) + pressure) / sideways, isochoric};
    };
    // The lateral stretch lies between no contraction and more than that of constant volume.
    const double most = std::abs(strain),
                 sideways = root_between(1.0 - most, 1.0 + most, [&](double a) { return at(a).across; });
    const Stress stress = at(sideways);
    // On first loading the energy is the largest so far, on which the softening depends.
    const double energy = 0.5 * moduli.mu * stress.isochoric;
    return stress.along * (1.0 - law.damage_max * (1.0 - std::exp(-energy / law.energy_scale_J_m3)));
}

double end_load_deflection(const BarShape& bar, const StretchLaw& law, double force_N) {
    constexpr int parts = 100;
    double deflection = 0.0;
    for (int i = 0; i < parts; ++i) {
        // Principle of virtual work: curvature times the moment of a unit force at the tip.
        const double from_tip = (i + 0.5) / parts * bar.length_m;
        deflection += curvature_of(bar, law, force_N * from_tip) * from_tip * bar.length_m / parts;
    }
    return deflection;
}

double deflection_of_graded_bar(const BarShape& bar, double relative_change, double pull_N) {
    const double r = relative_change;
    // Beam with coupled stretching and bending: E is linear over the height, so EA and the coupling term are closed.
    const double strain = pull_N / (bar.youngs_modulus_Pa * bar.area_m2()) / (1.0 - r * r / 12.0);
    return 0.5 * r / bar.height_m * strain * bar.length_m * bar.length_m;
}

double deflection_by_half_muscle(const BarShape& bar, double stiffness_Pa, double contraction) {
    const double E = bar.youngs_modulus_Pa, w = stiffness_Pa, h = bar.height_m, pull = w * contraction;
    // Force and moment per width as functions of axial strain and curvature, positive if the upper side is shorter.
    Eigen::Matrix2d K;
    // The upper half has the modulus E + w; its first moment about the axis couples strain and curvature.
    K << E * h + w * h / 2.0, -w * h * h / 8.0, -w * h * h / 8.0, E * h * h * h / 12.0 + w * h * h * h / 24.0;
    const Eigen::Vector2d strains = K.inverse() * Eigen::Vector2d(-pull * h / 2.0, pull * h * h / 8.0);
    return 0.5 * strains(1) * bar.length_m * bar.length_m;
}

}  // namespace myo::bench
