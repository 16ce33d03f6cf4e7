#pragma once

#include <cholmod.h>

#include <memory>
#include <mutex>

#include "solver/sparse_cholesky.hpp"

namespace myo::solver {

/// Serialises all calls into CHOLMOD and METIS. METIS draws from one global random generator, so its orderings would
/// otherwise depend on the order of calls; see cholmod_session.cpp for the BLAS underneath.
std::mutex& cholmod_mutex();

/// View of the matrix in CHOLMOD's format. Shares the arrays, so `lower` must outlive it.
cholmod_sparse cholmod_view(const SymmetricSparse& lower);

/// Owned symbolic or numeric factor.
using CholmodFactor = std::unique_ptr<cholmod_factor, void (*)(cholmod_factor*)>;

/// CHOLMOD workspace, configured for supernodal factors in METIS nested-dissection ordering.
class CholmodSession {
public:
    CholmodSession();
    ~CholmodSession();
    CholmodSession(const CholmodSession&) = delete;
    CholmodSession& operator=(const CholmodSession&) = delete;

    /// Symbolic analysis: fill-reducing ordering and pattern of the factor. Null if memory runs out.
    CholmodFactor analyse(cholmod_sparse& matrix);
    /// Numeric factorisation into an analysed factor.
    /// @return  false if the matrix is not positive definite
    bool factorise(cholmod_sparse& matrix, cholmod_factor& factor);
    /// Solution of A X = B for B of n x k.
    Eigen::MatrixXd solve(cholmod_factor& factor, const Eigen::MatrixXd& B);

private:
    cholmod_common common_{};
};

}  // namespace myo::solver
