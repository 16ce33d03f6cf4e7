#include "effect/effects.hpp"
#include "effect/places.hpp"
#include "model/tied_spring.hpp"

namespace myo {
namespace {

using Eigen::Vector3d;

double body_length(const EffectSite& site) {
    const auto& X = site.body->mesh.nodes;
    return (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).norm();
}

void apply(const EffectSite& site, const EffectParameters& parameters, Affected& affected) {
    const SurfacePlace place = surface_place(*site.body, vector(parameters, "position_m"));
    // Without an anchor the cable leaves the surface at a right angle, longer than the motion.
    Vector3d anchor = place.point + 2.0 * body_length(site) * place.normal;
    if (has(parameters, "anchor_m")) anchor = vector(parameters, "anchor_m");
    if ((anchor - place.point).norm() < 1e-3 * body_length(site)) anchor += 1e-3 * body_length(site) * place.normal;
    affected.model.force_elements.push_back(tied_spring(*site.body, place.cell, place.nodes, place.shares, anchor, number(parameters, "stiffness_N_m")));
}

/// A spring between the anchors in the direction of the strongest pull, k d d' being the best positive part of what the columns add up to.
EffectParameters joined(const std::vector<EffectParameters>& columns, const Eigen::VectorXd& multiples) {
    Eigen::Index best = 0;
    multiples.cwiseAbs().maxCoeff(&best);
    Vector3d along = Vector3d::Zero();
    double total = 0.0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double k = std::max(0.0, multiples(static_cast<Eigen::Index>(i)));
        along += std::sqrt(k) * (vector(columns[i], "anchor_m") - vector(columns[i], "position_m"));
        total += k;
    }
    EffectParameters result = columns[static_cast<std::size_t>(best)];
    const double length = (vector(result, "anchor_m") - vector(result, "position_m")).norm();
    if (total > 0.0) result["anchor_m"] = Eigen::VectorXd(vector(result, "position_m") + length * along.normalized());
    result["stiffness_N_m"] = number(result, "stiffness_N_m") * std::max(total, 0.1);
    return result;
}

std::vector<EffectProbe> probes(const EffectSearch& search) {
    const EffectSite& site = search.sites.front();
    std::vector<EffectProbe> list;
    for (const Vector3d& point : spread_surface_points(site, 4)) {
        EffectProbe probe;
        probe.joined = joined;
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3d place = surface_place(*site.body, point).point;
            probe.columns.push_back({{"stiffness_N_m", 0.2}, {"position_m", Eigen::VectorXd(place)},
                                     {"anchor_m", Eigen::VectorXd(place + body_length(site) * Vector3d::Unit(axis))}});
        }
        list.push_back(std::move(probe));
    }
    return list;
}

}  // namespace

Effect cable_tug() {
    return {"cable_tug", EffectStage::force, "a cable that pulls like a spring from a point of the surface to a fixed anchor",
            {fitted_number("stiffness_N_m", 0.0, 1e4, 1.0, true), {"position_m", EffectParameterKind::vector3, false, -10.0, 10.0, 0.01},
             {"anchor_m", EffectParameterKind::vector3, true, -10.0, 10.0, 0.05}},
            apply, probes};
}

}  // namespace myo
