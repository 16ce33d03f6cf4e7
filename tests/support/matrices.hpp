#pragma once

#include <Eigen/SparseCore>

#include <random>
#include <vector>

#include "solver/sparse_cholesky.hpp"

namespace myo::test {

/// Random symmetric positive definite matrix with a few entries per row, lower triangle.
solver::SymmetricSparse random_matrix(int n, unsigned seed, double shift);

/// The seven-point Laplacian of a box of nodes plus a shift, lower triangle: a tree with many branches.
solver::SymmetricSparse laplacian(int nx, int ny, int nz, double shift);

}  // namespace myo::test
