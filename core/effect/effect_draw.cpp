#include "effect/effect_draw.hpp"

#include <cassert>
#include <cmath>

namespace myo::effect {

using Eigen::Vector3d;

Vector3d drawn_direction(RandomStream& random) {
    // One statement each: compilers order the arguments of one call differently, and drawn cases are kept as records.
    const double z = random.normal(), y = random.normal(), x = random.normal();
    return Vector3d(x, y, z).normalized();
}

// The body extends along x, so that only y and z are across.
double drawn_cross_axis(RandomStream& random) { return random.chance(0.5) ? 1.0 : 2.0; }

std::string drawn_fitted_trial(const DrawContext& context, RandomStream& random) {
    std::vector<std::string> names;
    for (const DrawTrial& trial : context.trials)
        if (trial.is_fitted) names.push_back(trial.name);
    assert(!names.empty());
    return names[static_cast<std::size_t>(random.below(static_cast<int>(names.size())))];
}

double drawn_time_s(const DrawContext& context, RandomStream& random) {
    return 0.01 * std::round(100.0 * random.uniform(0.25, 0.7) * context.trials.front().end_s);
}

EffectParameters drawn_position(const DrawContext& context, RandomStream& random) {
    return {{"position_m", Eigen::VectorXd(context.surface_point(random))}};
}

}  // namespace myo::effect
