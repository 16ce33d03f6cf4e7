#include "solver/cholmod_session.hpp"

#include <algorithm>
#include <cstdlib>

// OpenMP 5.0, section 3.2.16. Not from <omp.h>: clang's belongs to another runtime than that of CHOLMOD.
extern "C" void omp_set_max_active_levels(int max_levels);

namespace myo::solver {
namespace {

// A factor can outlive the session that made it, so it is freed with a common of its own.
void free_factor(cholmod_factor* factor) {
    cholmod_common common{};
    cholmod_start(&common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
}

}  // namespace

/// One thread at a time. The serial OpenBLAS underneath is not thread-safe (observed: concurrent factorisations gave
/// NaN solutions), and METIS orderings would depend on concurrent calls.
std::mutex& cholmod_mutex() {
    static std::mutex mutex;
    return mutex;
}

cholmod_sparse cholmod_view(const SymmetricSparse& lower) {
    cholmod_sparse matrix{};
    matrix.nrow = static_cast<std::size_t>(lower.rows());
    matrix.ncol = static_cast<std::size_t>(lower.cols());
    matrix.nzmax = static_cast<std::size_t>(lower.nonZeros());
    matrix.p = const_cast<int*>(lower.outerIndexPtr());
    matrix.i = const_cast<int*>(lower.innerIndexPtr());
    matrix.x = const_cast<double*>(lower.valuePtr());
    matrix.stype = -1;  // lower triangle is stored
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
}

CholmodSession::CholmodSession() {
    cholmod_start(&common_);
    // One ordering, instead of the best of several trials.
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_METIS;
    common_.postorder = 1;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.print = 0;
    common_.quick_return_if_not_posdef = 1;
}

CholmodSession::~CholmodSession() { cholmod_finish(&common_); }

CholmodFactor CholmodSession::analyse(cholmod_sparse& matrix) {
    const std::lock_guard<std::mutex> lock(cholmod_mutex());
    return {cholmod_analyze(&matrix, &common_), free_factor};
}

bool CholmodSession::factorise(cholmod_sparse& matrix, cholmod_factor& factor) {
    // Debian's CHOLMOD opens OpenMP regions of four threads. On small factors they cost more than they gain, and
    // parallelism is organised above this level. Level 0 makes every region of this thread serial.
    omp_set_max_active_levels(0);
    const std::lock_guard<std::mutex> lock(cholmod_mutex());
    return cholmod_factorize(&matrix, &factor, &common_) != 0 && common_.status == CHOLMOD_OK &&
           // factor.minor < n marks the column in which a non-positive pivot was found.
           factor.minor == factor.n;
}

Eigen::MatrixXd CholmodSession::solve(cholmod_factor& factor, const Eigen::MatrixXd& B) {
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(B.rows());
    right.ncol = static_cast<std::size_t>(B.cols());
    right.d = right.nrow;
    right.nzmax = right.nrow * right.ncol;
    right.x = const_cast<double*>(B.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    const std::lock_guard<std::mutex> lock(cholmod_mutex());
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, &factor, &right, &common_);
    Eigen::MatrixXd X = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution->x), B.rows(), B.cols());
    cholmod_free_dense(&solution, &common_);
    return X;
}

// Overwrite flag 0: a value set by the user wins.
void use_one_blas_thread() {
    ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
    ::setenv("OMP_NUM_THREADS", "1", 0);
}

}  // namespace myo::solver
