#include "solver/sparse_cholesky.hpp"

#include <cassert>

#include "base/cancellation.hpp"
#include "solver/cholmod_session.hpp"

namespace myo::solver {

struct SparseCholesky::Implementation {
    CholmodSession session;
    CholmodFactor factor{nullptr, nullptr};
};

SparseCholesky::SparseCholesky() : implementation_(std::make_unique<Implementation>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factorize(const SymmetricSparse& lower) {
    assert(lower.isCompressed() && lower.rows() == lower.cols());
    Implementation& self = *implementation_;
    self.factor.reset();
    if (cancellation_requested()) return false;  // CHOLMOD itself cannot be interrupted
    cholmod_sparse matrix = cholmod_view(lower);
    self.factor = self.session.analyse(matrix);
    if (self.factor && !self.session.factorise(matrix, *self.factor)) self.factor.reset();
    return has_factor();
}

bool SparseCholesky::has_factor() const { return implementation_->factor != nullptr; }

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& B) const {
    assert(has_factor());
    return implementation_->session.solve(*implementation_->factor, B);
}

}  // namespace myo::solver
