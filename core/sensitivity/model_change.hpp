#pragma once

#include <Eigen/Core>

#include <memory>

#include "dynamics/stage.hpp"
#include "dynamics/stage_problem.hpp"
#include "model/model.hpp"

namespace myo::sensitivity {

/// Two models on both sides of a third along a parameter. They may differ in any way that keeps the same nodes free.
struct ModelPair {
    model::Model under, over;
    double width = 0.0;  // parameter difference over - under, in units of the parameter
};

/// Central differences from a pair of models: derivatives per unit of the parameter. Exact where the model is linear in
/// the parameter, otherwise with an error of the order of width squared.
struct ModelChange {
    std::shared_ptr<const ModelPair> pair;
    dynamics::StageConstants under, over;  // constants of both models; only masses if `same_cells`
    std::vector<model::MassSpan> masses;   // difference quotient of the mass; no entries: the mass is constant
    /// The cells deform alike under both models, which differ in loads, commands, force elements and masses only: their
    /// forces cancel and are not evaluated.
    bool same_cells = false;
};
/// Prepares the differences of a pair.
ModelChange model_change(std::shared_ptr<const ModelPair> pair);

/// Whether the mass matrix changes, including masses that exist for part of the time only.
bool changes_mass(const ModelChange& change);
/// Derivative of the mass matrix at an instant [kg per unit].
inline const model::MassMatrix& mass_change(const ModelChange& change, double at_s) {
    return change.masses[model::span_at(change.masses, at_s)].mass;
}

/// Sets the softening factors of the elastic moduli in both models, as StageSolver::soften() does; empty: virgin.
void soften(ModelChange& change, const Eigen::VectorXd& factors);

/// Derivative of the residual of a stage over the free unknowns [N per unit]. Positions of free nodes, constant,
/// histories and softening factors are held.
Eigen::VectorXd held_residual_change(const ModelChange& change, const dynamics::Stage& stage,
                                     const Eigen::Matrix3Xd& x);

/// Derivative of the strains of a stage solution at fixed x, dashpots included; zero if the cells are alike.
Eigen::VectorXd held_strain_change(const ModelChange& change, const dynamics::Stage& stage, const Eigen::Matrix3Xd& x);

}  // namespace myo::sensitivity
