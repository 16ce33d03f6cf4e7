#include "effect/effect.hpp"
#include "effect/places.hpp"

namespace myo::effect {
namespace point_mass_parts {

/// Attaches the mass to the surface point nearest to the position; it has inertia and weight.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const SurfacePlace place = surface_place(*context.body, vector(parameters, "position_m"));
    Eigen::VectorXd share = Eigen::VectorXd::Zero(context.body->node_count());
    for (std::size_t a = 0; a < place.nodes.size(); ++a)
        share(place.nodes[a]) += place.shares(static_cast<Eigen::Index>(a));
    // The shares distribute the mass to the nodes of the face.
    affected.model.masses.push_back({std::move(share), number(parameters, "mass_kg")});
}

/// Probes of 1 % of the body mass at points spread over the surface.
/// The response to so little is linear in the mass, and the place is found by comparing probes.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const TrialContext& context = search.trials.front();
    const double body_kg = search.models.front().density_kg_m3 * context.body->volume_m3;
    std::vector<EffectProbe> list;
    for (const Eigen::Vector3d& place : spread_surface_points(context, 10))
        list.push_back(probe({{"mass_kg", 0.01 * body_kg}, {"position_m", Eigen::VectorXd(place)}}, "mass_kg"));
    return list;
}

}  // namespace point_mass_parts

Effect point_mass() {
    using namespace point_mass_parts;
    return {.id = "point_mass",
            .kind = EffectKind::force,
            .summary = "an undeclared mass is attached at a point of the surface",
            .parameters = {fitted_number("mass_kg", 0.0, 10.0, 0.002, true),
                           {"position_m", EffectParameterKind::vector3, false, -10.0, 10.0, 0.01}},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = "mass_kg", .lowest = 5e-4, .highest = 0.05, .others = drawn_position}};
}

}  // namespace myo::effect
