#include <Eigen/Eigenvalues>

#include "effect/effect.hpp"
#include "effect/places.hpp"
#include "model/tied_spring.hpp"

namespace myo::effect {
namespace cable_tug_parts {

using Eigen::Vector3d;

/// Diagonal of the bounding box [m].
double body_length(const TrialContext& context) {
    const auto& X = context.body->mesh.nodes;
    return (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).norm();
}

/// Ties a linear spring between the surface point nearest to the position and the anchor, without tension at rest.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const SurfacePlace place = surface_place(*context.body, vector(parameters, "position_m"));
    // Default anchor: along the surface normal, farther away than any motion of the body.
    Vector3d anchor = place.point + 2.0 * body_length(context) * place.normal;
    if (has(parameters, "anchor_m")) anchor = vector(parameters, "anchor_m");
    // The spring needs a direction: an anchor on the surface is moved off it.
    if ((anchor - place.point).norm() < 1e-3 * body_length(context))
        anchor += 1e-3 * body_length(context) * place.normal;
    affected.model.force_elements.push_back(model::tied_spring(*context.body, place.cell, place.nodes, place.shares,
                                                               anchor, number(parameters, "stiffness_N_m")));
}

struct CableTugPolicy {
    double probed_stiffness_N_m = 0.2;  // of a column; its response is linear
    double min_share = 0.1;  // of it, the smallest start of a fit: a tensor without a positive eigenvalue is no spring
};
constexpr CableTugPolicy cable_tug_policy;

/// To first order a spring of direction d acts by its tensor k d d'. The tensors of these six directions span all
/// symmetric tensors.
std::vector<Vector3d> directions() {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    return {x, y, z, (x + y).normalized(), (y + z).normalized(), (z + x).normalized()};
}

/// From the point of attachment to the anchor of a column [m].
Vector3d span_of(const EffectParameters& column) { return vector(column, "anchor_m") - vector(column, "position_m"); }

/// The spring closest to the sum of the column tensors: largest eigenvalue and its eigenvector. Its anchor lies outside
/// the body, as those of the columns.
EffectParameters joined(const std::vector<EffectParameters>& columns, const Eigen::VectorXd& multiples) {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    Vector3d outwards = Vector3d::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Vector3d d = span_of(columns[i]).normalized();
        tensor += multiples(static_cast<Eigen::Index>(i)) * d * d.transpose();
        outwards += d;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(tensor);
    // Eigenvalues ascend: column 2 is the stiffest direction. The sign of an eigenvector is arbitrary.
    const Vector3d along = eigen.eigenvectors().col(2);
    EffectParameters result = columns.front();
    const double length = span_of(result).norm();
    result["anchor_m"] = Eigen::VectorXd(vector(result, "position_m") +
                                         (along.dot(outwards) < 0.0 ? -length : length) * along);
    result["stiffness_N_m"] = cable_tug_policy.probed_stiffness_N_m *
                              std::max(eigen.eigenvalues()(2), cable_tug_policy.min_share);
    return result;
}

std::vector<EffectProbe> probes(const EffectSearch& search) {
    const TrialContext& context = search.trials.front();
    std::vector<EffectProbe> list;
    // At each of four places the six columns of a tensor; anchors are a diagonal of the bounding box away.
    for (const Vector3d& point : spread_surface_points(context, 4)) {
        EffectProbe probe;
        probe.amount = "stiffness_N_m";
        probe.joined = joined;
        const SurfacePlace place = surface_place(*context.body, point);
        for (const Vector3d& d : directions()) {
            const Vector3d anchor = place.point + (d.dot(place.normal) < 0.0 ? -1.0 : 1.0) * body_length(context) * d;
            probe.columns.push_back({{"stiffness_N_m", cable_tug_policy.probed_stiffness_N_m},
                                     {"position_m", Eigen::VectorXd(place.point)},
                                     {"anchor_m", Eigen::VectorXd(anchor)}});
        }
        list.push_back(std::move(probe));
    }
    return list;
}

/// An anchor outside the body, in any direction.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    const Vector3d at = context.surface_point(random), direction = drawn_direction(random);
    return {{"position_m", Eigen::VectorXd(at)},
            {"anchor_m", Eigen::VectorXd(at + random.uniform(0.7, 1.5) * context.length_m * direction)}};
}

}  // namespace cable_tug_parts

Effect cable_tug() {
    using namespace cable_tug_parts;
    return {.id = "cable_tug",
            .kind = EffectKind::force,
            .summary = "a cable that pulls like a spring from a point of the surface to a fixed anchor",
            .parameters = {fitted_number("stiffness_N_m", 0.0, 1e4, 1.0, true),
                           {"position_m", EffectParameterKind::vector3, false, -10.0, 10.0, 0.01},
                           {"anchor_m", EffectParameterKind::vector3, true, -10.0, 10.0, 0.05}},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = "stiffness_N_m", .lowest = 0.1, .highest = 100.0, .others = drawn}};
}

}  // namespace myo::effect
