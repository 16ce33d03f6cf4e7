#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "model/internal_forces.hpp"
#include "model/model.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo {

/// One implicit stage of an integrator: find x with
///   inertia M x + dW/dx(x; rate) = constant + f_ext(t),   rate = rate_factor strain(x) + rate_history.
/// inertia = 0 is statics.
struct Stage {
    double time_s = 0.0;
    double inertia_1_s2 = 0.0;
    Eigen::Matrix3Xd constant;          // 3 x n [N]
    double rate_factor_1_s = 0.0;
    Eigen::VectorXd rate_history;       // strain_count entries [1/s]; empty in statics
    bool before_jump = false;           // loads and activations are taken from the left of time_s
};

enum class SolveStatus { not_run, converged, not_converged, not_finite };

struct StageReport {
    SolveStatus status = SolveStatus::not_run;
    int newton_iterations = 0;
    int linear_iterations = 0;
    int factorisations = 0;
    double residual = 0.0;              // relative to the forces on the body
    std::string message;

    bool ok() const { return status == SolveStatus::converged; }
};

struct SolverOptions {
    double tolerance = 1e-7;            // residual over the forces on the body
    double tangent_tolerance = 1e-10;   // relative residual of the linear solves of sensitivities
    int max_newton_iterations = 40;
};

/// Solves stages of one model. Keeps what is worth keeping between them: mass, factor, work.
///
/// Newton's method on the displacements with each cell's pressure as a lagged unknown in the geometric stiffness: the iteration
/// of the mixed method, condensed, which needs no line search at nu near 0.5 where the displacement iteration does. The linear
/// systems are solved by conjugate gradients with an earlier factor as preconditioner; it is renewed when the extra iterations
/// since it was made have cost as much as a new one, by operation counts, so runs are repeatable. Where this does not converge,
/// an energy-decreasing Newton with projected Hessians takes over.
/// Source: Bonet & Wood 2008, sec. 8.6 (pressure); Nocedal & Wright 2006, ch. 7.
/// Not to be shared between threads.
class StageSolver {
public:
    explicit StageSolver(const Model& model, SolverOptions options = {});

    const Model& model() const { return *model_; }
    const Eigen::SparseMatrix<double>& mass() const { return mass_; }

    /// Solves for x, starting from its value. On failure x is the best iterate.
    StageReport solve(const Stage& stage, Eigen::Matrix3Xd& x);

    /// Exact Hessian of the stage at x over the free unknowns.
    SymmetricSparse hessian(const Stage& stage, const Eigen::Matrix3Xd& x);

    /// H^-1 b to the tangent tolerance.
    Eigen::VectorXd solve_linear(const SymmetricSparse& H, const Eigen::VectorXd& b);

    /// External minus internal forces at x for the strain rate of the stage (inertia not included), 3 x n, zero on clamped nodes.
    Eigen::Matrix3Xd total_forces(const Stage& stage, const Eigen::Matrix3Xd& x);

private:
    struct Evaluation {
        double potential = 0.0;
        Eigen::VectorXd residual;
        SymmetricSparse hessian;
    };
    Evaluation evaluate(const Stage& stage, const Eigen::Matrix3Xd& x, HessianKind kind, const Eigen::VectorXd* pressure);
    double force_scale(const Stage& stage, const Eigen::Matrix3Xd& start) const;
    double rounding_of_forces(const Stage& stage, const Eigen::Matrix3Xd& x) const;
    bool pressure_newton(const Stage& stage, double scale, Eigen::Matrix3Xd& x, StageReport& report);
    bool energy_newton(const Stage& stage, double scale, Eigen::Matrix3Xd& x, StageReport& report);
    bool solve_step(const SymmetricSparse& H, const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd& step, StageReport& report);
    bool renew_factor(const SymmetricSparse& H, StageReport& report);
    bool factor_is_stale() const;

    const Model* model_;
    SolverOptions options_;
    Eigen::SparseMatrix<double> mass_;   // n x n
    SymmetricSparse inertia_;            // mass over the free unknowns, in the body's pattern
    Stiffness stiffness_;
    SparseCholesky factor_;
    double factored_inertia_ = -1.0;
    int extra_iterations_ = 0;           // linear iterations beyond the two of a fresh factor, since it was made
};

}  // namespace myo
