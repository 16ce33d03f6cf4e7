#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "effect/effect.hpp"

namespace myo::effect {
namespace gravity_tilt_parts {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;

/// Gravity rotated by tilt_deg about the axis.
Vector3d tilted(const Vector3d& gravity, const EffectParameters& parameters) {
    return Eigen::AngleAxisd(degree * number(parameters, "tilt_deg"), vector(parameters, "axis").normalized()) *
           gravity;
}

/// Turns gravity and nothing else: the mesh frame is that of the mount.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    affected.model.gravity_m_s2 = tilted(affected.model.gravity_m_s2, parameters);
}

/// Small rotations add like vectors.
EffectParameters joined(const std::vector<EffectParameters>& columns, const Eigen::VectorXd& multiples) {
    Vector3d turn = Vector3d::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i)
        turn += multiples(static_cast<Eigen::Index>(i)) * number(columns[i], "tilt_deg") * vector(columns[i], "axis");
    // A zero rotation has no axis: keep a small one about the first axis.
    const Vector3d axis = turn.norm() > 0.0 ? turn.normalized() : vector(columns.front(), "axis");
    return {{"tilt_deg", std::max(turn.norm(), 0.01)}, {"axis", Eigen::VectorXd(axis)}};
}

/// One probe of two columns; none without gravity.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const Vector3d g = search.models.front().gravity_m_s2;
    if (!(g.norm() > 0.0)) return {};
    int least = 0;
    g.cwiseAbs().minCoeff(&least);
    // Two axes perpendicular to gravity span all first-order tilts.
    const Vector3d first = g.cross(Vector3d::Unit(least)).normalized(), second = g.cross(first).normalized();
    EffectProbe probe;
    for (const Vector3d& axis : {first, second})
        probe.columns.push_back({{"tilt_deg", 1.0}, {"axis", Eigen::VectorXd(axis)}});
    probe.joined = joined;
    return {probe};
}

/// The smallest rotation with the same direction of gravity: about an axis perpendicular to it. A component of the axis
/// along gravity has no effect but to enlarge the angle.
EffectParameters canonical(const model::Model& declared, const EffectParameters& parameters) {
    const Vector3d g = declared.gravity_m_s2, turned = tilted(g, parameters), axis = g.cross(turned);
    if (!(axis.norm() > 0.0)) return parameters;
    return {{"tilt_deg", std::atan2(axis.norm(), g.dot(turned)) / degree},
            {"axis", Eigen::VectorXd(axis.normalized())}};
}

/// A horizontal axis, as mounts tilt.
EffectParameters drawn(const DrawContext&, RandomStream& random) {
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    return {{"axis", Eigen::VectorXd(Vector3d(std::cos(angle), std::sin(angle), 0.0))}};
}

/// Angle and axis as one vector: their signs are only determined together.
EffectParameters comparable(const EffectParameters& parameters) {
    return {{"tilt_deg", Eigen::VectorXd(number(parameters, "tilt_deg") * vector(parameters, "axis").normalized())}};
}

}  // namespace gravity_tilt_parts

Effect gravity_tilt() {
    using namespace gravity_tilt_parts;
    return {.id = "gravity_tilt",
            .kind = EffectKind::force,
            .summary = "the mount is tilted: gravity turned by an angle about an axis",
            .parameters = {fitted_number("tilt_deg", -180.0, 180.0, 2.0),
                           {"axis", EffectParameterKind::direction, false, -std::numbers::pi, std::numbers::pi, 0.3}},
            .apply = apply,
            .probes = probes,
            .canonical = canonical,
            .comparable = comparable,
            .draw = {.amount = "tilt_deg", .lowest = 0.5, .highest = 20.0, .others = drawn}};
}

}  // namespace myo::effect
