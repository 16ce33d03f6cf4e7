#include "base/decompositions.hpp"

#include <gtest/gtest.h>

namespace myo {
namespace {

using Eigen::MatrixXd;

TEST(Decompositions, TheLeadingPartsOfAWideAndATallMatrixAreItsBestApproximation) {
    std::srand(3);
    // Singular values 5, 2, 0.1 between bases at right angles.
    const MatrixXd left = symmetric_eigen(MatrixXd(smaller_gram(MatrixXd::Random(6, 9)))).vectors.leftCols(3);
    const MatrixXd right = symmetric_eigen(MatrixXd(smaller_gram(MatrixXd::Random(11, 20)))).vectors.leftCols(3);
    const Eigen::Vector3d sizes(5.0, 2.0, 0.1);
    const MatrixXd wide = left * sizes.asDiagonal() * right.transpose();
    for (const MatrixXd& A : {wide, MatrixXd(wide.transpose())}) {
        const LeadingSvd whole = leading_svd(A, 6);
        ASSERT_EQ(whole.sizes.size(), 3) << "what rounding leaves of the others is not seen";
        EXPECT_LT((whole.sizes - sizes).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((whole.left * whole.sizes.asDiagonal() * whole.right.transpose() - A).norm(), 1e-12);
        EXPECT_LT((whole.left.transpose() * whole.left - MatrixXd::Identity(3, 3)).norm(), 1e-10);
        EXPECT_LT((whole.right.transpose() * whole.right - MatrixXd::Identity(3, 3)).norm(), 1e-10);
        const LeadingSvd first = leading_svd(A, 1);
        ASSERT_EQ(first.sizes.size(), 1);
        // Eckart and Young: the rest has the norm of the other singular values.
        EXPECT_NEAR((first.left * first.sizes.asDiagonal() * first.right.transpose() - A).norm(), std::hypot(2.0, 0.1),
                    1e-12);
    }
    EXPECT_EQ(leading_svd(MatrixXd(4, 0), 2).sizes.size(), 0);
    EXPECT_EQ(leading_svd(MatrixXd::Zero(4, 3), 2).sizes.size(), 0);
}

TEST(Decompositions, SymmetricEigenvaluesAscendAndReadTheLowerTriangle) {
    MatrixXd A(2, 2);
    A << 2.0, 99.0, 1.0, 2.0;
    const SymmetricEigen eigen = symmetric_eigen(A);
    EXPECT_NEAR(eigen.values(0), 1.0, 1e-15);
    EXPECT_NEAR(eigen.values(1), 3.0, 1e-15);
    EXPECT_LT((symmetric_eigenvalues(A) - eigen.values).norm(), 1e-14);
    A(0, 1) = 1.0;
    EXPECT_LT((A * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-14);
}

}  // namespace
}  // namespace myo
