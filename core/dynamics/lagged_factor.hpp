#pragma once

#include <Eigen/Core>

#include <optional>

#include "dynamics/stage_problem.hpp"
#include "solver/fast_cholesky.hpp"
#include "solver/schwarz.hpp"

namespace myo::dynamics {

/// The factor of an earlier Hessian, kept while it pays and turned with the body.
///
/// A rotated body has a rotated Hessian, so the factor serves large motions when right-hand sides are turned back to
/// where it was made, node by node, and solutions forth: p = W A^-1 W' b, W = R_now R_factored' per node. It is renewed
/// when the iterations it cost beyond those of a fresh one would have paid for one, by operation counts rather than by
/// the clock, so that runs are repeatable.
///
/// Of a body whose factor would take too much memory it keeps the factors of overlapping parts: see is_whole().
class LaggedFactor {
public:
    /// most_entries: of a factor of the whole body.
    explicit LaggedFactor(double most_entries) : most_entries_(most_entries) {}

    /// Whether solve() is the inverse of the matrix that was factored, to single precision; or only close enough to it
    /// for conjugate gradients. Analyses the pattern when asked first.
    bool is_whole(const model::BlockPattern& pattern);

    /// Factors the exact Hessian at x or, where that is not definite, the one of positive fibres, or of positive cells.
    /// False: none is.
    bool renew(const StageProblem& problem, const Eigen::Matrix3Xd& x, StageReport& report);

    /// Factors a given matrix, made at x.
    bool renew_with(const solver::SymmetricSparse& H, const StageProblem& problem, const Eigen::Matrix3Xd& x,
                    StageReport& report);

    /// Turns the factor to the body's present positions x.
    void turn_to(const model::Body& body, const Eigen::Matrix3Xd& x);

    /// p = W A^-1 W' b for one or more columns.
    Eigen::MatrixXd solve(const model::BlockPattern& pattern, const Eigen::MatrixXd& b) const;

    double factor_entries() const { return whole_.has_factor() ? whole_.factor_entries() : parts_.factor_entries(); }
    /// Whether a stage with this inertia should renew the factor before it starts.
    bool is_stale(double inertia_1_s2) const;
    void mark_stale() { stale_ = true; }

    /// Counts a solve's iterations: those beyond the usual ones of a fresh factor are its price.
    void charge(int iterations, const model::Body& body);

    /// Iterations that cost as much as a new factor.
    int iterations_per_factorisation(const model::Body& body) const;

private:
    bool factorize(const solver::SymmetricSparse& H, const model::Body& body, const Eigen::Matrix3Xd& x);

    double most_entries_;
    solver::FastCholesky whole_;
    solver::SchwarzPreconditioner parts_;
    Eigen::Matrix<double, 9, Eigen::Dynamic> factored_rotations_;
    Eigen::Matrix<double, 9, Eigen::Dynamic> warp_;  // W per node
    double inertia_1_s2_ = -1.0;
    std::optional<int> usual_iterations_;  // of a solve with this factor; none yet
    long extra_iterations_ = 0;
    bool stale_ = true;
};

}  // namespace myo::dynamics
