#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "sensitivity/model_gradient.hpp"
#include "sensitivity/run_tape.hpp"
#include "sensitivity/step_coefficients.hpp"

namespace myo::sensitivity {

/// Derivative of a loss with respect to the Kinematics at some time. Empty fields are zero.
///
/// Strains act through the viscous forces alone, which are linear in the rates by a matrix D of the rest state (see
/// viscous_gradient): their adjoints are kept without D, as strains. The adjoint of a rate history is then the
/// strain_tangent along minus the stage's own adjoint, and the pull-back of such a field to the nodes its
/// viscous_gradient.
struct KinematicsAdjoint {
    std::array<Eigen::Matrix3Xd, nodal_fields> nodal;
    std::array<Eigen::VectorXd, strain_fields> strain;
};

/// Takes adjoints of the state backwards through a run and gathers the gradient on the way.
class AdjointFollower {
public:
    /// with_strains: the records know the rates of strain.
    AdjointFollower(const model::Model& model, bool with_strains, bool fibre_shapes);

    KinematicsAdjoint& state() { return state_; }

    /// From right of a jump to left of it.
    void jump(dynamics::StageSolver& solver, const JumpRecord& at);
    /// From the end of a step to its start. False: a linear solve failed.
    bool step(dynamics::StageSolver& solver, const StepRecord& record);
    /// From the start to what determines it. False: its equilibrium has no derivative.
    bool start(dynamics::StageSolver& solver, const dynamics::SimulationOptions& options,
               const dynamics::Kinematics& at);

    ModelGradient take();

private:
    /// Where to start a stage's linear solves: the solution's best approximation, in energy, by its adjoints of the
    /// last steps. Source: Fischer 1998, "Projection techniques for iterative solution of Ax = b with successive
    /// right-hand sides".
    class Guess {
    public:
        Eigen::VectorXd next(const solver::SymmetricSparse& H, const Eigen::VectorXd& b) const;
        void add(const Eigen::VectorXd& solution);

    private:
        Eigen::MatrixXd last_;  // columns, the latest first
    };
    struct Known {
        dynamics::TimeScheme scheme;
        double h, step_before;
        StepCoefficients plain, by_velocity_force;
    };
    const Known& coefficients(const dynamics::TimeScheme& scheme, double h, double step_before);

    const model::Model& model_;
    bool with_strains_;
    GradientSum gradient_;
    ModelGradient initial_;
    KinematicsAdjoint state_;
    std::vector<Guess> guesses_;
    std::vector<Known> known_;
};

}  // namespace myo::sensitivity
