#pragma once

#include <cholmod.h>

#include <memory>
#include <mutex>

#include "solver/sparse_cholesky.hpp"

namespace myo::solver {

/// Held by whoever is in CHOLMOD, or in METIS, which draws from one random generator.
std::mutex& cholmod_mutex();

/// A matrix of ours as CHOLMOD sees it; it copies nothing.
cholmod_sparse cholmod_view(const SymmetricSparse& lower);

using CholmodFactor = std::unique_ptr<cholmod_factor, void (*)(cholmod_factor*)>;

/// CHOLMOD's workspace, set up for supernodal factors in METIS ordering.
class CholmodSession {
public:
    CholmodSession();
    ~CholmodSession();
    CholmodSession(const CholmodSession&) = delete;
    CholmodSession& operator=(const CholmodSession&) = delete;

    /// Ordering and pattern of the factor, without values. Empty when it runs out of memory.
    CholmodFactor analyse(cholmod_sparse& matrix);
    /// Its values. False when the matrix is not positive definite.
    bool factorise(cholmod_sparse& matrix, cholmod_factor& factor);
    Eigen::MatrixXd solve(cholmod_factor& factor, const Eigen::MatrixXd& B);

private:
    cholmod_common common_{};
};

}  // namespace myo::solver
