#include "dynamics/natural_modes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/cancellation.hpp"
#include "dynamics/statics.hpp"

namespace myo::dynamics {
namespace {

/// Termination of the subspace iteration.
struct ModePolicy {
    int max_iterations = 100;
    double settled = 1e-7;  // relative residual of a converged mode, see NaturalModes
    /// Accepted residual once the iteration stalls: in nearly incompressible thin bodies the rounding of the forces
    /// ends the decrease earlier. The error of a frequency is of the order of the residual squared.
    double acceptable = 1e-4;
    double min_fall = 0.7;  // ratio of successive residuals above which the iteration counts as stalled
};
constexpr ModePolicy mode_policy;

using Eigen::MatrixXd;

/// Start vectors without structure, so that each has a component along every mode. Deterministic: runs repeat.
MatrixXd start_block(int rows, int columns) {
    MatrixXd block(rows, columns);
    for (int j = 0; j < columns; ++j)
        for (int i = 0; i < rows; ++i) block(i, j) = std::sin(1.0 + 0.7 * (j + 1) * i + 0.013 * i * (i % 11));
    return block;
}

}  // namespace

NaturalModes natural_modes(StageSolver& solver, const Eigen::Matrix3Xd& x, int count, double time_s) {
    const model::BlockPattern& pattern = solver.model().body->pattern;
    assert(count > 0 && count <= pattern.unknowns());
    const Stage stage = static_stage(*solver.model().body, time_s);
    const solver::SymmetricSparse K = solver.hessian(stage, x);
    const auto inertia_of = [&](const MatrixXd& V) {
        MatrixXd result(V.rows(), V.cols());
        for (Eigen::Index j = 0; j < V.cols(); ++j)
            result.col(j) = model::gather(pattern,
                                          model::times_mass(model::scatter(pattern, V.col(j)), solver.mass(time_s)));
        return result;
    };
    // The error of mode i decreases by (omega_i / omega_(block + 1))^2 per iteration: more vectors than modes.
    const int block = std::min(std::max(2 * count, count + 4), pattern.unknowns());
    NaturalModes result;
    MatrixXd V = start_block(pattern.unknowns(), block);
    for (result.iterations = 1; result.iterations <= mode_policy.max_iterations; ++result.iterations) {
        if (cancellation_requested()) {
            result.status = SolveStatus::not_converged;
            return result;
        }
        V = solver.solve_linear(K, stage, x, inertia_of(V), {}, model::StiffnessForm::symmetric);
        const MatrixXd KV = K.selfadjointView<Eigen::Lower>() * V, MV = inertia_of(V);
        // Rayleigh-Ritz: best approximations of the modes within the subspace, M-orthonormal.
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(V.transpose() * KV, V.transpose() * MV);
        if (!V.allFinite() || ritz.info() != Eigen::Success || ritz.eigenvalues()(0) <= 0.0) {
            result.status = SolveStatus::not_finite;
            return result;
        }
        V = (V * ritz.eigenvectors()).eval();
        const MatrixXd force = KV * ritz.eigenvectors(), inertia = MV * ritz.eigenvectors();
        const double before = std::exchange(result.residual, 0.0);
        for (int j = 0; j < count; ++j) {
            const double error = (force.col(j) - ritz.eigenvalues()(j) * inertia.col(j)).norm() / force.col(j).norm();
            result.residual = std::max(result.residual, error);
        }
        result.status = SolveStatus::not_converged;
        const bool stalled = result.iterations > 1 && result.residual > mode_policy.min_fall * before;
        if (result.residual > (stalled ? mode_policy.acceptable : mode_policy.settled)) continue;
        result.status = SolveStatus::converged;
        for (int j = 0; j < count; ++j)
            result.modes.push_back({std::sqrt(ritz.eigenvalues()(j)), model::scatter(pattern, V.col(j))});
        return result;
    }
    return result;
}

}  // namespace myo::dynamics
