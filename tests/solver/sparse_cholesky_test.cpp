#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <random>

#include "solver/sparse_cholesky.hpp"

namespace myo {
namespace {

using Eigen::MatrixXd;

/// Random symmetric positive definite matrix with a few entries per row, lower triangle.
SymmetricSparse random_matrix(int n, unsigned seed, double shift) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_int_distribution<int> row(0, n - 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 4; ++k) entries.emplace_back(row(random), i, normal(random));
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> identity(n, n);
    identity.setIdentity();
    SymmetricSparse lower = Eigen::SparseMatrix<double>(A * A.transpose() + shift * identity).triangularView<Eigen::Lower>();
    lower.makeCompressed();
    return lower;
}

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
        EXPECT_LT((H.selfadjointView<Eigen::Lower>() * X - B).norm(), 1e-12 * static_cast<double>(n) * B.norm() + 1e-13);
        EXPECT_LT((mine.solve(B.col(2)) - X.col(2)).norm(), 1e-12 * X.col(2).norm());
        EXPECT_TRUE((MatrixXd(H).array() == MatrixXd(before).array()).all());
        EXPECT_GE(mine.factor_entries(), static_cast<double>(n));
    }
}

/// The copy in single precision solves to its precision, for one and for several columns, of any size of numbers.
TEST(SparseCholesky, SinglePrecisionSolvesToItsPrecision) {
    for (const int n : {1, 2, 30, 400}) {
        const SymmetricSparse H = random_matrix(n, 13, 4.0);
        std::srand(5);
        MatrixXd B = MatrixXd::Random(n, 5);
        B.col(1) *= 1e60;    // beyond the range of single precision
        B.col(2) *= 1e-60;
        B.col(3).setZero();
        SparseCholesky factor;
        ASSERT_TRUE(factor.factorize(H));
        const MatrixXd exact = factor.solve(B), X = factor.solve_single(B);
        for (int k = 0; k < 5; ++k) {
            EXPECT_LE((X.col(k) - exact.col(k)).norm(), 1e-4 * exact.col(k).norm()) << n << " column " << k;
            EXPECT_LE((factor.solve_single(B.col(k)) - exact.col(k)).norm(), 1e-4 * exact.col(k).norm()) << n << " column " << k << " alone";
        }
    }
}

TEST(SparseCholesky, NewValuesReuseThePatternAndAnotherSizeIsAnalysedAnew) {
    SparseCholesky solver;
    SymmetricSparse H = random_matrix(60, 1, 1.0);
    ASSERT_TRUE(solver.factorize(H));
    const MatrixXd b = MatrixXd::Ones(60, 1);
    const MatrixXd x = solver.solve(b);
    H.coeffs() *= 4.0;
    ASSERT_TRUE(solver.factorize(H));
    EXPECT_LT((4.0 * solver.solve(b) - x).norm(), 1e-12 * x.norm());
    const SymmetricSparse other = random_matrix(25, 2, 1.0);
    ASSERT_TRUE(solver.factorize(other));
    const MatrixXd c = MatrixXd::Ones(25, 1);
    EXPECT_LT((other.selfadjointView<Eigen::Lower>() * solver.solve(c) - c).norm(), 1e-10);
}

TEST(SparseCholesky, IndefiniteMatricesAreToldAndTheFactorRecovers) {
    SymmetricSparse H = random_matrix(80, 5, 0.1);
    SparseCholesky solver;
    ASSERT_TRUE(solver.factorize(H));
    SymmetricSparse indefinite = H;
    indefinite.coeffRef(40, 40) = -1.0;
    EXPECT_FALSE(solver.factorize(indefinite));
    EXPECT_FALSE(solver.has_factor());
    SymmetricSparse negative = H;
    negative.coeffs() *= -1.0;
    EXPECT_FALSE(solver.factorize(negative));
    ASSERT_TRUE(solver.factorize(H));
    const MatrixXd b = MatrixXd::Ones(80, 1);
    EXPECT_LT((H.selfadjointView<Eigen::Lower>() * solver.solve(b) - b).norm(), 1e-10);
}

TEST(SparseCholesky, SamePatternWithOtherPlacesOfTheEntriesIsNotMistaken) {
    SymmetricSparse diagonal(3, 3), full(3, 3);
    diagonal.setIdentity();
    full = MatrixXd(Eigen::Matrix3d{{4, 0, 0}, {1, 5, 0}, {2, 1, 6}}).sparseView();
    diagonal.makeCompressed();
    full.makeCompressed();
    SparseCholesky solver;
    ASSERT_TRUE(solver.factorize(diagonal));
    ASSERT_TRUE(solver.factorize(full));
    const MatrixXd b = MatrixXd::Ones(3, 1);
    EXPECT_LT((full.selfadjointView<Eigen::Lower>() * solver.solve(b) - b).norm(), 1e-13);
}

}  // namespace
}  // namespace myo
