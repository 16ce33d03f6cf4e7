#include <gtest/gtest.h>

#include <set>

#include "material/catalogue.hpp"
#include "material/moduli.hpp"
#include "support/deformations.hpp"

namespace myo::material {
namespace {

using Eigen::Matrix3d;

constexpr double mu = 0.7, kappa = 2.3;

/// W(F) of the whole law with its derivatives.
TensorFunction whole(const Material& law, const Matrix3d& F) {
    TensorFunction W = law.distortion(F, mu, kappa, true);
    const TensorFunction theta = law.volume_measure(F, true);
    const ScalarFunction U = law.bulk(theta.value, kappa);
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> g(theta.gradient.data());
    W.value += U.value;
    W.gradient += U.first * theta.gradient;
    W.hessian += U.second * g * g.transpose() + U.first * theta.hessian;
    return W;
}

double energy_of_strain(const TensorFunction& W, const Matrix3d& strain) {
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> e(strain.data());
    return e.dot(W.hessian * e);
}

TEST(MaterialInvariance, RotatingSpaceOrTheMaterialChangesNothing) {
    std::mt19937 random(3);
    for (const MaterialPointer& law : material_catalogue())
        for (const Matrix3d& F : test::sample_deformations()) {
            const Matrix3d Q = test::random_rotation(random);
            const TensorFunction W = whole(*law, F), spatial = whole(*law, Q * F), material = whole(*law, F * Q);
            const double scale = 1e-12 * (1.0 + std::abs(W.value));
            EXPECT_NEAR(spatial.value, W.value, scale) << law->id();
            EXPECT_NEAR(material.value, W.value, scale) << law->id();
            EXPECT_LT((spatial.gradient - Q * W.gradient).norm(), 1e-12 * (1.0 + W.gradient.norm())) << law->id();
            EXPECT_LT((material.gradient - W.gradient * Q).norm(), 1e-12 * (1.0 + W.gradient.norm())) << law->id();
            // The Kirchhoff stress P F' of an objective energy is symmetric: no internal moments.
            const Matrix3d tau = W.gradient * F.transpose();
            EXPECT_LT((tau - tau.transpose()).norm(), 1e-12 * (1.0 + tau.norm())) << law->id();
        }
}

TEST(MaterialInvariance, RestStateAndItsRotationsAreFreeOfStressAndEnergy) {
    std::mt19937 random(5);
    for (const MaterialPointer& law : material_catalogue())
        for (int k = 0; k < 5; ++k) {
            const Matrix3d Q = k == 0 ? Matrix3d::Identity() : test::random_rotation(random);
            const TensorFunction W = whole(*law, Q);
            EXPECT_NEAR(W.value, 0.0, 1e-14) << law->id();
            EXPECT_LT(W.gradient.norm(), 1e-14) << law->id();
        }
}

TEST(MaterialInvariance, EnergyIsPositiveAwayFromRest) {
    for (const MaterialPointer& law : material_catalogue())
        for (const Matrix3d& F : test::sample_deformations()) EXPECT_GT(whole(*law, F).value, 0.0) << law->id();
}

/// Small strain: e:H:e = 2 mu |dev e|^2 + kappa tr(e)^2, and rotations are free.
TEST(MaterialInvariance, SmallStrainModuliAreMuAndKappa) {
    Matrix3d shear = Matrix3d::Zero(), spin = Matrix3d::Zero(), general;
    shear(0, 1) = shear(1, 0) = 0.5;
    spin(0, 1) = 1.0;
    spin(1, 0) = -1.0;
    general << 0.3, -0.2, 0.5, -0.2, -0.7, 0.1, 0.5, 0.1, 0.9;
    for (const MaterialPointer& law : material_catalogue()) {
        const TensorFunction W = whole(*law, Matrix3d::Identity());
        // The published form has lambda/6 tr(e)^2 for Lamé's lambda/2 tr(e)^2: lambda counts a third.
        const double lambda = kappa - 2.0 / 3.0 * mu;
        const double bulk = law->id() == "projective_corotational" ? lambda / 3.0 + 2.0 / 3.0 * mu : kappa;
        EXPECT_NEAR(energy_of_strain(W, shear), mu, 1e-12) << law->id();
        EXPECT_NEAR(energy_of_strain(W, spin), 0.0, 1e-12) << law->id();
        EXPECT_NEAR(energy_of_strain(W, Matrix3d::Identity()), 9.0 * bulk, 1e-12) << law->id();
        const double trace = general.trace();
        const Matrix3d deviator = general - trace / 3.0 * Matrix3d::Identity();
        EXPECT_NEAR(energy_of_strain(W, general), 2.0 * mu * deviator.squaredNorm() + bulk * trace * trace, 1e-12)
            << law->id();
    }
}

TEST(MaterialInvariance, AnInvertedCellIsToldApart) {
    Matrix3d inverted = Matrix3d::Identity();
    inverted(0, 0) = -0.5;
    EXPECT_FALSE(std::isfinite(whole(*neo_hookean(), inverted).value));
    EXPECT_FALSE(whole(*neo_hookean(), inverted).gradient.allFinite());
}

/// Uniaxial tension of an incompressible neo-Hookean bar: P = mu (s - 1/s^2), as kappa grows.
TEST(MaterialInvariance, NeoHookeanTensionApproachesTheClosedForm) {
    const double s = 1.8, lateral = 1.0 / std::sqrt(s);
    const Matrix3d F = Eigen::Vector3d(s, lateral, lateral).asDiagonal();
    const Matrix3d P = neo_hookean()->distortion(F, mu, kappa, false).gradient;
    // The pressure that keeps the sides free: P_yy + p cof_yy = 0.
    const double pressure = -P(1, 1) / (s * lateral);
    EXPECT_NEAR(P(0, 0) + pressure * lateral * lateral, mu * (s - 1.0 / (s * s)), 1e-13);
}

TEST(MaterialCatalogue, IdsAreUniqueAndFoundAgain) {
    std::set<std::string> ids;
    for (const MaterialPointer& law : material_catalogue()) {
        EXPECT_TRUE(ids.insert(law->id()).second);
        EXPECT_EQ(find_material(law->id()), law);
        EXPECT_FALSE(law->formula().empty());
    }
    EXPECT_EQ(find_material("no such law"), nullptr);
    EXPECT_EQ(material_ids().size(), ids.size());
}

TEST(Moduli, FollowFromYoungAndPoisson) {
    const Moduli m = moduli_from_young(263824.0, 0.499);
    EXPECT_NEAR(9.0 * m.kappa * m.mu / (3.0 * m.kappa + m.mu), 263824.0, 1e-6);
    EXPECT_NEAR((3.0 * m.kappa - 2.0 * m.mu) / (2.0 * (3.0 * m.kappa + m.mu)), 0.499, 1e-12);
}

}  // namespace
}  // namespace myo::material
