#include <numbers>

#include "effect/effect.hpp"
#include "effect/places.hpp"
#include "model/point_stop.hpp"

namespace myo::effect {
namespace end_stop_parts {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct EndStopPolicy {
    double onset_m = 5e-5;              // over which the spring becomes stiff: below what markers resolve
    double probed_stiffness_N_m = 1.0;  // a soft stop: its response is linear in the stiffness
    std::size_t places = 2;             // on the surface, where a search starts
    double probed_gap = 0.01;           // of the length ahead of the clamp
};
constexpr EndStopPolicy end_stop_policy;

/// Elastic stop at the surface point nearest to the position, see model::point_stop().
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const SurfacePlace place = surface_place(*context.body, vector(parameters, "position_m"));
    affected.model.force_elements.push_back(
        model::point_stop(*context.body, place.cell, place.nodes, place.shares, vector(parameters, "normal"),
                          number(parameters, "gap_m"), number(parameters, "stiffness_N_m"), end_stop_policy.onset_m));
}

/// Stops on all four sides across the body, since which way it moves is not known here.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const TrialContext& context = search.trials.front();
    const ClampAxis axis = clamp_axis(context);
    std::vector<EffectProbe> list;
    for (const Vector3d& place : spread_surface_points(context, end_stop_policy.places))
        // The two axes across the body, and both senses of each.
        for (const int turn : {2, 1})
            for (const double sign : {1.0, -1.0})
                list.push_back(probe({{"stiffness_N_m", end_stop_policy.probed_stiffness_N_m},
                                      {"gap_m", end_stop_policy.probed_gap * axis.length_m},
                                      {"normal", VectorXd(sign * Vector3d::Unit((axis.axis + turn) % 3))},
                                      {"position_m", VectorXd(place)}},
                                     "stiffness_N_m"));
    return list;
}

/// A stop below the body, which a fall reaches.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    EffectParameters parameters = drawn_position(context, random);
    parameters["normal"] = VectorXd(Vector3d::UnitZ());
    parameters["gap_m"] = random.uniform(0.005, 0.03) * context.length_m;
    return parameters;
}

}  // namespace end_stop_parts

Effect end_stop() {
    using namespace end_stop_parts;
    return {.id = "end_stop",
            .kind = EffectKind::force,
            .summary = "a surface point meets an elastic stop once it has moved by a gap",
            .parameters = {fitted_number("stiffness_N_m", 0.0, 1e5, 10.0, true),
                           fitted_number("gap_m", 0.0, 1.0, 2e-3),
                           {"position_m", EffectParameterKind::vector3, false, -10.0, 10.0, 0.01},
                           {"normal", EffectParameterKind::direction, false, -std::numbers::pi, std::numbers::pi, 0.3}},
            .apply = apply,
            .probes = probes,
            .has_corner = true,
            .draw = {.amount = "stiffness_N_m", .lowest = 2.0, .highest = 1e3, .others = drawn}};
}

}  // namespace myo::effect
