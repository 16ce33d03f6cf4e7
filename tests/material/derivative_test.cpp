#include <gtest/gtest.h>

#include "material/catalogue.hpp"
#include "material/polar.hpp"
#include "support/deformations.hpp"
#include "support/differences.hpp"

namespace myo::material {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::VectorXd;

constexpr double some_mu = 0.7, some_kappa = 2.3;
constexpr double eps = 1e-5;  // rounding 1e-11, truncation 1e-10 times the third derivative

VectorXd vec(const Matrix3d& F) { return Map<const VectorXd>(F.data(), 9); }
Matrix3d mat(const VectorXd& v) { return Map<const Matrix3d>(v.data()); }

/// Checks value, gradient and Hessian of a function of F.
template <class Function>
void check(const Function& f, const Matrix3d& F, const std::string& what) {
    const TensorFunction W = f(F, true);
    const auto value = [&](const VectorXd& v) { return VectorXd::Constant(1, f(mat(v), false).value); };
    const auto gradient = [&](const VectorXd& v) { return vec(f(mat(v), false).gradient); };
    test::expect_derivative(vec(W.gradient).transpose(), test::central_differences(value, vec(F), eps), 1e-7,
                            what + " gradient");
    // A quadratic function's difference may meet its Hessian in every bit.
    test::expect_equal_to_differences(W.hessian, test::central_differences(gradient, vec(F), eps), 1e-7,
                                      what + " Hessian");
    EXPECT_GT(W.hessian.norm(), 0.0) << what;
    EXPECT_LT((W.hessian - W.hessian.transpose()).norm(), 1e-12 * W.hessian.norm()) << what;
    EXPECT_EQ(f(F, false).gradient, W.gradient) << what << ": asking for the Hessian must not change the gradient";
}

TEST(MaterialDerivatives, DistortionAgreesWithDifferences) {
    for (const MaterialPointer& law : material_catalogue())
        for (const Matrix3d& F : test::sample_deformations())
            check([&](const Matrix3d& X, bool h) { return law->distortion(X, some_mu, some_kappa, h); }, F,
                  law->id() + " distortion");
}

TEST(MaterialDerivatives, VolumeMeasureAgreesWithDifferences) {
    int measured = 0;
    for (const MaterialPointer& law : material_catalogue()) {
        if (law->volume_measure(2.0 * Matrix3d::Identity(), false).value == 0.0) continue;  // a law without a split
        ++measured;
        for (const Matrix3d& F : test::sample_deformations())
            check([&](const Matrix3d& X, bool h) { return law->volume_measure(X, h); }, F,
                  law->id() + " volume measure");
    }
    EXPECT_GE(measured, 2);
}

TEST(MaterialDerivatives, BulkEnergyAgreesWithDifferences) {
    for (const MaterialPointer& law : material_catalogue()) {
        if (law->volume_measure(2.0 * Matrix3d::Identity(), false).value == 0.0) {
            EXPECT_EQ(law->bulk(0.3, some_kappa).value, 0.0) << law->id();
            continue;
        }
        // All points at once: a single second derivative may meet its difference in every bit by chance.
        const VectorXd thetas = (VectorXd(6) << -0.6, -0.2, -0.01, 0.03, 0.5, 2.0).finished();
        VectorXd first(6), second(6), d_value(6), d_first(6);
        for (int i = 0; i < 6; ++i) {
            const ScalarFunction U = law->bulk(thetas(i), some_kappa);
            const ScalarFunction plus = law->bulk(thetas(i) + eps, some_kappa),
                                 minus = law->bulk(thetas(i) - eps, some_kappa);
            first(i) = U.first;
            second(i) = U.second;
            d_value(i) = (plus.value - minus.value) / (2.0 * eps);
            d_first(i) = (plus.first - minus.first) / (2.0 * eps);
        }
        test::expect_derivative(first, d_value, 1e-7, law->id() + " U'");
        test::expect_derivative(second, d_first, 1e-7, law->id() + " U''");
    }
}

TEST(MaterialDerivatives, PolarRotationAgreesWithDifferences) {
    for (const Matrix3d& F : test::sample_deformations()) {
        const Matrix3d R = polar_rotation(F);
        const auto rotation = [](const VectorXd& v) { return vec(polar_rotation(mat(v))); };
        test::expect_derivative(polar_rotation_derivative(F, R), test::central_differences(rotation, vec(F), eps), 1e-7,
                                "dR/dF");
    }
}

/// The derivative with respect to a parameter is taken as the energy at the derivative of the moduli.
TEST(MaterialDerivatives, EnergyIsLinearInTheModuli) {
    for (const MaterialPointer& law : material_catalogue())
        for (const Matrix3d& F : test::sample_deformations()) {
            const TensorFunction A = law->distortion(F, 0.3, 1.1, true), B = law->distortion(F, -0.2, 5.0, true);
            const TensorFunction C = law->distortion(F, 2.0 * 0.3 - 3.0 * 0.2, 2.0 * 1.1 + 3.0 * 5.0, true);
            const double scale = std::abs(A.value) + std::abs(B.value) + 1.0;
            EXPECT_NEAR(C.value, 2.0 * A.value + 3.0 * B.value, 1e-12 * scale) << law->id();
            EXPECT_LT((C.gradient - 2.0 * A.gradient - 3.0 * B.gradient).norm(),
                      1e-12 * (1.0 + A.gradient.norm() + B.gradient.norm()));
            EXPECT_LT((C.hessian - 2.0 * A.hessian - 3.0 * B.hessian).norm(),
                      1e-12 * (1.0 + A.hessian.norm() + B.hessian.norm()));
            const ScalarFunction U = law->bulk(0.2, 1.0), V = law->bulk(0.2, -4.0);
            EXPECT_NEAR(V.value, -4.0 * U.value, 1e-14);
            EXPECT_NEAR(V.first, -4.0 * U.first, 1e-14);
            EXPECT_NEAR(V.second, -4.0 * U.second, 1e-14);
        }
}

}  // namespace
}  // namespace myo::material
