#include "effect/effect.hpp"

namespace myo::effect {
namespace viscoelastic_creep_parts {

constexpr const char* ratio = "modulus_ratio";
constexpr const char* time = "relaxation_time_s";

/// Adds a Maxwell branch. Ratio 0 adds none, because the dashpot strains would only cost time.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    if (number(parameters, ratio) > 0.0)
        affected.model.creep = material::MaxwellBranch{number(parameters, ratio), number(parameters, time)};
}

/// Relaxation times from fast to slow: the ratio is linear to first order, the time is not.
std::vector<EffectProbe> probes(const EffectSearch&) {
    std::vector<EffectProbe> list;
    for (const double tau : {0.03, 0.2, 1.0}) list.push_back(probe({{ratio, 0.1}, {time, tau}}, ratio));
    return list;
}

/// Relaxation within the time of a trial [s].
EffectParameters drawn(const DrawContext&, RandomStream& random) { return {{time, random.log_uniform(0.03, 0.5)}}; }

}  // namespace viscoelastic_creep_parts

Effect viscoelastic_creep() {
    using namespace viscoelastic_creep_parts;
    return {.id = "viscoelastic_creep",
            .kind = EffectKind::material,
            .summary = "a Maxwell branch parallel to the elastic network, on the deviatoric stress",
            .parameters = {fitted_number(ratio, 0.0, 50.0, 0.1, true), fitted_number(time, 1e-3, 1e4, 0.05, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = ratio, .lowest = 0.02, .highest = 2.0, .others = drawn}};
}

}  // namespace myo::effect
