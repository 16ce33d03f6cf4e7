#pragma once

#include <Eigen/Core>

#include <optional>

#include "dynamics/stage_problem.hpp"
#include "solver/fast_cholesky.hpp"
#include "solver/schwarz.hpp"

namespace myo::dynamics {

/// Cholesky factor of an earlier Hessian, reused as long as this is cheaper than a new one and rotated with the body.
///
/// The Hessian of a rotated body is the rotated Hessian. The factor therefore stays useful in large motions if each
/// node's part of the right-hand side is rotated back to the configuration of the factorisation and the solution is
/// rotated forward again: p = W A^-1 W' b, W = R_now R_factored' per node. The factor is renewed once the iterations it
/// cost beyond those of a fresh factor equal the cost of a factorisation. Costs are operation counts and not wall-clock
/// times, so that runs are reproducible.
///
/// If the factor of the whole body would exceed the memory limit, overlapping subdomains are factored instead: see
/// is_whole().
class LaggedFactor {
public:
    /// @param max_entries  limit for the factor of the whole body [entries of single precision]
    explicit LaggedFactor(double max_entries) : max_entries_(max_entries) {}

    /// True if solve() is the inverse of the factored matrix to single precision; false if it is a Schwarz
    /// preconditioner, to be used with conjugate gradients only. The first call does the symbolic analysis.
    bool is_whole(const model::BlockPattern& pattern);

    /// Factors the Hessian at x: the exact one or, if that is indefinite, one with positive fibre terms, or one with
    /// positive semidefinite cells. Returns false if none is positive definite.
    bool renew(const StageProblem& problem, const Eigen::Matrix3Xd& x, StageReport& report);

    /// Factors a given matrix. `x` are the positions at which it was assembled, 3 x n [m].
    bool renew_with(const solver::SymmetricSparse& H, const StageProblem& problem, const Eigen::Matrix3Xd& x,
                    StageReport& report);

    /// Sets the nodal rotations W from the present positions x, 3 x n [m].
    void turn_to(const model::Body& body, const Eigen::Matrix3Xd& x);

    /// p = W A^-1 W' b for one or more columns; b: unknowns x k.
    Eigen::MatrixXd solve(const model::BlockPattern& pattern, const Eigen::MatrixXd& b) const;

    /// Stored entries of the factor; 0 before the first factorisation.
    double factor_entries() const { return whole_.has_factor() ? whole_.factor_entries() : parts_.factor_entries(); }
    /// Whether a stage with this inertia factor should renew the factor before its solve.
    bool is_stale(double inertia_1_s2) const;
    /// Forces a new factor at the next solve.
    void mark_stale() { stale_ = true; }

    /// Accounts for the iterations of a solve: those beyond the usual number of a fresh factor count as its cost.
    void charge(int iterations, const model::Body& body);

    /// Number of iterations that cost as much as a new factorisation.
    int iterations_per_factorisation(const model::Body& body) const;

private:
    bool factorize(const solver::SymmetricSparse& H, const model::Body& body, const Eigen::Matrix3Xd& x);

    double max_entries_;                                           // limit for whole_
    solver::FastCholesky whole_;                                   // factor of the whole body, single precision
    solver::SchwarzPreconditioner parts_;                          // subdomain factors, used above the limit
    Eigen::Matrix<double, 9, Eigen::Dynamic> factored_rotations_;  // R_factored per node, column-major 3 x 3
    Eigen::Matrix<double, 9, Eigen::Dynamic> warp_;                // W per node, column-major 3 x 3
    double inertia_1_s2_ = -1.0;                                   // inertia factor of the factored stage; -1: none
    std::optional<int> usual_iterations_;                          // of the first solve with this factor
    long extra_iterations_ = 0;                                    // beyond the usual number, since the factorisation
    bool stale_ = true;
};

}  // namespace myo::dynamics
