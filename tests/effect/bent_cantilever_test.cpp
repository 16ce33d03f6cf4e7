#include "effect/bent_cantilever.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>

#include "support/figures.hpp"

namespace myo::effect {
namespace {

/// Bisshopp & Drucker 1945: an end turned by t, p^2 = (1 + sin t) / 2, sin f = 1 / (sqrt 2 p), has root(load) = K(p) -
/// F(f, p), across = 1 - 2 (E(p) - E(f, p)) / root(load), along = sqrt(2 sin t / load).
TEST(BentCantilever, IsTheElasticaOfBisshoppAndDrucker) {
    double worst = 0.0;
    for (const double turn : {0.05, 0.3, 0.8, 1.2, 1.4}) {
        const double p = std::sqrt(0.5 * (1.0 + std::sin(turn))), f = std::asin(1.0 / (std::sqrt(2.0) * p));
        const double root = std::comp_ellint_1(p) - std::ellint_1(p, f), load = root * root;
        const double across = 1.0 - 2.0 * (std::comp_ellint_2(p) - std::ellint_2(p, f)) / root,
                     along = std::sqrt(2.0 * std::sin(turn) / load);
        const BentCantilever bent = bent_cantilever(across, 0.0);
        const BeamSection& end = bent.sections.back();
        for (const double error : {bent.load / load - 1.0, end.turn_rad / turn - 1.0, end.along - along,
                                   end.across - across, end.curvature}) {
            worst = std::max(worst, std::abs(error));
            EXPECT_NEAR(error, 0.0, 1e-7) << turn;
        }
    }
    test::record("worst_error", worst);
    // The table's first column: under P L^2 = E I the end moves by 0.30172 of the length.
    EXPECT_NEAR(bent_cantilever(0.30172, 0.0).load, 1.0, 2e-5);
}

/// Small loads bend it by s^2 (3 - s) / 6 and shear it by `shear` s.
TEST(BentCantilever, IsTimoshenkosForSmallLoads) {
    const double shear = 0.03, deflection = 1e-4;
    const BentCantilever bent = bent_cantilever(deflection, shear);
    EXPECT_NEAR(bent.load * (1.0 / 3.0 + shear) / deflection, 1.0, 1e-6);
    for (const double s : {0.1, 0.37, 0.8, 1.0}) {
        const BeamSection section = bent.at(s);
        EXPECT_NEAR(section.across / (bent.load * (s * s * (3.0 - s) / 6.0 + shear * s)), 1.0, 1e-6) << s;
        EXPECT_NEAR(section.turn_rad / (bent.load * (s - 0.5 * s * s)), 1.0, 1e-6) << s;
    }
}

/// Up to the most, and beyond it that.
TEST(BentCantilever, KeepsTheLengthOfItsAxis) {
    for (const double deflection : {0.01, 0.3, 0.7, 0.89}) {
        double length = 0.0;
        const BentCantilever bent = bent_cantilever(deflection, 0.0);
        for (int k = 0; k < 1000; ++k) {
            const BeamSection a = bent.at(1e-3 * k), b = bent.at(1e-3 * (k + 1));
            length += std::hypot(b.along - a.along, b.across - a.across);
        }
        EXPECT_NEAR(length, 1.0, 1e-5) << deflection;
        EXPECT_NEAR(bent.sections.back().across, deflection, 1e-12);
    }
    EXPECT_EQ(bent_cantilever(2.0, 0.01).load, bent_cantilever(bent_cantilever_policy.max_deflection, 0.01).load);
}

/// Fits go by differences of it: two widths agree as those of a smooth function do.
TEST(BentCantilever, IsSmoothInItsDeflection) {
    for (const double deflection : {0.02, 0.0999, 0.1, 0.35, 0.7}) {
        const auto slope = [&](double width) {
            const BeamSection over = bent_cantilever(deflection + width, 0.01).at(0.6),
                              under = bent_cantilever(deflection - width, 0.01).at(0.6);
            return Eigen::Vector3d(
                Eigen::Vector3d(over.turn_rad - under.turn_rad, over.along - under.along, over.across - under.across) /
                (2.0 * width));
        };
        const double differs = (slope(1e-4) - slope(1e-5)).norm() / slope(1e-5).norm();
        test::record("differs_" + format_number(deflection), differs);
        EXPECT_LT(differs, 1e-6) << deflection;
    }
}

}  // namespace
}  // namespace myo::effect
