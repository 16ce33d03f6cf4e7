#pragma once

#include <Eigen/Core>

#include <memory>

#include "dynamics/stage.hpp"
#include "dynamics/stage_problem.hpp"
#include "model/model.hpp"

namespace myo::sensitivity {

/// A model on both sides of another along a parameter, by which it may change in any way that leaves the same nodes
/// free.
struct ModelPair {
    model::Model under, over;
    double width = 0.0;  // between them, in units of the parameter
};

/// What a pair says of the model between: derivatives per unit of the parameter, exact where the model is linear in it
/// and otherwise to the square of the width.
struct ModelChange {
    std::shared_ptr<const ModelPair> pair;
    dynamics::StageConstants under, over;
    std::vector<model::MassSpan> masses;  // no entries: they stay
};
ModelChange model_change(std::shared_ptr<const ModelPair> pair);

/// Whether some mass changes; that of a time, too.
bool changes_mass(const ModelChange& change);
inline const model::MassMatrix& mass_change(const ModelChange& change, double at_s) {
    return change.masses[model::span_at(change.masses, at_s)].mass;
}

/// Factors of the elastic moduli at the points from now on, as in StageSolver; empty: virgin ones.
void soften(ModelChange& change, const Eigen::VectorXd& factors);

/// Derivative of a stage's residual over the free unknowns [N per unit] with its positions, its constant, its histories
/// and the softening held.
Eigen::VectorXd held_residual_change(const ModelChange& change, const dynamics::Stage& stage,
                                     const Eigen::Matrix3Xd& x);

/// The same of the strains of a stage's solution, those of dashpots included.
Eigen::VectorXd held_strain_change(const ModelChange& change, const dynamics::Stage& stage, const Eigen::Matrix3Xd& x);

}  // namespace myo::sensitivity
