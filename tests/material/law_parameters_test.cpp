#include <gtest/gtest.h>

#include <set>

#include "material/catalogue.hpp"
#include "support/deformations.hpp"

namespace myo::material {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double shear_modulus = 0.7;

/// Cauchy stress along the pull of an incompressible bar in uniaxial tension: sigma = lambda dW/dlambda along F =
/// diag(lambda, 1/sqrt(lambda), 1/sqrt(lambda)).
double uniaxial_stress(const Material& law, double stretch) {
    const double across = 1.0 / std::sqrt(stretch);
    const Matrix3d F = Vector3d(stretch, across, across).asDiagonal();
    const Matrix3d P = law.distortion(F, shear_modulus, 0.0, false).gradient;
    return stretch * P(0, 0) - across * P(1, 1);
}

TEST(LawParameters, HaveNamesOfTheirOwnAndUsualValuesWithinTheirBounds) {
    std::set<std::string> names;
    for (const MaterialPointer& law : material_catalogue()) {
        EXPECT_EQ(law->values().size(), law->parameters().size()) << law->id();
        for (std::size_t k = 0; k < law->parameters().size(); ++k) {
            const LawParameter p = law->parameters()[k];
            EXPECT_TRUE(names.insert(p.name).second) << p.name;
            EXPECT_LT(p.lower, p.upper) << p.name;
            EXPECT_GE(p.usual, p.lower) << p.name;
            EXPECT_LE(p.usual, p.upper) << p.name;
            EXPECT_EQ(law->values()[k], p.usual) << p.name;
        }
    }
    EXPECT_GE(names.size(), 2u);
}

/// The derivative of the law is that of its energy, its stress and its tangent.
TEST(LawParameters, DerivativesAgreeWithDifferences) {
    int checked = 0;
    for (const MaterialPointer& law : material_catalogue())
        for (std::size_t k = 0; k < law->parameters().size(); ++k)
            for (const Matrix3d& F : test::sample_deformations()) {
                const double step = 1e-4 * law->parameters()[k].scale;
                std::vector<double> more = law->values(), less = more;
                more[k] += step;
                less[k] -= step;
                const TensorFunction over = law->with_values(more)->distortion(F, shear_modulus, 0.0, true),
                                     under = law->with_values(less)->distortion(F, shear_modulus, 0.0, true);
                const MaterialPointer derivative = law->by_parameter(k);
                const TensorFunction d = derivative->distortion(F, shear_modulus, 0.0, true);
                const double scale = 1.0 / (2.0 * step), tolerance = 1e-6;
                EXPECT_NEAR(d.value, scale * (over.value - under.value), tolerance * (std::abs(d.value) + 1e-3))
                    << law->id();
                EXPECT_LT((d.gradient - scale * (over.gradient - under.gradient)).norm(),
                          tolerance * (d.gradient.norm() + 1e-3))
                    << law->id();
                EXPECT_LT((d.hessian - scale * (over.hessian - under.hessian)).norm(),
                          tolerance * (d.hessian.norm() + 1e-3))
                    << law->id();
                EXPECT_EQ(derivative->has_split(), law->has_split());
                EXPECT_EQ(derivative->bulk(0.2, 1.0).value, 0.0) << "the volumetric part has no such parameter";
                ++checked;
            }
    EXPECT_GE(checked, 2);
}

/// sigma = mu (lambda^2 - 1/lambda) J / (J - (I1 - 3)).
/// Source: Gent 1996, eq. 5.
TEST(Gent, MeetsTheClosedFormInTension) {
    const double limit = 20.0;
    const MaterialPointer law = find_material("gent", {limit});
    for (const double stretch : {0.5, 0.9, 1.2, 2.0, 4.0}) {
        const double I1 = stretch * stretch + 2.0 / stretch;
        const double expected = shear_modulus * (stretch * stretch - 1.0 / stretch) * limit / (limit - (I1 - 3.0));
        EXPECT_NEAR(uniaxial_stress(*law, stretch), expected, 1e-12 * (1.0 + std::abs(expected))) << stretch;
    }
    // Beyond the limit there is no energy and no stress: neither a line search nor a residual accepts it.
    EXPECT_TRUE(std::isnan(uniaxial_stress(*law, 5.0)));
    EXPECT_TRUE(std::isnan(law->distortion(Vector3d(5.0, 0.4, 0.5).asDiagonal(), shear_modulus, 0.0, false).value));
}

/// With a far limit the law is the neo-Hookean one; the difference falls with its inverse.
TEST(Gent, ApproachesTheNeoHookeanLaw) {
    const double stretch = 1.8, soft = uniaxial_stress(*find_material("neo_hookean"), stretch);
    const double far = uniaxial_stress(*find_material("gent", {1e3}), stretch) - soft,
                 farther = uniaxial_stress(*find_material("gent", {1e4}), stretch) - soft;
    EXPECT_GT(far, 0.0);
    EXPECT_NEAR(far / farther, 10.0, 0.05);
}

/// sigma = mu (lambda^2 - 1/lambda) ((1 - s) + s / lambda).
/// Source: Rivlin 1948; Bonet & Wood 2008, sec. 6.5.
TEST(MooneyRivlin, MeetsTheClosedFormInTension) {
    for (const double s : {0.0, 0.3, 1.0})
        for (const double stretch : {0.5, 0.9, 1.2, 2.0, 4.0}) {
            const double expected = shear_modulus * (stretch * stretch - 1.0 / stretch) * ((1.0 - s) + s / stretch);
            EXPECT_NEAR(uniaxial_stress(*find_material("mooney_rivlin", {s}), stretch), expected,
                        1e-12 * (1.0 + std::abs(expected)))
                << s << " " << stretch;
        }
}

/// In simple shear both invariants are equal: the share has no influence.
TEST(MooneyRivlin, ShearsLikeTheNeoHookeanLaw) {
    Matrix3d F = Matrix3d::Identity();
    F(0, 1) = 0.8;
    const double plain = find_material("neo_hookean")->distortion(F, shear_modulus, 0.0, false).gradient(0, 1);
    EXPECT_NEAR(find_material("mooney_rivlin", {0.6})->distortion(F, shear_modulus, 0.0, false).gradient(0, 1), plain,
                1e-14);
}

}  // namespace
}  // namespace myo::material
