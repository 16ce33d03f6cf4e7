#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "material/catalogue.hpp"
#include "material/lanes.hpp"
#include "material/polar.hpp"
#include "material/strain_stiffening.hpp"
#include "material/stress_softening.hpp"
#include "material/tensors.hpp"
#include "support/deformations.hpp"
#include "support/differences.hpp"

// Cofactors, rotations and singular values of any matrix; stiffening of any law, softening by its energy.

namespace myo::material::tensor_parts_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Regular, singular and mirrored matrices, and none at all.
std::vector<Matrix3d> matrices() {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    std::vector<Matrix3d> all{Matrix3d::Zero(), Matrix3d::Identity(), -Matrix3d::Identity()};
    for (int i = 0; i < 20; ++i) {
        Matrix3d A = Matrix3d::NullaryExpr([&] { return normal(random); });
        if (i % 4 == 1) A.col(2) = 2.0 * A.col(0) - A.col(1);
        if (i % 4 == 2) A = Vector3d(A.col(0)) * Vector3d(A.col(1)).transpose();
        if (i % 4 == 3) A *= 1e-8;
        all.push_back(A);
    }
    return all;
}

TEST(Cofactors, AreThoseOfLinearAlgebraForSingularMatricesToo) {
    const std::vector<Matrix3d> all = matrices();
    for (const Matrix3d& A : all) {
        const double size = A.norm();
        EXPECT_LT((cofactor(A) * A.transpose() - A.determinant() * Matrix3d::Identity()).norm(),
                  1e-13 * size * size * size + 1e-300);
        // Areas: cof A (a x b) = A a x A b.
        const Vector3d a(0.3, -1.0, 0.5), b(1.0, 0.2, -0.7);
        EXPECT_LT((cofactor(A) * a.cross(b) - (A * a).cross(A * b)).norm(), 1e-13 * size * size + 1e-300);
        for (const Matrix3d& B : all)
            EXPECT_LT((cofactor(Matrix3d(A * B)) - cofactor(A) * cofactor(B)).norm(),
                      1e-13 * size * size * B.squaredNorm() + 1e-300);
        EXPECT_NEAR(double_dot(A, all[5]), (A.transpose() * all[5]).trace(), 1e-14 * size * all[5].norm());
    }
}

/// Every entry of a tangent once, with the indices that vec() of Eigen gives them.
TEST(TangentEntries, CountInTheOrderOfColumns) {
    std::set<std::pair<int, int>> seen;
    for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
        EXPECT_TRUE(seen.insert({row, column}).second);
        Matrix3d E = Matrix3d::Zero(), D = Matrix3d::Zero();
        E(i, j) = 1.0;
        D(k, l) = 1.0;
        EXPECT_EQ(E.reshaped()(row), 1.0);
        EXPECT_EQ(D.reshaped()(column), 1.0);
    });
    EXPECT_EQ(seen.size(), 81u);
}

TEST(SignedValues, RestoreTheMatrixByTwoRotations) {
    for (const Matrix3d& A : matrices()) {
        const SignedSvd svd = signed_svd(A);
        EXPECT_LT((svd.U * svd.sigma.asDiagonal() * svd.V.transpose() - A).norm(), 1e-13 * (A.norm() + 1e-8));
        for (const Matrix3d& Q : {svd.U, svd.V}) {
            EXPECT_LT((Q.transpose() * Q - Matrix3d::Identity()).norm(), 1e-13);
            EXPECT_NEAR(Q.determinant(), 1.0, 1e-13);
        }
        EXPECT_GE(svd.sigma(0), svd.sigma(1));
        EXPECT_GE(svd.sigma(1), std::abs(svd.sigma(2))) << "only the smallest may be negative";
        EXPECT_GE(svd.sigma(1), 0.0);
        EXPECT_NEAR(svd.sigma.prod(), A.determinant(), 1e-13 * std::pow(A.norm(), 3) + 1e-300);
    }
}

