#include <gtest/gtest.h>

#include <cmath>

#include "mesh/quadrature.hpp"

namespace myo::mesh {
namespace {

double monomial(const Eigen::Vector3d& x, int i, int j, int k) {
    return std::pow(x(0), i) * std::pow(x(1), j) * std::pow(x(2), k);
}

double integral(const std::vector<QuadraturePoint>& rule, int i, int j, int k) {
    double sum = 0.0;
    for (const QuadraturePoint& point : rule) sum += point.weight * monomial(point.xi, i, j, k);
    return sum;
}

/// i! j! k! / (i + j + k + 3)! over the reference tetrahedron.
double tet_integral(int i, int j, int k) {
    return std::tgamma(i + 1.0) * std::tgamma(j + 1.0) * std::tgamma(k + 1.0) / std::tgamma(i + j + k + 4.0);
}

double line_integral(int i) { return i % 2 == 1 ? 0.0 : 2.0 / (i + 1.0); }

int exact_degree(const std::vector<QuadraturePoint>& rule, int up_to) {
    for (int degree = 0; degree <= up_to; ++degree)
        for (int i = 0; i <= degree; ++i)
            for (int j = 0; i + j <= degree; ++j)
                if (std::abs(integral(rule, i, j, degree - i - j) - tet_integral(i, j, degree - i - j)) > 1e-13)
                    return degree - 1;
    return up_to;
}

TEST(Quadrature, GaussIsExactToTwiceThePointsLessOnePerAxisAndNoFurther) {
    for (int n = 1; n <= 3; ++n) {
        const auto rule = hex_gauss(n);
        const int p = 2 * n - 1;
        for (int i = 0; i <= p; ++i)
            for (int j = 0; j <= p; ++j)
                for (int k = 0; k <= p; ++k)
                    EXPECT_NEAR(integral(rule, i, j, k), line_integral(i) * line_integral(j) * line_integral(k), 1e-14)
                        << n;
        EXPECT_GT(std::abs(integral(rule, p + 1, 0, 0) - 4.0 * line_integral(p + 1)), 1e-3);
    }
}

TEST(Quadrature, TetrahedronRulesHaveTheStatedDegree) {
    EXPECT_EQ(exact_degree(tet_centroid(), 6), 1);
    EXPECT_EQ(exact_degree(tet_degree2(), 6), 2);
    EXPECT_EQ(exact_degree(tet_five_points(), 6), 3);
    EXPECT_EQ(exact_degree(tet_degree3(), 6), 3);
    EXPECT_EQ(exact_degree(tet_degree5(), 8), 5);
}

/// A negative weight could make the energy of a part of a cell negative.
TEST(Quadrature, TenPointsLieWithinTheTetrahedronWithPositiveWeights) {
    EXPECT_EQ(tet_degree3().size(), 10u);
    for (const QuadraturePoint& point : tet_degree3()) {
        EXPECT_GT(point.weight, 0.0);
        EXPECT_GT(point.xi.minCoeff(), 0.0);
        EXPECT_LT(point.xi.sum(), 1.0);
    }
}

/// Fourth powers of linear functions, beyond the rule's degree, are what it is used for. Of the functions with mean
/// zero those with two different values at the corners bound the error.
TEST(Quadrature, TenPointsSeeFourthPowersOfLinearFunctions) {
    const Eigen::Vector4d functions[] = {{3.0, -1.0, -1.0, -1.0}, {1.0, 1.0, -1.0, -1.0}};
    for (const Eigen::Vector4d& at_corners : functions) {
        const auto fourth = [&](const std::vector<QuadraturePoint>& rule) {
            double sum = 0.0;
            for (const QuadraturePoint& point : rule) {
                const double value = at_corners(0) * (1.0 - point.xi.sum()) + at_corners.tail<3>().dot(point.xi);
                sum += point.weight * std::pow(value, 4);
            }
            return sum;
        };
        const double exact = fourth(tet_degree5());
        EXPECT_NEAR(fourth(tet_degree3()), exact, 0.03 * exact);
        EXPECT_LT(fourth(tet_degree2()), 0.81 * exact);
    }
}

}  // namespace
}  // namespace myo::mesh
