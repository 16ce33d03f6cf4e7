#include "sensitivity/model_change.hpp"

#include <algorithm>
#include <utility>

#include "dynamics/creep.hpp"
#include "dynamics/start_state.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

using Sparse = Eigen::SparseMatrix<double>;

Sparse difference(const Sparse& over, const Sparse& under, double width) {
    Sparse result;
    if (over.size() == 0 && under.size() == 0) return result;
    if (under.size() == 0) result = over / width;
    else if (over.size() == 0) result = -under / width;
    else result = (over - under) / width;
    result.prune(0.0);
    return result;
}

/// Of each span in which neither of the two begins or ends.
std::vector<MassSpan> differences(const std::vector<MassSpan>& over, const std::vector<MassSpan>& under, double width) {
    std::vector<MassSpan> result;
    for (std::size_t o = 0, u = 0; o < over.size() && u < under.size();) {
        const double until_s = std::min(over[o].until_s, under[u].until_s);
        result.push_back({until_s,
                          mass_matrix(difference(over[o].mass.isotropic, under[u].mass.isotropic, width),
                                      difference(over[o].mass.directional, under[u].mass.directional, width))});
        o += over[o].until_s == until_s ? 1 : 0;
        u += under[u].until_s == until_s ? 1 : 0;
    }
    return result;
}

VectorXd stage_strains(const Model& model, const Stage& stage, const Matrix3Xd& x) {
    VectorXd result = strains(model, held_by(*model.body, x));
    if (model.creep) result = with_dashpots(*model.creep, stage.rate_factor_1_s, result, stage.rate_history);
    return result;
}

}  // namespace

ModelChange model_change(std::shared_ptr<const ModelPair> pair) {
    ModelChange change{std::move(pair), {}, {}, {}};
    const Model &under = change.pair->under, &over = change.pair->over;
    const double width = change.pair->width;
    change.under = stage_constants(under);
    change.over = stage_constants(over);
    change.masses = differences(change.over.masses, change.under.masses, width);
    return change;
}

bool changes_mass(const ModelChange& change) {
    return std::any_of(change.masses.begin(), change.masses.end(), [](const MassSpan& span) {
        return span.mass.isotropic.nonZeros() > 0 || span.mass.directional.nonZeros() > 0;
    });
}

void soften(ModelChange& change, const VectorXd& factors) {
    for (StageConstants* side : {&change.under, &change.over})
        side->stiffness.elastic_factors = times_factors(side->model->point_factors, factors);
}

VectorXd held_residual_change(const ModelChange& change, const Stage& stage, const Matrix3Xd& x) {
    const auto residual = [&](const StageConstants& side) {
        const Matrix3Xd held = held_by(*side.model->body, x);
        if (held == x) return StageProblem(side, stage).evaluate(x, HessianKind::none).residual;
        // A clamp that stands elsewhere has stood there all the time.
        Stage standing = stage;
        standing.constant +=
            stage.inertia_1_s2 * times_mass(held - x, side.masses[span_at(side.masses, stage.inertia_at_s)].mass);
        if (standing.velocity_history.size() > 0) standing.velocity_history -= stage.rate_factor_1_s * (held - x);
        return StageProblem(side, standing).evaluate(held, HessianKind::none).residual;
    };
    return (residual(change.over) - residual(change.under)) / change.pair->width;
}

VectorXd held_strain_change(const ModelChange& change, const Stage& stage, const Matrix3Xd& x) {
    return (stage_strains(change.pair->over, stage, x) - stage_strains(change.pair->under, stage, x)) / change.pair->width;
}

}  // namespace myo
