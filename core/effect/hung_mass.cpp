#include <utility>

#include "effect/effect.hpp"
#include "model/directional_mass.hpp"

namespace myo::effect {
namespace {

constexpr const char* ratio = "inertia_ratio";
constexpr double standard_gravity_m_s2 = 9.80665;

/// Whether the force acts within the run: what is let go at t = 0 has no inertia in it.
bool hangs(const model::DeadForce& force, double end_s) {
    return force.force_N.norm() > 0.0 && force.from_s < end_s && force.until_s > 0.0;
}

/// The body hangs on its thread as long as its force acts. It comes and goes without a jerk: one that joins moves along
/// with the specimen from then on.
void apply(const EffectSite&, const EffectParameters& parameters, Affected& affected) {
    const double g = affected.model.gravity_m_s2.norm() > 0.0 ? affected.model.gravity_m_s2.norm()
                                                              : standard_gravity_m_s2;
    for (const model::DeadForce& force : affected.model.forces) {
        if (!hangs(force, affected.options.end_s)) continue;
        model::DirectionalMass body = model::line_mass(force.share, force.force_N,
                                                       number(parameters, ratio) * force.force_N.norm() / g);
        body.from_s = force.from_s;
        body.until_s = force.until_s;
        affected.model.directional_masses.push_back(std::move(body));
    }
}

std::vector<EffectProbe> probes(const EffectSearch& search) {
    for (std::size_t i = 0; i < search.models.size(); ++i)
        for (const model::DeadForce& force : search.models[i].forces)
            if (hangs(force, search.sites[i].end_s))
                return {probe({{ratio, 0.1}}, ratio), probe({{ratio, 1.0}}, ratio)};
    return {};
}

}  // namespace

Effect hung_mass() {
    return {"hung_mass",
            EffectStage::force,
            "a declared dead force is the weight of a body on a thread, whose inertia acts along the thread",
            {fitted_number(ratio, 0.0, 100.0, 0.3, true)},
            apply,
            probes};
}

}  // namespace myo::effect
