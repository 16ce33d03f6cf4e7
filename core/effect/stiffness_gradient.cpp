#include "effect/effect.hpp"
#include "effect/point_stiffness.hpp"

namespace myo::effect {
namespace stiffness_gradient_parts {

/// Modulus factor linear in one coordinate: 1 - r/2 at its lowest, 1 + r/2 at its highest value.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const auto axis = static_cast<Eigen::Index>(number(parameters, "axis"));
    const Eigen::RowVectorXd coordinate = context.body->mesh.nodes.row(axis);
    const double lowest = coordinate.minCoeff(), size = coordinate.maxCoeff() - lowest,
                 r = number(parameters, "relative_change");
    scale_stiffness(
        context, [&](const Eigen::Vector3d& X) { return 1.0 + r * ((X(axis) - lowest) / size - 0.5); }, affected);
}

std::vector<EffectProbe> probes(const EffectSearch&) {
    std::vector<EffectProbe> list;
    for (const double axis : {0.0, 1.0, 2.0}) {
        list.push_back(probe({{"relative_change", 0.05}, {"axis", axis}}, "relative_change"));
        // Across a bending body the response to a small gradient cancels to first order: one side becomes stiffer by as
        // much as the other becomes softer. Hence the large probes.
        for (const double change : {1.0, -1.0}) {
            list.push_back(probe({{"relative_change", change}, {"axis", axis}}, "relative_change"));
            list.back().large = true;
        }
    }
    return list;
}

EffectParameters drawn(const DrawContext&, RandomStream& random) {
    return {{"axis", random.chance(0.6) ? 0.0 : drawn_cross_axis(random)}};
}

}  // namespace stiffness_gradient_parts

Effect stiffness_gradient() {
    using namespace stiffness_gradient_parts;
    // Beyond a relative change of 2 the modulus would be negative at one end.
    return {.id = "stiffness_gradient",
            .kind = EffectKind::material,
            .summary = "the modulus is linear in one coordinate",
            .parameters = {fitted_number("relative_change", -1.98, 1.98, 0.3), {"axis", EffectParameterKind::axis}},
            .apply = apply,
            .probes = probes,
            .varies_within_cells = true,
            .draw = {.amount = "relative_change", .lowest = 0.05, .highest = 1.6, .has_sign = true, .others = drawn}};
}

}  // namespace myo::effect
