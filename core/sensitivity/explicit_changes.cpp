#include "sensitivity/explicit_changes.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/creep.hpp"
#include "sensitivity/tangent_columns.hpp"

namespace myo::sensitivity {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Models on both sides along the moduli or the law of a parameter. To first order only these change the energy of a
/// cell at given positions. The width is 1e-3 of the largest relative change of mu, or of the scale of a law's
/// parameter.
ModelPair pair_along(const model::Model& model, const ModelTangent& parameter) {
    ModelPair pair{model, model, 1.0};
    if (parameter.law) {
        const std::size_t k = *parameter.law;
        std::vector<double> over = model.material->values(), under = over;
        pair.width = 1e-3 * model.material->parameters()[k].scale;
        over[k] += 0.5 * pair.width;
        under[k] -= 0.5 * pair.width;
        pair.over.material = model.material->with_values(over);
        pair.under.material = model.material->with_values(under);
        return pair;
    }
    if (parameter.moduli.empty()) return pair;
    double most = 0.0;
    for (std::size_t c = 0; c < model.moduli.size(); ++c)
        // Relative change of mu per unit of the parameter; without any the pair is two equal models.
        most = std::max(most, std::abs(parameter.moduli[c].mu / model.moduli[c].mu));
    if (most > 0.0) pair.width = 1e-3 / most;
    // Derivatives hold the ratio that sets the bending of cells, see Model::poissons_ratio.
    if (model.poissons_ratio.empty())
        pair.over.poissons_ratio = pair.under.poissons_ratio = model::poissons_ratios(model.moduli);
    for (std::size_t c = 0; c < model.moduli.size(); ++c) {
        pair.over.moduli[c].mu += 0.5 * pair.width * parameter.moduli[c].mu;
        pair.under.moduli[c].mu -= 0.5 * pair.width * parameter.moduli[c].mu;
    }
    return pair;
}

}  // namespace

ExplicitChanges::ExplicitChanges(const model::Model& model, const std::vector<ModelTangent>& parameters)
    : model_(model), parameters_(parameters) {
    for (const ModelTangent& parameter : parameters) {
        // The forces of a changed law are no combination of those for unit moduli; see add_law_changes().
        stiffness_.push_back(parameter.law ? model::Stiffness{} : stiffness_tangent(model, parameter));
        changes_.emplace_back();
        if (parameter.between) changes_.back().emplace(model_change(parameter.between));
        if (model.softening) pairs_.push_back(parameter.between ? *parameter.between : pair_along(model, parameter));
    }
}

bool ExplicitChanges::change_masses() const {
    return std::any_of(changes_.begin(), changes_.end(),
                       [](const auto& change) { return change && changes_mass(*change); });
}

void ExplicitChanges::soften(const Matrix3Xd& x, const model::NodalColumns& dx, bool afresh) {
    if (!model_.softening) return;
    if (afresh) peaks_ = {};
    raise_peaks(model_, x, dx, pairs_, peaks_);
}

void ExplicitChanges::add_mass_changes(double at_s, const MotionTerms& motion, model::NodalColumns& momentum) const {
    Matrix3Xd sum;
    for (std::size_t p = 0; p < changes_.size(); ++p) {
        if (!changes_[p] || !changes_mass(*changes_[p])) continue;
        // The motion is the same for all parameters: summed once, when needed.
        if (sum.size() == 0) {
            sum = Matrix3Xd::Zero(3, model_.body->node_count());
            for (const auto& [factor, field] : motion)
                if (factor != 0.0 && field->size() > 0) sum += factor * *field;
        }
        if (momentum.size() == 0)
            momentum = model::NodalColumns::Zero(3 * static_cast<Index>(parameters_.size()), model_.body->node_count());
        model::nodal_column(momentum, static_cast<Index>(p)) += model::times_mass(sum, mass_change(*changes_[p], at_s));
    }
}

void ExplicitChanges::add_strain_changes(const dynamics::Stage& stage, const Matrix3Xd& x, MatrixXd& strains) const {
    for (std::size_t p = 0; p < changes_.size(); ++p)
        if (changes_[p] && !changes_[p]->same_cells)
            strains.col(static_cast<Index>(p)) += held_strain_change(*changes_[p], stage, x);
}

