#include "sensitivity/model_change.hpp"

#include <algorithm>
#include <utility>

#include "dynamics/creep.hpp"
#include "dynamics/start_state.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

using Sparse = Eigen::SparseMatrix<double>;

/// (over - under) / width; a matrix of size zero counts as zero. Zero entries are removed so that nonZeros() shows
/// whether anything changes.
Sparse difference(const Sparse& over, const Sparse& under, double width) {
    Sparse result;
    if (over.size() == 0 && under.size() == 0) return result;
    if (under.size() == 0)
        result = over / width;
    else if (over.size() == 0)
        result = -under / width;
    else
        result = (over - under) / width;
    result.prune(0.0);
    return result;
}

/// Difference quotients of the mass on the common refinement of both lists of spans.
std::vector<model::MassSpan> differences(const std::vector<model::MassSpan>& over,
                                         const std::vector<model::MassSpan>& under, double width) {
    std::vector<model::MassSpan> result;
    for (std::size_t o = 0, u = 0; o < over.size() && u < under.size();) {
        // The next boundary of either list ends a span of the refinement.
        const double until_s = std::min(over[o].until_s, under[u].until_s);
        result.push_back(
            {until_s, model::mass_matrix(difference(over[o].mass.isotropic, under[u].mass.isotropic, width),
                                         difference(over[o].mass.directional, under[u].mass.directional, width))});
        o += over[o].until_s == until_s ? 1 : 0;
        u += under[u].until_s == until_s ? 1 : 0;
    }
    return result;
}

/// Strains at x with the clamped nodes of this model, dashpots included.
VectorXd stage_strains(const model::Model& model, const dynamics::Stage& stage, const Matrix3Xd& x) {
    VectorXd result = model::strains(model, dynamics::held_by(*model.body, x));
    if (model.creep) result = dynamics::with_dashpots(*model.creep, stage.rate_factor_1_s, result, stage.rate_history);
    return result;
}

/// Whether a deformed cell has the same strains, stresses and memory under both models.
bool cells_alike(const model::Model& a, const model::Model& b) {
    const auto same_vector = [](const VectorXd& u, const VectorXd& v) { return u.size() == v.size() && u == v; };
    return a.body == b.body && a.material == b.material && a.moduli == b.moduli &&
           same_vector(a.point_factors, b.point_factors) && a.poissons_ratio == b.poissons_ratio &&
           a.damping_s == b.damping_s && a.damping_excess_s == b.damping_excess_s && a.fibres == b.fibres &&
           a.creep == b.creep && a.softening == b.softening;
}

/// Gradient of the force elements of a model that another one does not have.
Matrix3Xd gradient_of_own_elements(const model::Model& model, const model::Model& other, const model::ForceState& at) {
    model::InternalEnergy sum;
    sum.gradient = Matrix3Xd::Zero(3, at.x.cols());
    const auto& others = other.force_elements;
    for (const model::ForceElementPointer& element : model.force_elements)
        if (std::find(others.begin(), others.end(), element) == others.end())
            element->add(*model.body, at, model::HessianKind::none, sum);
    return sum.gradient;
}

/// Residual over minus under for models whose cells are alike, not divided by the width.
VectorXd load_change(const ModelChange& change, const dynamics::Stage& stage, const Matrix3Xd& x) {
    const model::Model &under = change.pair->under, &over = change.pair->over;
    const bool by_velocity = model::depends_on_velocity(under) || model::depends_on_velocity(over);
    const Matrix3Xd v = by_velocity ? dynamics::stage_velocities(stage, x) : Matrix3Xd();
    const model::ForceState at = dynamics::force_state(stage, x, v);
    Matrix3Xd gradient = gradient_of_own_elements(over, under, at) - gradient_of_own_elements(under, over, at);
    std::vector<double> activation = model::activations(over, stage.time_s, stage.before_jump);
    const std::vector<double> before = model::activations(under, stage.time_s, stage.before_jump);
    for (std::size_t g = 0; g < activation.size(); ++g) activation[g] -= before[g];
    // The energy of fibres is linear in their activation.
    if (std::any_of(activation.begin(), activation.end(), [](double a) { return a != 0.0; }))
        gradient += model::activation_gradient(over, x, activation);
    const auto dead = [&](const dynamics::StageConstants& side) {
        return model::external_forces(*side.model, side.masses[model::span_at(side.masses, stage.inertia_at_s)].mass,
                                      stage.time_s, stage.before_jump);
    };
    gradient -= dead(change.over) - dead(change.under);
    if (stage.inertia_1_s2 != 0.0 && changes_mass(change))
        gradient += change.pair->width * stage.inertia_1_s2 *
                    model::times_mass(x, mass_change(change, stage.inertia_at_s));
    return model::gather(over.body->pattern, gradient);
}

}  // namespace

ModelChange model_change(std::shared_ptr<const ModelPair> pair) {
    ModelChange change{std::move(pair), {}, {}, {}, false};
    const model::Model &under = change.pair->under, &over = change.pair->over;
    const double width = change.pair->width;
    change.same_cells = cells_alike(under, over);
    // Stiffness and inertia in the pattern of the stiffness, many times as large as the masses, serve whole residuals.
    const auto constants = [&](const model::Model& model) {
        return change.same_cells ? dynamics::StageConstants{&model, model::mass_spans(model), {}, {}}
                                 : dynamics::stage_constants(model);
    };
    change.under = constants(under);
    change.over = constants(over);
    change.masses = differences(change.over.masses, change.under.masses, width);
    return change;
}

bool changes_mass(const ModelChange& change) {
    return std::any_of(change.masses.begin(), change.masses.end(), [](const model::MassSpan& span) {
        return span.mass.isotropic.nonZeros() > 0 || span.mass.directional.nonZeros() > 0;
    });
}

void soften(ModelChange& change, const VectorXd& factors) {
    for (dynamics::StageConstants* side : {&change.under, &change.over})
        side->stiffness.elastic_factors = model::times_factors(side->model->point_factors, factors);
}

VectorXd held_residual_change(const ModelChange& change, const dynamics::Stage& stage, const Matrix3Xd& x) {
    if (change.same_cells) return load_change(change, stage, x) / change.pair->width;
    const auto residual = [&](const dynamics::StageConstants& side) {
        const Matrix3Xd held = dynamics::held_by(*side.model->body, x);
        if (held == x) return dynamics::StageProblem(side, stage).evaluate(x, model::HessianKind::none).residual;
        // The clamped nodes differ between the models. A displaced clamp is treated as having been there all the time:
        // its inertia and velocity terms are shifted, so that the displacement causes no velocity.
        dynamics::Stage standing = stage;
        standing.constant += stage.inertia_1_s2 *
                             model::times_mass(held - x,
                                               side.masses[model::span_at(side.masses, stage.inertia_at_s)].mass);
        if (standing.velocity_history.size() > 0) standing.velocity_history -= stage.rate_factor_1_s * (held - x);
        return dynamics::StageProblem(side, standing).evaluate(held, model::HessianKind::none).residual;
    };
    return (residual(change.over) - residual(change.under)) / change.pair->width;
}

VectorXd held_strain_change(const ModelChange& change, const dynamics::Stage& stage, const Matrix3Xd& x) {
    return (stage_strains(change.pair->over, stage, x) - stage_strains(change.pair->under, stage, x)) /
           change.pair->width;
}

}  // namespace myo::sensitivity