/// No rotation is nearer; and a turn of space turns it along.
TEST(PolarRotation, IsTheNearestOne) {
    std::mt19937 random(9);
    for (const Matrix3d& A : matrices()) {
        const Matrix3d R = polar_rotation(A);
        EXPECT_NEAR(R.determinant(), 1.0, 1e-13);
        for (int i = 0; i < 50; ++i) {
            const Matrix3d Q = test::random_rotation(random);
            EXPECT_LE((A - R).norm(), (A - Q).norm() + 1e-13);
            if (A.determinant() > 0.01) {
                EXPECT_LT((polar_rotation(Matrix3d(Q * A)) - Q * R).norm(), 1e-11);
            }
        }
    }
    EXPECT_LT((polar_rotation(Matrix3d(3.0 * Matrix3d::Identity())) - Matrix3d::Identity()).norm(), 1e-15);
}

/// A spin of F spins R at the same rate; a stretch along with F leaves it where it is.
TEST(PolarRotation, HasTheDerivativesOfSpinAndStretch) {
    for (const Matrix3d& F : test::sample_deformations()) {
        const Matrix3d R = polar_rotation(F), S = R.transpose() * F;
        const Matrix9d dR = polar_rotation_derivative(F, R);
        const auto along = [&](const Matrix3d& dF) { return Matrix3d((dR * dF.reshaped()).reshaped(3, 3)); };
        Matrix3d W;
        W << 0.0, -0.3, 0.7, 0.3, 0.0, -0.2, -0.7, 0.2, 0.0;
        EXPECT_LT((along(W * F) - W * R).norm(), 1e-12 * F.norm());
        EXPECT_LT(along(F).norm(), 1e-12 * F.norm()) << "size alone";
        EXPECT_LT(along(R * S * S).norm(), 1e-12 * F.squaredNorm()) << "a stretch in the same directions";
    }
}

TEST(Lanes, HoldTheirNumbersApart) {
    Matrix3<Pack> packs = Matrix3<Pack>::Constant(Pack(-1.0));
    for (int lane = 0; lane < pack_width; ++lane) {
        const Matrix3d values = (10.0 * lane + Eigen::Matrix3d::Identity().array() * lane).matrix();
        set_lane(packs, lane, values);
        EXPECT_EQ(lane_of(packs, lane), values);
        if (lane + 1 < pack_width) {
            EXPECT_EQ(lane_of(packs, lane + 1), Matrix3d(Matrix3d::Constant(-1.0)));
        }
    }
}

TEST(StrainStiffening, AddsTheSquareOfTheEnergyToEveryLaw) {
    for (const MaterialPointer& base : material_catalogue())
        for (const double c2 : {-0.1, 0.0, 0.7}) {
            const MaterialPointer law = strain_stiffening(base, c2);
            EXPECT_EQ(law->id(), base->id()) << "a project file names the law without the effect";
            EXPECT_EQ(law->has_split(), base->has_split());
            EXPECT_EQ(law->bulk(0.2, 3.0).value, base->bulk(0.2, 3.0).value);
            for (const Matrix3d& F : test::sample_deformations()) {
                const double G = 0.8, K = 2.0;
                const TensorFunction W = law->distortion(F, G, K, true), plain = base->distortion(F, G, K, true),
                                     unit = base->distortion(F, 1.0, 0.0, true);
                EXPECT_NEAR(W.value, plain.value + 2.0 * G * c2 * unit.value * unit.value, 1e-12 * (1.0 + plain.value));
                if (c2 == 0.0) {
                    EXPECT_EQ(W.gradient, plain.gradient);
                    EXPECT_EQ(W.hessian, plain.hessian);
                    continue;
                }
                const auto gradient = [&](const VectorXd& v) {
                    return VectorXd(law->distortion(Matrix3d(v.reshaped(3, 3)), G, K, false).gradient.reshaped());
                };
                const auto value = [&](const VectorXd& v) {
                    return VectorXd::Constant(1, law->distortion(Matrix3d(v.reshaped(3, 3)), G, K, false).value);
                };
                const VectorXd at = F.reshaped();
                test::expect_derivative(VectorXd(W.gradient.reshaped()).transpose(),
                                        test::central_differences(value, at, 1e-5), 1e-6, base->id() + " gradient");
                test::expect_equal_to_differences(W.hessian, test::central_differences(gradient, at, 1e-5), 1e-6,
                                                  base->id() + " Hessian");
            }
        }
}

