#include <utility>

#include "effect/effect.hpp"
#include "model/directional_mass.hpp"

namespace myo::effect {
namespace hung_mass_parts {

constexpr const char* ratio = "inertia_ratio";
struct HungMassConstants {
    double standard_gravity_m_s2 = 9.80665;
};
constexpr HungMassConstants hung_mass_constants;

/// Whether the force acts during the run like a weight. One released at t = 0 contributes no inertia, and one that
/// grows or fades is no weight.
bool hangs(const model::DeadForce& force, double end_s) {
    return force.switches() && force.force_N.norm() > 0.0 && force.from_s < end_s && force.until_s > 0.0;
}

/// Adds to each dead force the inertia of a hanging body, along the line of the force and while it acts. Changes of
/// mass cause no impulse: a body that is attached moves with the specimen from then on.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    // Without gravity in the model the weight is converted with standard gravity.
    const double g = affected.model.gravity_m_s2.norm() > 0.0 ? affected.model.gravity_m_s2.norm()
                                                              : hung_mass_constants.standard_gravity_m_s2;
    for (const model::DeadForce& force : affected.model.forces) {
        if (!hangs(force, affected.options.end_s)) continue;
        // Ratio 1 is the mass whose weight is the declared force.
        model::DirectionalMass body = model::line_mass(force.share, force.force_N,
                                                       number(parameters, ratio) * force.force_N.norm() / g);
        body.from_s = force.from_s;
        body.until_s = force.until_s;
        affected.model.directional_masses.push_back(std::move(body));
    }
}

/// Not observable without a weight. Two ratios: a thread with a light body, and the weight's own mass.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    for (std::size_t i = 0; i < search.models.size(); ++i)
        for (const model::DeadForce& force : search.models[i].forces)
            if (hangs(force, search.trials[i].end_s))
                return {probe({{ratio, 0.1}}, ratio), probe({{ratio, 1.0}}, ratio)};
    return {};
}

}  // namespace hung_mass_parts

Effect hung_mass() {
    using namespace hung_mass_parts;
    return {.id = "hung_mass",
            .kind = EffectKind::force,
            .summary = "a declared dead force is the weight of a body on a thread, whose inertia acts along the thread",
            .parameters = {fitted_number(ratio, 0.0, 100.0, 0.3, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.hung_weight = true}, .amount = ratio, .lowest = 0.1, .highest = 3.0}};
}

}  // namespace myo::effect
