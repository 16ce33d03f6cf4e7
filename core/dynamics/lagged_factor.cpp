#include "dynamics/lagged_factor.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "model/nodal_rotations.hpp"

namespace myo::dynamics {
namespace {

using ConstMatrix3 = Eigen::Map<const Eigen::Matrix3d>;

/// W B (or W' B): the three components of every free node are rotated by that node's W.
Eigen::MatrixXd turned(const model::BlockPattern& pattern, const Eigen::Matrix<double, 9, Eigen::Dynamic>& warp,
                       const Eigen::MatrixXd& B, bool transposed) {
    Eigen::MatrixXd result(B.rows(), B.cols());
    parallel_ranges(pattern.free_count, 2000, [&](int first, int end) {
        for (Eigen::Index k = 0; k < B.cols(); ++k)
            for (int i = first; i < end; ++i) {
                const ConstMatrix3 W(warp.col(pattern.free_nodes[static_cast<std::size_t>(i)]).data());
                const Eigen::Vector3d b = B.col(k).segment<3>(3 * i);
                if (transposed)
                    result.col(k).segment<3>(3 * i) = W.transpose() * b;
                else
                    result.col(k).segment<3>(3 * i) = W * b;
            }
    });
    return result;
}

/// Translations and homogeneous deformations of the body, rigid rotations among them: unknowns x 12.
///
/// They form the coarse space of the Schwarz preconditioner, whose subdomains alone cannot transport such motions.
Eigen::MatrixXd smooth_motions(const model::BlockPattern& pattern, const Eigen::Matrix3Xd& x) {
    const Eigen::Vector3d middle = x.rowwise().mean();
    const double size = (x.colwise() - middle).cwiseAbs().maxCoeff();
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(pattern.unknowns(), 12);
    for (int i = 0; i < pattern.free_count; ++i) {
        const Eigen::Vector3d place = (x.col(pattern.free_nodes[static_cast<std::size_t>(i)]) - middle) / size;
        for (int r = 0; r < 3; ++r) {
            motions(3 * i + r, r) = 1.0;
            motions.block<1, 3>(3 * i + r, 3 + 3 * r) = place.transpose();
        }
    }
    return motions;
}

}  // namespace

bool LaggedFactor::is_whole(const model::BlockPattern& pattern) {
    if (whole_.factor_entries() == 0.0) whole_.analyse(pattern.zero);
    return whole_.factor_entries() <= max_entries_;
}

bool LaggedFactor::factorize(const solver::SymmetricSparse& H, const model::Body& body, const Eigen::Matrix3Xd& x) {
    return is_whole(body.pattern) ? whole_.factorize(H) : parts_.factorize(H, smooth_motions(body.pattern, x));
}

bool LaggedFactor::renew(const StageProblem& problem, const Eigen::Matrix3Xd& x, StageReport& report) {
    // Fibres under compression are the usual cause of an indefinite Hessian; they are projected before the cells, which
    // costs more of the convergence rate.
    for (const model::HessianKind kind :
         {model::HessianKind::exact, model::HessianKind::positive_fibres, model::HessianKind::positive}) {
        if (kind == model::HessianKind::positive_fibres && problem.model().fibres->empty()) continue;
        if (renew_with(problem.evaluate(x, kind).hessian, problem, x, report)) return true;
    }
    return false;
}

bool LaggedFactor::renew_with(const solver::SymmetricSparse& H, const StageProblem& problem, const Eigen::Matrix3Xd& x,
                              StageReport& report) {
    ++report.factorisations;
    extra_iterations_ = 0;
    usual_iterations_.reset();
    const TimedScope scope(report.times.factorisation_s);
    stale_ = !factorize(H, *problem.model().body, x);
    inertia_1_s2_ = problem.stage().inertia_1_s2;
    factored_rotations_ = model::nodal_rotations(*problem.model().body, x);
    // At the moment of factorisation R_now = R_factored: W is the identity.
    warp_ = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(Eigen::Matrix3d::Identity().eval().data())
                .replicate(1, factored_rotations_.cols());
    return !stale_;
}

void LaggedFactor::turn_to(const model::Body& body, const Eigen::Matrix3Xd& x) {
    const Eigen::Matrix<double, 9, Eigen::Dynamic> now = model::nodal_rotations(body, x);
    for (Eigen::Index i = 0; i < now.cols(); ++i)
        Eigen::Map<Eigen::Matrix3d>(warp_.col(i).data()) = ConstMatrix3(now.col(i).data()) *
                                                           ConstMatrix3(factored_rotations_.col(i).data()).transpose();
    // A turn would mix held and free axes, which the factor keeps apart.
    for (const model::GuidedNode& guided : body.guided)
        Eigen::Map<Eigen::Matrix3d>(warp_.col(guided.node).data()).setIdentity();
}

Eigen::MatrixXd LaggedFactor::solve(const model::BlockPattern& pattern, const Eigen::MatrixXd& b) const {
    const Eigen::MatrixXd back = turned(pattern, warp_, b, true);
    return turned(pattern, warp_, whole_.has_factor() ? whole_.solve(back) : parts_.solve(back), false);
}

bool LaggedFactor::is_stale(double inertia_1_s2) const {
    // Both stages of a TR-BDF2 step share their inertia factor. A different one (shortened step, statics) changes the
    // matrix and needs a new factor.
    return stale_ || std::abs(inertia_1_s2 - inertia_1_s2_) > 1e-3 * std::abs(inertia_1_s2_);
}

void LaggedFactor::charge(int iterations, const model::Body& body) {
    // A fresh exact factor needs 2 iterations; a fresh Schwarz preconditioner is measured by its first solve.
    if (!usual_iterations_) usual_iterations_ = whole_.has_factor() ? 2 : iterations;
    extra_iterations_ += std::max(0, iterations - *usual_iterations_);
    if (extra_iterations_ > iterations_per_factorisation(body)) stale_ = true;
}

/// Cost model, measured on one core with 4,608 unknowns: factorisation 30 Gflop/s and 3 us per cell for assembly; a
/// solve in single precision 0.2 ns per entry of the factor; forces 0.3 us per cell.
int LaggedFactor::iterations_per_factorisation(const model::Body& body) const {
    const double cells = body.cell_count();
    const double flops = whole_.has_factor() ? whole_.factor_flops() : parts_.factor_flops();
    const double factorisation = flops / 30e9 + 3e-6 * cells;
    const double iteration = 2e-10 * factor_entries() + 3e-7 * cells;
    return std::clamp(static_cast<int>(factorisation / iteration), 4, 1000);
}

}  // namespace myo::dynamics
