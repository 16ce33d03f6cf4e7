#pragma once

#include <Eigen/Core>

#include <vector>

#include "base/progress.hpp"
#include "dynamics/stage.hpp"
#include "model/force_element.hpp"
#include "model/internal_forces.hpp"
#include "model/model.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo::dynamics {

/// Data shared by all stages of a model.
struct StageConstants {
    const model::Model* model = nullptr;  // not owned
    std::vector<model::MassSpan> masses;  // the mass changes only between the spans
    std::vector<solver::SymmetricSparse>
        inertia;                 // per span: mass matrix of the free unknowns, in the body's sparsity pattern
    model::Stiffness stiffness;  // of the cells, softening included
};
/// Constants of a model with virgin stiffness. The model must outlive them.
StageConstants stage_constants(const model::Model& model);

/// Node velocities of a stage at x, 3 x n [m/s]; empty if the stage has no velocities.
Eigen::Matrix3Xd stage_velocities(const Stage& stage, const Eigen::Matrix3Xd& x);

/// Arguments of the force elements for a stage at x. `v`: its stage_velocities(); the result keeps references to x and
/// v.
model::ForceState force_state(const Stage& stage, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v);

/// A stage as a minimisation over the free unknowns.
///
/// The residual is the gradient of an incremental potential, so that a line search can measure progress.
class StageProblem {
public:
    /// @param times   accumulates the evaluation times; may be null
    /// @param cancellation  once cancelled, evaluations return NaN at once, which ends any iteration; may be null
    /// References to `constants` and `stage` are kept.
    StageProblem(const StageConstants& constants, const Stage& stage, SolverTimes* times = nullptr,
                 const Progress* cancellation = nullptr);

    /// Potential and derivatives at one x.
    struct Evaluation {
        double potential = 0.0;           // [J], up to a constant
        Eigen::VectorXd residual;         // gradient of the potential [N], free unknowns
        solver::SymmetricSparse hessian;  // [N/m], lower triangle; empty unless requested
    };
    /// Evaluates at x, 3 x n [m].
    ///
    /// @param kind      none, exact, or projected Hessian
    /// @param pressure  of the geometric stiffness, per cell, see InternalInput; null: the current pressure
    Evaluation evaluate(const Eigen::Matrix3Xd& x, model::HessianKind kind,
                        const Eigen::VectorXd* pressure = nullptr) const;

    /// Product of what the stiffness at x has beyond the Hessian with a vector of the free unknowns; see
    /// ForceElement::add_unsymmetric_tangent().
    Eigen::VectorXd unsymmetric_product(const Eigen::Matrix3Xd& x, const Eigen::VectorXd& vector,
                                        model::StiffnessForm form) const;

    const model::Model& model() const { return *constants_.model; }
    const model::BlockPattern& pattern() const { return model().body->pattern; }
    const StageConstants& constants() const { return constants_; }
    const Stage& stage() const { return stage_; }
    /// Mass at Stage::inertia_at_s.
    const model::MassSpan& mass_span() const { return constants_.masses[span_]; }
    const solver::SymmetricSparse& inertia() const {
        return constants_.inertia[span_];
    }  // mass matrix of the free unknowns

    /// Reference force of the relative residual [N]: external loads, inertia at `start`, and forces of fibres and force
    /// elements in the rest shape; at least the rounding error of the forces divided by `tolerance`.
    double force_scale(const Eigen::Matrix3Xd& start, double tolerance) const;

private:
    double rounding_of_forces(const Eigen::Matrix3Xd& x) const;

    const StageConstants& constants_;
    const Stage& stage_;
    SolverTimes* times_;
    const Progress* cancellation_;
    std::size_t span_;                 // index of the mass span
    std::vector<double> activation_;   // per signal, at the time of the stage
    Eigen::VectorXd viscous_history_;  // H of creep.hpp; creeping body only
    Eigen::Matrix3Xd dead_;            // constant + f_ext, 3 x n [N]
};

}  // namespace myo::dynamics
