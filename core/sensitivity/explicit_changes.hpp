#pragma once

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

#include "dynamics/stage_solver.hpp"
#include "model/force_columns.hpp"
#include "sensitivity/model_change.hpp"
#include "sensitivity/model_tangent.hpp"
#include "sensitivity/softening_tangent.hpp"

namespace myo::sensitivity {

/// What parameters do to the stages of a run other than through the stages' positions: derivatives of residuals,
/// momenta and strains with these held. Columns are parameters. The model and the parameters outlive it.
class ExplicitChanges {
public:
    ExplicitChanges(const model::Model& model, const std::vector<ModelTangent>& parameters);

    /// Derivatives of a stage's residual at x, unknowns x P: along the parameters, and along those of the strain rates,
    /// of the velocities (both may be empty: zero) and of the softening. rates: the strain rates there, those of
    /// dashpots included.
    Eigen::MatrixXd residuals(const dynamics::StageSolver& solver, const dynamics::Stage& stage,
                              const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rates, const Eigen::MatrixXd& d_rates,
                              const model::NodalColumns& d_velocities);

    /// strains += their derivatives at x, of a stage's solution.
    void add_strain_changes(const dynamics::Stage& stage, const Eigen::Matrix3Xd& x, Eigen::MatrixXd& strains) const;

    /// momentum += (dM/dp) (sum of factor times motion of the run itself), M of that time.
    using MotionTerms = std::vector<std::pair<double, const Eigen::Matrix3Xd*>>;
    void add_mass_changes(double at_s, const MotionTerms& motion, model::NodalColumns& momentum) const;
    bool change_masses() const;

    /// Of a body that softens: raises the cells' largest energies to those at x, which moves along dx; afresh: of
    /// virgin cells.
    void soften(const Eigen::Matrix3Xd& x, const model::NodalColumns& dx, bool afresh);

    /// Strains act through viscous forces alone.
    bool with_strains() const { return model_.damping_s > 0.0 || model_.creep; }
    /// Models on both sides, where a parameter has them.
    const ModelPair* pair(std::size_t parameter) const {
        return changes_[parameter] ? changes_[parameter]->pair.get() : nullptr;
    }

private:
    /// Of a creeping body: the change of what viscous stresses are made of, positions held, along the parameters and
    /// the changes of its strain rates (of both, see creep.hpp).
    Eigen::MatrixXd viscous_changes(const dynamics::Stage& stage, const Eigen::VectorXd& rates,
                                    const Eigen::MatrixXd& d_rates) const;
    /// Of dW/dx without what pairs of models tell.
    model::NodalColumns gradient(const dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                 const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rates,
                                 const Eigen::MatrixXd& d_rates, const model::NodalColumns& d_velocities) const;
    void add_force_elements(const dynamics::Stage& stage, const Eigen::Matrix3Xd& x,
                            const model::NodalColumns& d_velocities, model::NodalColumns& result) const;

    const model::Model& model_;
    const std::vector<ModelTangent>& parameters_;
    std::vector<model::Stiffness> stiffness_;          // its derivatives, per parameter
    std::vector<std::optional<ModelChange>> changes_;  // by pairs of models
    std::vector<ModelPair> pairs_;                     // of a body that softens
    PeakTangents peaks_;                               // then
};

}  // namespace myo::sensitivity
