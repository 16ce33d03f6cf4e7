#include "solver/schwarz.hpp"

#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "solver/conjugate_gradient.hpp"
#include "support/figures.hpp"
#include "support/matrices.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;

/// Three unknowns per node of a box that do not know of each other: the vector Laplacian. Its smooth motions are the
/// constants.
SymmetricSparse vector_laplacian(int nx, int ny, int nz, double shift) {
    const SymmetricSparse scalar = test::laplacian(nx, ny, nz, shift);
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < scalar.outerSize(); ++j)
        for (SymmetricSparse::InnerIterator entry(scalar, j); entry; ++entry)
            for (int r = 0; r < 3; ++r)
                for (int s = 0; s < 3; ++s)
                    if (r == s || entry.row() != j ||
                        r > s)  // a node's block is dense below its diagonal, as a body's is
                        entries.emplace_back(3 * static_cast<int>(entry.row()) + r, 3 * j + s,
                                             r == s ? entry.value() : 0.0);
    SymmetricSparse lower(3 * scalar.rows(), 3 * scalar.rows());
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
}

MatrixXd constants(Eigen::Index unknowns) {
    MatrixXd motions = MatrixXd::Zero(unknowns, 3);
    for (Eigen::Index i = 0; i < unknowns; ++i) motions(i, i % 3) = 1.0;
    return motions;
}

ConjugateGradientReport solve_with(const SymmetricSparse& A, const SchwarzPreconditioner& parts, const MatrixXd& B) {
    return conjugate_gradient([&](const MatrixXd& V) { return symmetric_product(A, V); },
                              [&](const MatrixXd& V) { return parts.solve(V); }, B, 1e-8, 400);
}

/// The coarse problem keeps the count of iterations from growing with the number of parts.
TEST(SchwarzPreconditioner, IterationsDoNotGrowWithTheBody) {
    std::vector<double> iterations;
    for (const int length : {40, 120}) {  // 3 and 8 parts
        const SymmetricSparse A = vector_laplacian(length, 17, 17, 1e-6);
        SchwarzPreconditioner parts;
        ASSERT_TRUE(parts.factorize(A, constants(A.rows())));
        std::srand(3);
        const MatrixXd B = MatrixXd::Random(A.rows(), 2);
        const ConjugateGradientReport report = solve_with(A, parts, B);
        EXPECT_TRUE(report.converged);
        EXPECT_LT((A.selfadjointView<Eigen::Lower>() * report.solution - B).norm(), 1e-7 * B.norm());
        iterations.push_back(report.iterations);
    }
    test::record("schwarz_iterations", iterations);
    EXPECT_LT(iterations[0], 40);
    EXPECT_LT(iterations[1], 1.6 * iterations[0]);
}

/// Conjugate gradients need a symmetric operator, and runs the same bits on any number of threads.
TEST(SchwarzPreconditioner, IsSymmetricAndTheSameOnAnyNumberOfThreads) {
    const SymmetricSparse A = vector_laplacian(40, 17, 17, 0.01);
    std::srand(9);
    const MatrixXd B = MatrixXd::Random(A.rows(), 2);
    const auto on = [&](int threads) {
        MatrixXd X;
        parallel_tasks(1, threads, [&](int) {
            SchwarzPreconditioner parts;
            ASSERT_TRUE(parts.factorize(A, constants(A.rows())));
            X = parts.solve(B);
        });
        return X;
    };
    const MatrixXd X = on(1);
    EXPECT_NEAR(B.col(0).dot(X.col(1)), B.col(1).dot(X.col(0)), 1e-5 * B.col(0).norm() * X.col(1).norm());
    EXPECT_TRUE((on(2).array() == X.array()).all());
}

TEST(SchwarzPreconditioner, TellsIndefiniteMatrices) {
    SchwarzPreconditioner parts;
    const SymmetricSparse A = vector_laplacian(12, 12, 12, -3.0);
    EXPECT_FALSE(parts.factorize(A, constants(A.rows())));
    EXPECT_FALSE(parts.has_factor());
}

}  // namespace
}  // namespace myo::solver