MatrixXd ExplicitChanges::viscous_changes(const dynamics::Stage& stage, const VectorXd& rates,
                                          const MatrixXd& d_rates) const {
    const Index count = rates.size() / 2;
    MatrixXd result = d_rates.size() > 0 ? dynamics::viscous_history(model_, stage.rate_factor_1_s, d_rates)
                                         // Effective rate damping dE/dt + ...: explicit dependence on the damping time.
                                         : MatrixXd::Zero(count, static_cast<Index>(parameters_.size()));
    for (std::size_t p = 0; p < parameters_.size(); ++p)
        if (parameters_[p].damping_s != 0.0)
            result.col(static_cast<Index>(p)) += parameters_[p].damping_s * rates.head(count);
    return result;
}

MatrixXd ExplicitChanges::residuals(const dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                    const Matrix3Xd& x, const VectorXd& rates, const MatrixXd& d_rates,
                                    const model::NodalColumns& d_velocities) {
    MatrixXd result = gather_columns(model_.body->pattern, gradient(solver, stage, x, rates, d_rates, d_velocities));
    for (std::size_t p = 0; p < changes_.size(); ++p) {
        if (!changes_[p]) continue;
        // Pairs of models are evaluated with the softening of the run, which is held here.
        myo::sensitivity::soften(*changes_[p], solver.softening());
        result.col(static_cast<Index>(p)) += held_residual_change(*changes_[p], stage, x);
    }
    return result;
}

model::NodalColumns ExplicitChanges::gradient(const dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                              const Matrix3Xd& x, const VectorXd& rates, const MatrixXd& d_rates,
                                              const model::NodalColumns& d_velocities) const {
    bool elastic = false, viscous = false;
    for (const model::Stiffness& s : stiffness_) {
        elastic = elastic || !s.elastic.empty();
        viscous = viscous || !s.viscous.empty();
    }
    // Forces per unit modulus at x are computed once and combined for each parameter.
    model::UnitForces forces;
    if (elastic || viscous)
        forces = model::unit_forces(model_, x, solver.softening(),
                                    !viscous       ? VectorXd()
                                    : model_.creep ? VectorXd(dynamics::viscous_history(model_, 0.0, rates))
                                                   : rates);
    const MatrixXd changes = model_.creep     ? viscous_changes(stage, rates, d_rates)
                             : with_strains() ? d_rates
                                              : MatrixXd();
    // Softening factors depend on parameters through the peak energies.
    const MatrixXd d_factors = solver.softening().size() > 0 ? factor_tangents(*model_.softening, pairs_, peaks_)
                                                             : MatrixXd();
    model::NodalColumns result = model::gradient_columns(model_, x, forces, {stiffness_, changes, d_factors});
    for (std::size_t g = 0; g < model_.fibres->size(); ++g) {
        Matrix3Xd of_group;  // per unit of the group's activation
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            const std::vector<double> d = activation_tangent(parameters_[p], stage.time_s, stage.before_jump);
            if (d.empty() || d[g] == 0.0) continue;
            if (of_group.size() == 0) {
                // The energy is linear in the activation: the gradient at unit activation is evaluated once per group.
                std::vector<double> unit(model_.fibres->size(), 0.0);
                unit[g] = 1.0;
                of_group = model::activation_gradient(model_, x, unit);
            }
            model::nodal_column(result, static_cast<Index>(p)) += d[g] * of_group;
        }
    }
    add_law_changes(solver.softening(), x, result);
    if (!model_.force_elements.empty()) add_force_elements(stage, x, d_velocities, result);
    return result;
}

void ExplicitChanges::add_law_changes(const VectorXd& softening, const Matrix3Xd& x,
                                      model::NodalColumns& result) const {
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
        if (!parameters_[p].law) continue;
        model::Stiffness changed = stiffness_tangent(model_, parameters_[p]);
        changed.elastic_factors = model::times_factors(changed.elastic_factors, softening);
        model::nodal_column(result, static_cast<Index>(p)) += model::internal_energy(model_, x,
                                                                                     {&changed, nullptr, {}, nullptr},
                                                                                     model::HessianKind::none)
                                                                  .gradient;
    }
}

void ExplicitChanges::add_force_elements(const dynamics::Stage& stage, const Matrix3Xd& x,
                                         const model::NodalColumns& d_velocities, model::NodalColumns& result) const {
    const Matrix3Xd v = dynamics::stage_velocities(stage, x);
    const model::ForceState at = dynamics::force_state(stage, x, v);
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
        auto column = model::nodal_column(result, static_cast<Index>(p));
        column += force_element_tangent(model_, parameters_[p], at);
        if (d_velocities.size() > 0)
            column += model::velocity_tangent(model_, at, model::nodal_column(d_velocities, static_cast<Index>(p)));
    }
}

}  // namespace myo::sensitivity
