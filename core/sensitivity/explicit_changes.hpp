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

/// Explicit dependence of the stages of a run on parameters: derivatives of residuals, momenta and strains with the
/// positions held fixed. One column per parameter. The model and the parameters must outlive the object.
class ExplicitChanges {
public:
    ExplicitChanges(const model::Model& model, const std::vector<ModelTangent>& parameters);

    /// Derivatives of the residual of a stage at x with x held, unknowns x P [N per unit].
    ///
    /// They contain the parameters themselves and the changes of strain rates, velocities and softening factors.
    /// @param rates         strain rates at x, dashpots included [1/s]
    /// @param d_rates       their derivatives, one column per parameter; empty: zero
    /// @param d_velocities  derivatives of the stage velocities; empty: zero
    Eigen::MatrixXd residuals(const dynamics::StageSolver& solver, const dynamics::Stage& stage,
                              const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rates, const Eigen::MatrixXd& d_rates,
                              const model::NodalColumns& d_velocities);

    /// Adds to `strains` their derivatives at fixed x, for the solution x of a stage.
    void add_strain_changes(const dynamics::Stage& stage, const Eigen::Matrix3Xd& x, Eigen::MatrixXd& strains) const;

    /// Adds dM/dp u to `momentum`, M at `at_s`, u = sum of factor times motion field of the run itself.
    using MotionTerms = std::vector<std::pair<double, const Eigen::Matrix3Xd*>>;
    /// The sum u is the same for all parameters; only dM/dp differs.
    void add_mass_changes(double at_s, const MotionTerms& motion, model::NodalColumns& momentum) const;
    /// Whether the mass matrix depends on any parameter.
    bool change_masses() const;

    /// Softening bodies: updates the peak energies with those at x, whose derivatives are dx.
    ///
    /// @param afresh  discard earlier peaks (virgin cells)
    void soften(const Eigen::Matrix3Xd& x, const model::NodalColumns& dx, bool afresh);

    /// Whether strains are needed: they act only through viscous forces.
    bool with_strains() const { return model::is_viscous(model_) || model_.creep; }
    /// Models on both sides of a parameter; null if the parameter has none.
    const ModelPair* pair(std::size_t parameter) const {
        return changes_[parameter] ? changes_[parameter]->pair.get() : nullptr;
    }

private:
    /// Creeping body: derivative of the effective viscous rate (see creep.hpp) at fixed positions, along the parameters
    /// and the changes of the strain rates of body and dashpots.
    Eigen::MatrixXd viscous_changes(const dynamics::Stage& stage, const Eigen::VectorXd& rates,
                                    const Eigen::MatrixXd& d_rates) const;
    /// Derivatives of dW/dx, except what is computed from pairs of models.
    model::NodalColumns gradient(const dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                 const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rates,
                                 const Eigen::MatrixXd& d_rates, const model::NodalColumns& d_velocities) const;
    /// Adds the changes along parameters of the constitutive law.
    void add_law_changes(const Eigen::VectorXd& softening, const Eigen::Matrix3Xd& x,
                         model::NodalColumns& result) const;
    void add_force_elements(const dynamics::Stage& stage, const Eigen::Matrix3Xd& x,
                            const model::NodalColumns& d_velocities, model::NodalColumns& result) const;

    const model::Model& model_;
    const std::vector<ModelTangent>& parameters_;
    std::vector<model::Stiffness> stiffness_;          // derivative of the stiffness, per parameter
    std::vector<std::optional<ModelChange>> changes_;  // per parameter; only those given by a pair of models
    std::vector<ModelPair> pairs_;                     // softening body only, per parameter
    PeakTangents peaks_;                               // softening body only
};

}  // namespace myo::sensitivity
