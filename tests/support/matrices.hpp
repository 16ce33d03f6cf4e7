#pragma once

#include <Eigen/SparseCore>

#include <random>
#include <vector>

#include "solver/sparse_cholesky.hpp"

namespace myo::test {

/// A random symmetric positive definite sparse matrix, lower triangle.
///
/// @param shift  positive; added to the diagonal
solver::SymmetricSparse random_matrix(int n, unsigned seed, double shift);

/// The seven-point Laplacian of an nx x ny x nz grid plus `shift` on the diagonal, lower triangle. Its elimination tree
/// has many branches.
solver::SymmetricSparse laplacian(int nx, int ny, int nz, double shift);

}  // namespace myo::test
