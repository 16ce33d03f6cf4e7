#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solver/gmres.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A matrix far from symmetric: couplings to one side only are as large as the diagonal.
MatrixXd one_sided(Eigen::Index n) {
    MatrixXd A = MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        A(i, i) = 1.0 + static_cast<double>(i);
        if (i + 1 < n) A(i, i + 1) = 0.8 * A(i, i);
        if (i > 4) A(i, i - 5) = -0.3 * A(i, i);
    }
    return A;
}

TEST(Gmres, SolvesAMatrixWithoutSymmetry) {
    const MatrixXd A = one_sided(120);
    const VectorXd x = VectorXd::LinSpaced(120, -1.0, 2.0), b = A * x;
    const auto product = [&](const VectorXd& v) { return VectorXd(A * v); };
    const auto by_diagonal = [&](const VectorXd& v) { return VectorXd(v.cwiseQuotient(A.diagonal())); };
    const GmresReport report = gmres(product, by_diagonal, b, 1e-12, 500);
    EXPECT_TRUE(report.converged);
    EXPECT_LT((report.solution - x).norm(), 1e-9 * x.norm());
    // From the solution itself there is unchanged to do.
    EXPECT_EQ(gmres(product, by_diagonal, b, 1e-9, 500, report.solution).iterations, 0);
}

TEST(Gmres, TellsThatTheLimitWasReached) {
    const MatrixXd A = one_sided(120);
    const auto product = [&](const VectorXd& v) { return VectorXd(A * v); };
    const auto unchanged = [](const VectorXd& v) { return v; };
    const GmresReport report = gmres(product, unchanged, VectorXd::Ones(120), 1e-14, 3);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 3);
}

}  // namespace
}  // namespace myo::solver