/// Points and lanes agree, and the law stays linear in its moduli.
TEST(StrainStiffening, IsLinearInTheModuliAndTheSameInLanes) {
    const MaterialPointer law = strain_stiffening(neo_hookean(), 0.6);
    for (const Matrix3d& F : test::sample_deformations()) {
        const TensorFunction once = law->distortion(F, 0.5, 1.0, false), thrice = law->distortion(F, 1.5, 9.0, false);
        EXPECT_NEAR(thrice.value, 3.0 * once.value, 1e-12 * (1.0 + thrice.value));
        EXPECT_EQ(law->distortion(F, 0.0, 1.0, false).value, 0.0) << "a derivative by the bulk modulus alone";
        Matrix3<Pack> lanes, stress;
        for (int lane = 0; lane < pack_width; ++lane) set_lane(lanes, lane, F);
        Pack energy;
        law->respond_whole(lanes, Pack(0.5), Pack(1.0), energy, stress);
        const ScalarFunction U = law->bulk(F.determinant() - 1.0, 1.0);
        EXPECT_NEAR(static_cast<double>(energy[0]), once.value + U.value, 1e-12 * (1.0 + once.value + U.value));
    }
    EXPECT_NE(law->formula().find("0.6 (I1 - 3)^2"), std::string::npos);
}

TEST(StressSoftening, FallsFromOneToTheRestAndHasItsSlope) {
    const StressSoftening softening{0.6, 50.0};
    EXPECT_EQ(softening.factor(0.0), 1.0);
    EXPECT_NEAR(softening.factor(50.0), 1.0 - 0.6 * (1.0 - std::exp(-1.0)), 1e-15);
    EXPECT_NEAR(softening.factor(1e6), 0.4, 1e-15);
    EXPECT_NEAR((1.0 - softening.factor(1e-9)) / 1e-9, 0.6 / 50.0, 1e-6) << "small energies are not lost";
    double before = 1.0;
    for (const double energy : {1.0, 10.0, 60.0, 200.0}) {
        EXPECT_LT(softening.factor(energy), before);
        before = softening.factor(energy);
        const double h = 1e-4, difference = (softening.factor(energy + h) - softening.factor(energy - h)) / (2.0 * h);
        EXPECT_NEAR(softening.slope(energy), difference, 1e-9);
        EXPECT_LT(softening.slope(energy), 0.0);
    }
    EXPECT_EQ(StressSoftening().factor(7.0), 1.0) << "no damage is declared";
}

TEST(MaterialCatalogue, FindsLawsWithTheirValues) {
    std::size_t parameters = 0;
    for (const MaterialPointer& law : material_catalogue()) {
        parameters += law->parameters().size();
        EXPECT_FALSE(law->label().empty());
        EXPECT_FALSE(law->explanation().empty());
        if (law->parameters().empty()) continue;
        std::vector<double> upper;
        for (const LawParameter& parameter : law->parameters()) upper.push_back(parameter.upper);
        const MaterialPointer found = find_material(law->id(), upper);
        EXPECT_EQ(found->values(), upper);
        EXPECT_EQ(found->id(), law->id());
        EXPECT_NE(law->values(), upper) << "the entry of the catalogue stays as it is";
    }
    EXPECT_EQ(all_law_parameters().size(), parameters);
}

}  // namespace
}  // namespace myo::material::tensor_parts_test
