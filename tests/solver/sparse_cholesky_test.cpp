#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "solver/sparse_cholesky.hpp"
#include "support/matrices.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;
using test::random_matrix;

TEST(SparseCholesky, SolvesAsEigenDoesForSeveralRightHandSides) {
    for (const int n : {1, 2, 30, 400}) {
        const SymmetricSparse H = random_matrix(n, 11, 0.5);
        const SymmetricSparse before = H;
        std::srand(4);
        const MatrixXd B = MatrixXd::Random(n, 5);
        SparseCholesky mine;
        EXPECT_FALSE(mine.has_factor());
        ASSERT_TRUE(mine.factorize(H));
        EXPECT_TRUE(mine.has_factor());
        const Eigen::SimplicialLLT<SymmetricSparse, Eigen::Lower> other(H);
        const MatrixXd X = mine.solve(B), Y = other.solve(B);
        EXPECT_LT((X - Y).norm(), 1e-10 * Y.norm());
        EXPECT_LT((H.selfadjointView<Eigen::Lower>() * X - B).norm(),
                  1e-12 * static_cast<double>(n) * B.norm() + 1e-13);
        EXPECT_LT((mine.solve(B.col(2)) - X.col(2)).norm(), 1e-12 * X.col(2).norm());
        EXPECT_TRUE((MatrixXd(H).array() == MatrixXd(before).array()).all());
    }
}

TEST(SparseCholesky, IndefiniteMatricesAreToldAndTheFactorRecovers) {
    const SymmetricSparse H = random_matrix(80, 5, 0.1);
    SparseCholesky solver;
    ASSERT_TRUE(solver.factorize(H));
    SymmetricSparse indefinite = H;
    indefinite.coeffRef(40, 40) = -1.0;
    EXPECT_FALSE(solver.factorize(indefinite));
    EXPECT_FALSE(solver.has_factor());
    ASSERT_TRUE(solver.factorize(H));
    const MatrixXd b = MatrixXd::Ones(80, 1);
    EXPECT_LT((H.selfadjointView<Eigen::Lower>() * solver.solve(b) - b).norm(), 1e-10);
}

}  // namespace
}  // namespace myo::solver
