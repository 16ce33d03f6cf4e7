#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "sensitivity/model_gradient.hpp"
#include "sensitivity/run_tape.hpp"
#include "sensitivity/softening_adjoint.hpp"
#include "sensitivity/step_coefficients.hpp"

namespace myo::sensitivity {

// Discrete adjoint of a run. A step is a linear map of the state and of its stage solutions (StepCoefficients), and
// each stage solution follows from the stage equation r(x; constant, histories, parameters) = 0 with the Hessian H =
// dr/dx. Backwards through a step:
//   1. the adjoint of each stage solution collects its contributions from the rows of the map, last stage first;
//   2. p = H^-1 (this adjoint) is the adjoint of the stage constant, H being symmetric;
//   3. the gradient with respect to a parameter gains -p . dr/dparameter;
//   4. the adjoint of the state before the step is the transposed map applied to the adjoints of all rows.

/// Derivative of a loss with respect to the Kinematics at some time. Empty fields are zero.
///
/// Strains act only through the viscous forces, which are linear in the strain rates with a matrix D of the rest state
/// (see viscous_gradient). The strain adjoints are stored without the factor D, i.e. as strains. Then the adjoint of a
/// rate history is the strain_tangent along minus the stage adjoint, and pulling such a field back to the nodes is the
/// viscous_gradient. The dashpots of a creeping body double the strain fields, see creep_adjoint.hpp.
struct KinematicsAdjoint {
    std::array<Eigen::Matrix3Xd, nodal_fields> nodal;   // per NodalField, 3 x n
    std::array<Eigen::VectorXd, strain_fields> strain;  // per StrainField, one entry per strain measure
};

/// Propagates the adjoint of the state backwards through a run and accumulates the gradient.
class AdjointFollower {
public:
    /// @param with_strains  whether the records contain strain rates
    /// @param fibre_points  whether derivatives with respect to shapes and volumes of the fibres are accumulated
    AdjointFollower(const model::Model& model, bool with_strains, bool fibre_points);

    /// Adjoint at the present time. The caller adds the derivatives of the loss to it.
    KinematicsAdjoint& state() { return state_; }

    /// Transposes the recomputation of the force at a jump: from right of the jump to left of it.
    void jump(dynamics::StageSolver& solver, const JumpRecord& at);
    /// From the end of a step to its start. Returns false if a linear solve failed.
    bool step(dynamics::StageSolver& solver, const StepRecord& record);
    /// From the start state to the data that determine it. Returns false if the start equilibrium is singular.
    bool start(dynamics::StageSolver& solver, const dynamics::SimulationOptions& options, const JumpRecord& at);

    /// The accumulated gradient; call once, at the end.
    ModelGradient take();

private:
    /// Initial guess for the linear solves of a stage: the best approximation, in the energy norm, within the span of
    /// the adjoint solutions of the last steps.
    /// Source: Fischer 1998, "Projection techniques for iterative solution of
    /// Ax = b with successive right-hand sides".
    class Guess {
    public:
        /// Energy-optimal guess for H p = b; empty without earlier solutions.
        Eigen::VectorXd next(const solver::SymmetricSparse& H, const Eigen::VectorXd& b) const;
        void add(const Eigen::VectorXd& solution);

    private:
        Eigen::MatrixXd last_;  // one column per solution, latest first
    };
    /// Coefficients of a step, cached because most steps have the same length.
    struct Known {
        dynamics::TimeScheme scheme;
        double h, step_before;
        StepCoefficients plain, by_velocity_force;
    };
    const Known& coefficients(const dynamics::TimeScheme& scheme, double h, double step_before);
    /// Solves H p = load for the adjoint of a stage's constant at its solution x.
    /// @return  p, 3 x n; without columns if the solve failed
    Eigen::Matrix3Xd stage_adjoint(dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                   const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& load, Guess& guess) const;

    struct StepAdjoint;
    /// Contribution of the force rows to the gradient: momenta depend on the masses and Lambda.
    void add_momenta(StepAdjoint& at);
    /// Adjoint of the solution of stage k, collected from all rows that use it, 3 x n.
    /// @param strain_load  adjoint of its strains; empty: none
    Eigen::Matrix3Xd solution_adjoint(const StepAdjoint& at, int k, const Eigen::VectorXd& strain_load) const;
    /// Transposes stage k after the later ones, by the implicit function theorem: the stage adjoint p solves H p =
    /// adjoint of the solution; p is then the adjoint of the stage constant. Returns false if the solve failed.
    bool transpose_stage(dynamics::StageSolver& solver, int k, StepAdjoint& at);

    /// Transposes what a softening body remembers of the positions x at the end of a step or of the start equilibrium.
    /// @param before  peak energies before
    void lower_peaks(const Eigen::VectorXd& before, const Eigen::Matrix3Xd& x);
    /// Adjoint of the forces of the start equilibrium; without columns if the solve failed.
    Eigen::Matrix3Xd equilibrium_adjoint(dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                         const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& load,
                                         const Eigen::VectorXd& peak);

    const model::Model& model_;
    bool with_strains_;  // whether strain adjoints are propagated
    GradientSum gradient_;
    ModelGradient initial_;       // only the start fields are used
    KinematicsAdjoint state_;     // adjoint of the state at the present time
    PeakAdjoint peaks_;           // softening bodies: likewise of the peak energies
    std::vector<Guess> guesses_;  // one per stage of a step
    std::vector<Known> known_;    // cache
};

}  // namespace myo::sensitivity
