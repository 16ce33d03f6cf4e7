#include "support/matrices.hpp"

namespace myo::test {

solver::SymmetricSparse random_matrix(int n, unsigned seed, double shift) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_int_distribution<int> row(0, n - 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        // Four entries per column, at random rows; equal positions are added up.
        for (int k = 0; k < 4; ++k) entries.emplace_back(row(random), i, normal(random));
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> identity(n, n);
    identity.setIdentity();
    // A A' is symmetric and at least positive semidefinite; the shift makes it positive definite.
    solver::SymmetricSparse lower = Eigen::SparseMatrix<double>(A * A.transpose() + shift * identity)
                                        .triangularView<Eigen::Lower>();
    lower.makeCompressed();
    return lower;
}

solver::SymmetricSparse laplacian(int nx, int ny, int nz, double shift) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto node = [&](int i, int j, int k) { return i + nx * (j + ny * k); };
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                entries.emplace_back(node(i, j, k), node(i, j, k), 6.0 + shift);
                if (i + 1 < nx) entries.emplace_back(node(i + 1, j, k), node(i, j, k), -1.0);
                if (j + 1 < ny) entries.emplace_back(node(i, j + 1, k), node(i, j, k), -1.0);
                if (k + 1 < nz) entries.emplace_back(node(i, j, k + 1), node(i, j, k), -1.0);
            }
    solver::SymmetricSparse lower(nx * ny * nz, nx * ny * nz);
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
}

}  // namespace myo::test
