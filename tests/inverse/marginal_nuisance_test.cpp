#include "inverse/marginal_nuisance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

// Unknowns with a normal prior, marginalised, against a fit of all unknowns together with rows for the prior.

namespace myo::inverse::marginal_nuisance_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A linear problem: 40 residuals, 3 parameters, 6 unknowns with a prior, of which one acts on nothing.
struct Problem {
    MatrixXd J, A;
    VectorXd r;
    Problem() {
        std::srand(7);
        J = MatrixXd::Random(40, 3);
        A = 5.0 * MatrixXd::Random(40, 6);
        A.col(1) *= 1e3;  // hardly held by its prior
        A.col(4).setZero();
        r = 10.0 * VectorXd::Random(40);
    }
};

TEST(MarginalNuisance, IsTheFitOfAllUnknownsTogether) {
    const Problem of;
    const MarginalNuisance nuisance(of.A);
    const MatrixXd J = nuisance.whitened(of.J);
    const VectorXd r = nuisance.whitened(of.r);
    const VectorXd step = -(J.transpose() * J).ldlt().solve(J.transpose() * r);

    MatrixXd all = MatrixXd::Zero(46, 9);
    all.topLeftCorner(40, 3) = of.J;
    all.topRightCorner(40, 6) = of.A;
    all.bottomRightCorner(6, 6).setIdentity();
    VectorXd rows = VectorXd::Zero(46);
    rows.head(40) = of.r;
    const MatrixXd information = all.transpose() * all;
    const VectorXd together = -information.ldlt().solve(all.transpose() * rows);
    EXPECT_LT((step - together.head(3)).norm(), 1e-8 * together.head(3).norm());
    const VectorXd left = r + J * step;
    EXPECT_LT((nuisance.mean(left) - together.tail(6)).norm(), 1e-8 * together.tail(6).norm());
    EXPECT_NEAR(left.squaredNorm(), (rows + all * together).squaredNorm(), 1e-8 * left.squaredNorm());

    const MatrixXd covariance = information.ldlt().solve(MatrixXd::Identity(9, 9)),
                   own = (J.transpose() * J).ldlt().solve(MatrixXd::Identity(3, 3));
    EXPECT_LT((own - covariance.topLeftCorner(3, 3)).norm(), 1e-8 * own.norm());
    EXPECT_LT((nuisance.covariance(J, own) - covariance.bottomRightCorner(6, 6)).norm(), 1e-8);
}

TEST(MarginalNuisance, WhitensTheMarginalCovariance) {
    const Problem of;
    const MarginalNuisance nuisance(of.A);
    const MatrixXd covariance = MatrixXd::Identity(40, 40) + of.A * of.A.transpose();
    const MatrixXd white = nuisance.whitened(nuisance.whitened(covariance).transpose());
    EXPECT_LT((white - MatrixXd::Identity(40, 40)).norm(), 1e-6);
    // Without unknowns nothing changes, to the last bit.
    EXPECT_EQ(MarginalNuisance().whitened(of.J), of.J);
    EXPECT_TRUE(MarginalNuisance().empty());
}

}  // namespace
}  // namespace myo::inverse::marginal_nuisance_test
