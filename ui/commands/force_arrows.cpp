#include "commands/force_arrows.hpp"

#include <algorithm>

#include "base/letter_case.hpp"
#include "commands/scene_at_time.hpp"
#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {
namespace {

constexpr double longest_part = 0.3;  // length of the largest force's arrow, as share of the diagonal of the rest shape
constexpr double shortest_part = 0.02;  // shorter arrows, as share of the longest, are left out
constexpr double seen_part = 0.1;       // share of the longest arrow above which forces count as visible
constexpr double translucent = 0.4;     // opacity of the body

/// Centres of the patches, as the mean of their nodes.
Eigen::Matrix3Xd middles(const Eigen::Matrix3Xd& nodes, const Eigen::VectorXi& patch_of_node, int patches) {
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, patches);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(patches);
    for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
        sum.col(patch_of_node(i)) += nodes.col(i);
        count(patch_of_node(i)) += 1.0;
    }
    // A patch without nodes has no centre; it stays at the origin, and no force acts on it.
    return sum * count.cwiseMax(1.0).cwiseInverse().asDiagonal();
}

}  // namespace

const PatchForces* shown_forces(const WorkbenchState& state) {
    const DiagnosisRow* const row = state.diagnosis_row();
    const auto trial = static_cast<std::size_t>(state.trial);
    if (!row || !state.body || trial >= row->force.size() || !row->force[trial]) return nullptr;
    // Patches are lists of nodes, so they belong to the mesh that was diagnosed.
    const bool same_body = same_mesh(state.diagnosis_settings, state.body_settings) &&
                           state.diagnosis->patch_of_node.size() == state.body->mesh.nodes.cols();
    const PatchForces& forces = *row->force[trial];
    return same_body && forces.largest_N > 0.0 ? &forces : nullptr;
}

Eigen::Matrix3Xd force_at_time(const PatchForces& forces, double time_s) {
    const TimePlace place = place_in_time(forces.time_s, time_s);
    if (place.index < 0) return Eigen::Matrix3Xd(3, 0);
    return (1.0 - place.weight) * forces.force_N[static_cast<std::size_t>(place.index)] +
           place.weight * forces.force_N[static_cast<std::size_t>(place.next)];
}

double time_with_forces(const PatchForces& forces, double time_s) {
    const auto largest = [&](Eigen::Index k) {
        return forces.force_N[static_cast<std::size_t>(k)].colwise().norm().maxCoeff();
    };
    // Keep the time if its forces are visible; otherwise go to the largest ones.
    const TimePlace place = place_in_time(forces.time_s, time_s);
    if (place.index >= 0 && largest(place.index) > seen_part * forces.largest_N) return time_s;
    Eigen::Index best = 0;
    for (Eigen::Index k = 1; k < forces.time_s.size(); ++k)
        if (largest(k) > largest(best)) best = k;
    return forces.time_s(best);
}

void add_force_arrows(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const PatchForces* const forces = shown_forces(state);
    if (!state.view.effect_force || !forces || drawn.positions.cols() != state.diagnosis->patch_of_node.size()) return;
    const Eigen::Matrix3Xd now = force_at_time(*forces, state.time_s);
    if (now.cols() == 0) return;
    // The largest force of the trial has the longest arrow.
    const double metres_per_N = longest_part * drawn.extent.size().norm() / forces->largest_N;
    // Arrows start at the drawn positions, so that they move with the body.
    const Eigen::Matrix3Xd from = middles(drawn.positions, state.diagnosis->patch_of_node, state.diagnosis->patches);
    // arrow_points() are 10 per arrow; short arrows are left out.
    Eigen::Matrix3Xd points(3, 10 * from.cols());
    Eigen::Index used = 0;
    for (Eigen::Index p = 0; p < from.cols(); ++p) {
        const Eigen::Vector3d force = now.col(p);
        if (force.norm() > shortest_part * forces->largest_N)
            points.middleCols<10>(used) = viewport::arrow_points(from.col(p), metres_per_N * force), used += 10;
    }
    drawn.lines.push_back({points.leftCols(used), viewport::color_of(theme.force), 2.5});
    const DiagnosisRow& row = *state.diagnosis_row();
    drawn.arrows = viewport::ArrowScale{
        row.kind == DiagnosisRow::Kind::missing_force ? row.name : "Force of " + lower_first(row.name), metres_per_N,
        drawn.lines.back().color};
    drawn.body_opacity = std::min(drawn.body_opacity, translucent);
}

}  // namespace myo::ui::commands
