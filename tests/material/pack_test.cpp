#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "material/catalogue.hpp"
#include "material/lanes.hpp"
#include "material/polar.hpp"
#include "support/deformations.hpp"

namespace myo::material {
namespace {

using Eigen::Matrix3d;

/// Every lane of a pack gives what the law gives for its point alone, whatever the neighbours are.
TEST(Packs, LanesAgreeWithSinglePoints) {
    const std::vector<Matrix3d> samples = test::sample_deformations();
    for (const MaterialPointer& law : material_catalogue())
        for (std::size_t first = 0; first < samples.size(); ++first)
            for (const bool with_hessian : {false, true}) {
                Matrix3<Pack> F;
                const auto sample = [&](int lane) {
                    return samples[(first + static_cast<std::size_t>(lane)) % samples.size()];
                };
                for (int lane = 0; lane < pack_width; ++lane) set_lane(F, lane, sample(lane));
                LawResponse<Pack> packed;
                law->respond(F, Pack(0.7), Pack(2.3), with_hessian, packed);
                for (int lane = 0; lane < pack_width; ++lane) {
                    const auto l = static_cast<std::size_t>(lane);
                    LawResponse<double> single;
                    law->respond(sample(lane), 0.7, 2.3, with_hessian, single);
                    const std::string what = law->id() + (with_hessian ? " with Hessian" : "");
                    EXPECT_NEAR(static_cast<double>(packed.distortion.value[l]), single.distortion.value,
                                1e-13 * (1.0 + std::abs(single.distortion.value)))
                        << what;
                    EXPECT_LT((lane_of(packed.distortion.gradient, lane) - single.distortion.gradient).norm(),
                              1e-12 * (1.0 + single.distortion.gradient.norm()))
                        << what;
                    if (with_hessian) {
                        EXPECT_LT((lane_of(packed.distortion.hessian, lane) - single.distortion.hessian).norm(),
                                  1e-11 * (1.0 + single.distortion.hessian.norm()))
                            << what;
                    }
                    if (!law->has_split()) continue;
                    EXPECT_NEAR(static_cast<double>(packed.volume.value[l]), single.volume.value,
                                1e-13 * (1.0 + std::abs(single.volume.value)))
                        << what;
                    EXPECT_LT((lane_of(packed.volume.gradient, lane) - single.volume.gradient).norm(),
                              1e-12 * (1.0 + single.volume.gradient.norm()))
                        << what;
                    const double theta = 0.05 * lane;
                    const ScalarFunctionOf<Pack> U = law->bulk(Pack(theta), Pack(2.3));
                    const ScalarFunction u = law->bulk(theta, 2.3);
                    EXPECT_NEAR(static_cast<double>(U.value[l]), u.value, 1e-13);
                    EXPECT_NEAR(static_cast<double>(U.first[l]), u.first, 1e-13);
                    EXPECT_NEAR(static_cast<double>(U.second[l]), u.second, 1e-13);
                }
            }
}

/// Both parts of a law at once.
TEST(Packs, WholeLawIsTheSumOfItsParts) {
    const std::vector<Matrix3d> samples = test::sample_deformations();
    for (const MaterialPointer& law : material_catalogue())
        for (const Matrix3d& sample : samples) {
            Matrix3<Pack> F, stress;
            for (int lane = 0; lane < pack_width; ++lane) set_lane(F, lane, sample);
            Pack energy;
            law->respond_whole(F, Pack(0.7), Pack(2.3), energy, stress);
            LawResponse<double> parts;
            law->respond(sample, 0.7, 2.3, false, parts);
            double value = parts.distortion.value;
            Matrix3d P = parts.distortion.gradient;
            if (law->has_split()) {
                const ScalarFunction U = law->bulk(parts.volume.value, 2.3);
                value += U.value;
                P += U.first * parts.volume.gradient;
            }
            EXPECT_NEAR(static_cast<double>(energy[0]), value, 1e-13 * (1.0 + std::abs(value))) << law->id();
            EXPECT_LT((lane_of(stress, 0) - P).norm(), 1e-12 * (1.0 + P.norm())) << law->id();
        }
}

TEST(Packs, LogarithmIsExactOverManyDecades) {
    for (double J = 1e-12; J < 1e12; J *= 3.7)
        EXPECT_NEAR(static_cast<double>(logarithm(Pack(J))[0]), std::log(J), 1e-15 * std::abs(std::log(J)) + 1e-15)
            << J;
    for (const double e : {-1e-3, -1e-9, 1e-12, 2e-6, 0.3})
        EXPECT_NEAR(static_cast<double>(logarithm(Pack(1.0 + e))[0]), std::log(1.0 + e), 1e-15 * std::abs(e)) << e;
    EXPECT_TRUE(std::isnan(static_cast<double>(logarithm(Pack(-1.0))[0])));
    EXPECT_EQ(static_cast<double>(logarithm(Pack(0.0))[0]), -std::numeric_limits<double>::infinity());
}

TEST(Packs, InverseCubeRootIsExactOverManyDecadesAndNotANumberBelowZero) {
    for (double J = 1e-12; J < 1e12; J *= 3.7)
        EXPECT_NEAR(static_cast<double>(inverse_cube_root(Pack(J))[0]) * std::cbrt(J), 1.0, 1e-14) << J;
    for (const double J : {0.0, -1e-3, -2.0}) {
        EXPECT_TRUE(std::isnan(static_cast<double>(inverse_cube_root(Pack(J))[0])));
        EXPECT_TRUE(std::isnan(inverse_cube_root(J)));
    }
}

/// The polar decomposition falls back on singular values lane by lane: near singular, singular and mirrored matrices.
TEST(Packs, PolarRotationAgreesWithSingularValuesAlsoForBadMatrices) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 200; ++trial) {
        Matrix3<Pack> F;
        for (int lane = 0; lane < pack_width; ++lane) {
            Matrix3d A;
            for (double& entry : A.reshaped()) entry = normal(random);
            if (lane % 3 == 0) A = Matrix3d::Identity() + 0.1 * A;
            if (lane % 5 == 4) A.col(2) *= 1e-6;
            set_lane(F, lane, A);
        }
        const Matrix3<Pack> R = polar_rotation(F);
        for (int lane = 0; lane < pack_width; ++lane) {
            const Matrix3d A = lane_of(F, lane), mine = lane_of(R, lane);
            EXPECT_LT((mine.transpose() * mine - Matrix3d::Identity()).norm(), 1e-12);
            EXPECT_NEAR(mine.determinant(), 1.0, 1e-12);
            const Matrix3d other = polar_rotation(A);
            EXPECT_NEAR((mine.transpose() * A).trace(), (other.transpose() * A).trace(), 1e-11 * A.norm());
        }
    }
}

}  // namespace
}  // namespace myo::material
