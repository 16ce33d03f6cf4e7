#include "inverse/bounded_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <limits>
#include <random>

#include "support/dense.hpp"

namespace myo::inverse {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Problem {
    MatrixXd A;
    VectorXd r;
};

Problem random_problem(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Problem problem{MatrixXd(60, 5), VectorXd(60)};
    for (double& a : problem.A.reshaped()) a = normal(random);
    problem.A.col(1) = problem.A.col(0) + 0.05 * problem.A.col(1);  // nearly parallel
    problem.A.col(3) *= 1e6;
    for (double& value : problem.r) value = normal(random);
    return problem;
}

TEST(BoundedStep, IsLeastSquaresWithoutBounds) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Problem p = random_problem(seed);
        const VectorXd free = VectorXd::Constant(5, infinite);
        const VectorXd x = bounded_step(p.A, p.r, -free, free), exact = -test::least_squares(p.A, p.r);
        EXPECT_LT((p.A * (x - exact)).norm(), 1e-6 * p.r.norm());
    }
}

/// At the end the slope pushes outwards at a bound and is zero elsewhere (Karush, Kuhn and Tucker).
TEST(BoundedStep, EndsWhereNoAllowedStepHelps) {
    int at_bounds = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const Problem p = random_problem(seed);
        VectorXd lower = VectorXd::Constant(5, -0.02), upper = VectorXd::Constant(5, 0.03);
        lower(2) = 0.0;
        upper(4) = infinite;
        const VectorXd x = bounded_step(p.A, p.r, lower, upper), slope = p.A.transpose() * (p.r + p.A * x);
        for (int i = 0; i < 5; ++i) {
            EXPECT_GE(x(i), lower(i));
            EXPECT_LE(x(i), upper(i));
            const double tolerance = 1e-6 * p.A.col(i).norm() * p.r.norm();
            if (x(i) <= lower(i))
                EXPECT_GE(slope(i), -tolerance);
            else if (x(i) >= upper(i))
                EXPECT_LE(slope(i), tolerance);
            else
                EXPECT_NEAR(slope(i), 0.0, tolerance);
            at_bounds += x(i) <= lower(i) || x(i) >= upper(i);
        }
    }
    EXPECT_GT(at_bounds, 20);
}

TEST(BoundedStep, LeavesZeroColumnsAlone) {
    Problem p = random_problem(3);
    p.A.col(2).setZero();
    const VectorXd free = VectorXd::Constant(5, infinite);
    EXPECT_EQ(bounded_step(p.A, p.r, -free, free)(2), 0.0);
}

}  // namespace
}  // namespace myo::inverse
