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

/// What the stages of one model share.
struct StageConstants {
    const model::Model* model = nullptr;
    std::vector<model::MassSpan> masses;
    std::vector<solver::SymmetricSparse>
        inertia;                 // of each span: its mass over the free unknowns, in the body's pattern
    model::Stiffness stiffness;  // of the cells as they are: softened ones have less
};
StageConstants stage_constants(const model::Model& model);

/// Nodal velocities of a stage at x, 3 x n; empty where the stage knows none.
Eigen::Matrix3Xd stage_velocities(const Stage& stage, const Eigen::Matrix3Xd& x);

/// Where the force elements of a stage at x stand; v: its stage_velocities(), which the state refers to.
model::ForceState force_state(const Stage& stage, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v);

/// A stage as a minimisation over the free unknowns.
class StageProblem {
public:
    /// times: where evaluations are entered. heeded: once it is cancelled, evaluations are done at once and not finite,
    /// so that whoever iterates on them ends. Both may be null.
    StageProblem(const StageConstants& constants, const Stage& stage, SolverTimes* times = nullptr,
                 const Progress* heeded = nullptr);

    struct Evaluation {
        double potential = 0.0;           // [J], up to a constant
        Eigen::VectorXd residual;         // its gradient [N]
        solver::SymmetricSparse hessian;  // empty unless asked for
    };
    /// pressure: of the geometric stiffness, see InternalInput; null = the current one.
    Evaluation evaluate(const Eigen::Matrix3Xd& x, model::HessianKind kind,
                        const Eigen::VectorXd* pressure = nullptr) const;

    const model::Model& model() const { return *constants_.model; }
    const model::BlockPattern& pattern() const { return model().body->pattern; }
    const StageConstants& constants() const { return constants_; }
    const Stage& stage() const { return stage_; }
    const model::MassSpan& mass_span() const { return constants_.masses[span_]; }
    const solver::SymmetricSparse& inertia() const { return constants_.inertia[span_]; }  // mass over the free unknowns

    /// The forces that act on the body, its inertia at the start and what its muscles and force elements do to it at
    /// rest among them [N]: what a residual is measured against.
    double force_scale(const Eigen::Matrix3Xd& start, double tolerance) const;

private:
    double rounding_of_forces(const Eigen::Matrix3Xd& x) const;

    const StageConstants& constants_;
    const Stage& stage_;
    SolverTimes* times_;
    const Progress* heeded_;
    std::size_t span_;  // of the masses
    std::vector<double> activation_;
    Eigen::VectorXd viscous_history_;  // of a creeping body
    Eigen::Matrix3Xd dead_;            // constant + f_ext
};

}  // namespace myo::dynamics
