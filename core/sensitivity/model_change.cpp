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

}  // namespace

ModelChange model_change(std::shared_ptr<const ModelPair> pair) {
    ModelChange change{std::move(pair), {}, {}, {}};
    const model::Model &under = change.pair->under, &over = change.pair->over;
    const double width = change.pair->width;
    change.under = dynamics::stage_constants(under);
    change.over = dynamics::stage_constants(over);
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
