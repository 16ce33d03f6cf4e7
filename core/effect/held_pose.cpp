#include "effect/effects.hpp"
#include "effect/places.hpp"

namespace myo {
namespace {

using Eigen::Vector3d;

constexpr const char* offset = "offset_m";

/// Bent like a cantilever by a force at its end: the end is off by `offset`. A size alone goes against gravity, as hands lift.
void apply(const EffectSite& site, const EffectParameters& parameters, Affected& affected) {
    if (site.start != StartKind::straight) return;
    const ClampAxis clamp = clamp_axis(site);
    const Vector3d up = affected.model.gravity_m_s2.norm() > 0.0 ? Vector3d(-affected.model.gravity_m_s2.normalized()) : Vector3d(Vector3d::UnitZ());
    Vector3d end = Vector3d::Zero();
    if (std::holds_alternative<Eigen::VectorXd>(parameters.at(offset))) end = vector(parameters, offset);
    else end = number(parameters, offset) * up;
    Eigen::Matrix3Xd x = affected.options.initial.positions.size() > 0 ? affected.options.initial.positions : affected.model.body->mesh.nodes;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
        const double s = clamp.ahead(site.body->mesh.nodes.col(i)) / clamp.length_m;
        if (s > 0.0) x.col(i) += 0.5 * s * s * (3.0 - s) * end;
    }
    affected.options.initial.positions = std::move(x);
}

EffectParameters joined(const std::vector<EffectParameters>& columns, const Eigen::VectorXd& multiples) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i) sum += multiples(static_cast<Eigen::Index>(i)) * vector(columns[i], offset);
    EffectParameters result = columns.front();
    result[offset] = Eigen::VectorXd(sum);
    return result;
}

std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    for (const EffectSite& site : search.sites) {
        if (site.start != StartKind::straight) continue;
        EffectProbe probe;
        const int along = clamp_axis(site).axis;
        for (int axis = 0; axis < 3; ++axis)
            if (axis != along) probe.columns.push_back({{offset, Eigen::VectorXd(1e-3 * Vector3d::Unit(axis))}, {"trial", site.trial}});
        probe.joined = joined;
        list.push_back(std::move(probe));
    }
    return list;
}

}  // namespace

Effect held_pose() {
    return {"held_pose", EffectStage::support, "the body was not held in its rest shape before the release",
            {{offset, EffectParameterKind::number_or_vector3, false, -1.0, 1.0, 2e-3}, {"trial", EffectParameterKind::trial, true}}, apply, probes};
}

}  // namespace myo
