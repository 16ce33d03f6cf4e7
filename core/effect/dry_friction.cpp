#include "effect/effect.hpp"
#include "effect/places.hpp"
#include "model/point_friction.hpp"

#include <numbers>
#include <optional>

namespace myo::effect {
namespace dry_friction_parts {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct DryFrictionPolicy {
    double v0_m_s = 4e-3;        // of the regularised law, as the vocabulary states it
    double probed_share = 0.01;  // of the body's weight: a probe's force
    std::size_t places = 10;     // on the surface, where a search starts
};
constexpr DryFrictionPolicy dry_friction_policy;

/// Coulomb friction, regularised at v0, at the surface point nearest to the position.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const SurfacePlace place = surface_place(*context.body, vector(parameters, "position_m"));
    const std::optional<Vector3d> normal = has(parameters, "normal") ? std::optional(vector(parameters, "normal"))
                                                                     : std::nullopt;
    affected.model.force_elements.push_back(model::point_friction(*context.body, place.cell, place.nodes, place.shares,
                                                                  normal, number(parameters, "friction_force_N"),
                                                                  dry_friction_policy.v0_m_s));
}

/// Without a normal: the point hardly moves into what it rubs on, so that its whole velocity slides.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const TrialContext& context = search.trials.front();
    const double weight_N = 9.81 * search.models.front().density_kg_m3 * context.body->volume_m3;
    std::vector<EffectProbe> list;
    for (const Vector3d& place : spread_surface_points(context, dry_friction_policy.places))
        list.push_back(
            probe({{"friction_force_N", dry_friction_policy.probed_share * weight_N}, {"position_m", VectorXd(place)}},
                  "friction_force_N"));
    return list;
}

}  // namespace dry_friction_parts

Effect dry_friction() {
    using namespace dry_friction_parts;
    return {.id = "dry_friction",
            .kind = EffectKind::force,
            .summary = "dry friction acts at one point of the surface",
            .parameters = {fitted_number("friction_force_N", 0.0, 100.0, 0.005, true),
                           {"position_m", EffectParameterKind::vector3, false, -10.0, 10.0, 0.01},
                           {"normal", EffectParameterKind::direction, true, -std::numbers::pi, std::numbers::pi, 0.3}},
            .apply = apply,
            .probes = probes,
            .has_corner = true,
            .draw = {.amount = "friction_force_N", .lowest = 2e-4, .highest = 0.5, .others = drawn_position}};
}

}  // namespace myo::effect
