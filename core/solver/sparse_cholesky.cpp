#include "solver/sparse_cholesky.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

namespace myo {

struct SparseCholesky::Implementation {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr;   // work space that CHOLMOD reuses between solves
    cholmod_dense* work_y = nullptr;
    cholmod_dense* work_e = nullptr;
    bool positive_definite = false;
    std::vector<int> starts, rows;         // the pattern that `factor` was analysed for

    /// CHOLMOD would drop entries outside the analysed pattern without a word.
    bool knows_pattern(const SymmetricSparse& lower) const {
        return factor != nullptr && std::equal(starts.begin(), starts.end(), lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1) &&
               std::equal(rows.begin(), rows.end(), lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
    }

    Implementation() {
        cholmod_start(&common);
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_METIS;
        common.postorder = 1;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.print = 0;
        common.quick_return_if_not_posdef = 1;
    }
    ~Implementation() {
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work_y, &common);
        cholmod_free_dense(&work_e, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
};

namespace {

/// One thread at a time in CHOLMOD: the serial OpenBLAS underneath is not safe to call from two threads (seen: runs
/// side by side gave solutions that were not numbers), and METIS draws from one random generator, so that
/// orderings would depend on what runs beside.
std::mutex& linear_algebra_mutex() {
    static std::mutex mutex;
    return mutex;
}

cholmod_sparse view(const SymmetricSparse& lower) {
    cholmod_sparse matrix{};
    matrix.nrow = static_cast<std::size_t>(lower.rows());
    matrix.ncol = static_cast<std::size_t>(lower.cols());
    matrix.nzmax = static_cast<std::size_t>(lower.nonZeros());
    matrix.p = const_cast<int*>(lower.outerIndexPtr());
    matrix.i = const_cast<int*>(lower.innerIndexPtr());
    matrix.x = const_cast<double*>(lower.valuePtr());
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
}

}  // namespace

SparseCholesky::SparseCholesky() : implementation_(std::make_unique<Implementation>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factorize(const SymmetricSparse& lower) {
    assert(lower.isCompressed() && lower.rows() == lower.cols());
    // Debian's CHOLMOD opens OpenMP regions of four threads by itself; on small factors they cost more than they give, and
    // threads belong to us. Level 0 makes every region of this thread serial.
    omp_set_max_active_levels(0);
    const std::lock_guard<std::mutex> lock(linear_algebra_mutex());
    Implementation& self = *implementation_;
    cholmod_sparse matrix = view(lower);
    if (!self.knows_pattern(lower)) {
        self.starts.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
        self.rows.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
        cholmod_free_factor(&self.factor, &self.common);
        self.factor = cholmod_analyze(&matrix, &self.common);
    }
    self.positive_definite = self.factor != nullptr && cholmod_factorize(&matrix, self.factor, &self.common) != 0 &&
                             self.common.status == CHOLMOD_OK && self.factor->minor == self.factor->n;
    return self.positive_definite;
}

bool SparseCholesky::has_factor() const { return implementation_->positive_definite; }

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& B) const {
    assert(has_factor());
    Implementation& self = *implementation_;
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(B.rows());
    right.ncol = static_cast<std::size_t>(B.cols());
    right.d = right.nrow;
    right.nzmax = right.nrow * right.ncol;
    right.x = const_cast<double*>(B.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    const std::lock_guard<std::mutex> lock(linear_algebra_mutex());
    cholmod_solve2(CHOLMOD_A, self.factor, &right, nullptr, &self.solution, nullptr, &self.work_y, &self.work_e, &self.common);
    Eigen::MatrixXd X(B.rows(), B.cols());
    std::memcpy(X.data(), self.solution->x, sizeof(double) * static_cast<std::size_t>(X.size()));
    return X;
}

double SparseCholesky::factor_entries() const { return implementation_->common.lnz; }
double SparseCholesky::factor_flops() const { return implementation_->common.fl; }

void use_one_blas_thread() {
    ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
    ::setenv("OMP_NUM_THREADS", "1", 0);
}

}  // namespace myo
