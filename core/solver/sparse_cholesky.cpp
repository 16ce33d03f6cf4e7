#include "solver/sparse_cholesky.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

#include "solver/supernodal_factor.hpp"

namespace myo {

struct SparseCholesky::Implementation {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr;   // work space that CHOLMOD reuses between solves
    cholmod_dense* work_y = nullptr;
    cholmod_dense* work_e = nullptr;
    SupernodalFactor single;
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

/// CHOLMOD's supernodal factor, cast. The permutation and the pattern are copied with it: they are small beside the values.
SupernodalFactor single_precision(const cholmod_factor& factor) {
    assert(factor.is_super && factor.is_ll && factor.xtype == CHOLMOD_REAL);
    const auto* permutation = static_cast<const int*>(factor.Perm);
    const auto* columns = static_cast<const int*>(factor.super);
    const auto* row_starts = static_cast<const int*>(factor.pi);
    const auto* value_starts = static_cast<const int*>(factor.px);
    const auto* rows = static_cast<const int*>(factor.s);
    const auto* values = static_cast<const double*>(factor.x);
    SupernodalFactor f;
    f.permutation.assign(permutation, permutation + factor.n);
    f.first_column.assign(columns, columns + factor.nsuper + 1);
    f.first_row.assign(row_starts, row_starts + factor.nsuper + 1);
    f.first_value.assign(value_starts, value_starts + factor.nsuper + 1);
    f.rows.assign(rows, rows + factor.ssize);
    f.values.resize(factor.xsize);
    std::transform(values, values + factor.xsize, f.values.begin(), [](double v) { return static_cast<float>(v); });
    return f;
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
    if (self.positive_definite) self.single = single_precision(*self.factor);
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

Eigen::MatrixXd SparseCholesky::solve_single(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
    assert(has_factor());
    return implementation_->single.solve(B);
}

double SparseCholesky::factor_entries() const { return implementation_->common.lnz; }
double SparseCholesky::factor_flops() const { return implementation_->common.fl; }

void use_one_blas_thread() {
    ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
    ::setenv("OMP_NUM_THREADS", "1", 0);
}

}  // namespace myo
