#include <cmath>

#include "effect/effect.hpp"
#include "effect/places.hpp"
#include "effect/point_stiffness.hpp"

namespace myo::effect {
namespace soft_patch_parts {

/// Modulus factor 1 + r exp(-d² / (2 R²)) with the distance d from the centre.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const Eigen::Vector3d centre = vector(parameters, "centre_m");
    const double r = number(parameters, "relative_change"), R = number(parameters, "radius_m");
    scale_stiffness(
        context,
        [&](const Eigen::Vector3d& at) { return 1.0 + r * std::exp(-(at - centre).squaredNorm() / (2.0 * R * R)); },
        affected);
}

/// Patches of 0.3 body sizes at nine cells spread over the body.
/// Wide patches: narrow ones between the chosen centres would be overlooked.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const TrialContext& context = search.trials.front();
    const double size = std::cbrt(context.body->volume_m3);
    std::vector<EffectProbe> list;
    for (const Eigen::Vector3d& centre : spread_cells(context, 9))
        list.push_back(
            probe({{"relative_change", -0.1}, {"centre_m", Eigen::VectorXd(centre)}, {"radius_m", 0.3 * size}},
                  "relative_change"));
    return list;
}

/// A sphere on the axis of the body, with a radius below its thickness.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    Eigen::Vector3d centre = context.middle_m;
    centre.x() = context.held_m + random.uniform(0.1, 0.7) * (context.length_m - context.held_m);
    return {{"centre_m", Eigen::VectorXd(centre)}, {"radius_m", random.uniform(0.35, 0.8) * context.thickness_m}};
}

}  // namespace soft_patch_parts

Effect soft_patch() {
    using namespace soft_patch_parts;
    // Above -1, so that the modulus stays positive at the centre.
    return {.id = "soft_patch",
            .kind = EffectKind::material,
            .summary = "the modulus differs around a point",
            .parameters = {fitted_number("relative_change", -0.98, 20.0, 0.3),
                           {"centre_m", EffectParameterKind::vector3, false, -10.0, 10.0, 0.01},
                           fitted_number("radius_m", 1e-4, 10.0, 0.005, true)},
            .apply = apply,
            .probes = probes,
            .varies_within_cells = true,
            .resolved_length = "radius_m",
            .draw = {.amount = "relative_change", .lowest = 0.1, .highest = 0.9, .has_sign = true, .others = drawn}};
}

}  // namespace myo::effect
