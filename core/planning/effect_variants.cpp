#include "planning/effect_variants.hpp"

#include <algorithm>
#include <cmath>

#include "experiment/new_effect.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::planning {
namespace {

/// A typical form, in the first of the trials and in its middle.
EffectVariant typical_variant(const effect::Effect& effect, const setup::Setup& setup, std::size_t trial) {
    const experiment::NewEffectPlace place{mesh::bounding_box(setup.surface.vertices),
                                           0.5 * setup.trials[trial].options.end_s};
    EffectVariant variant{&effect, {experiment::new_effect(effect, setup.experiment, place).parameters}};
    for (const effect::EffectParameterEntry& entry : effect.parameters)
        if (entry.kind == effect::EffectParameterKind::trial)
            variant.columns.front()[entry.name] = setup.trials[trial].name;
    return variant;
}

/// The value with this size, with its sign and direction.
effect::EffectParameter sized(const effect::EffectParameter& value, double size,
                              const effect::EffectParameterEntry& entry) {
    if (const auto* const vector = std::get_if<Eigen::VectorXd>(&value))
        return vector->norm() > 0.0 ? Eigen::VectorXd(size * vector->normalized()) : *vector;
    return std::clamp(std::copysign(size, std::get<double>(value)), entry.lowest, entry.highest);
}

}  // namespace

std::vector<EffectVariant> effect_variants(const effect::Effect& effect, const effect::EffectSearch& search,
                                           const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                           const PowerPolicy& policy) {
    if (!effect.probes) return {typical_variant(effect, setup, trials.front())};
    const std::vector<effect::EffectProbe> probes = effect.probes(search);
    // Large probes serve where an effect has no small ones: sized_columns() replaces the amounts anyway.
    const bool small = std::any_of(probes.begin(), probes.end(), [](const auto& probe) { return !probe.large; });
    std::vector<EffectVariant> variants;
    for (const effect::EffectProbe& probe : probes)
        if (!small || !probe.large) variants.push_back({&effect, probe.columns});
    const std::size_t all = variants.size(), most = std::min(all, policy.most_forms);
    // In place: the index read is never below the one written.
    for (std::size_t i = 0; i < most; ++i) variants[i] = variants[i * all / most];
    variants.resize(most);
    return variants;
}

std::vector<double> effect_sizes(const effect::Effect& effect, int count) {
    const effect::EffectDraw& draw = effect.draw;
    if (draw.amount.empty() || !(draw.lowest > 0.0)) return {};
    std::vector<double> sizes;
    for (int i = 0; i < count; ++i)
        sizes.push_back(draw.lowest * std::pow(draw.highest / draw.lowest, i / std::max(1.0, count - 1.0)));
    // A large amount of such an effect (a stiffness of the clamp) has little influence.
    if (!draw.grows) std::reverse(sizes.begin(), sizes.end());
    return sizes;
}

std::vector<effect::EffectParameters> sized_columns(const EffectVariant& variant, std::optional<double> size) {
    std::vector<effect::EffectParameters> columns = variant.columns;
    if (!size) return columns;
    const std::string& amount = variant.effect->draw.amount;
    for (effect::EffectParameters& column : columns) {
        const auto value = column.find(amount);
        // Names of markers or trials have no size.
        if (value == column.end() || std::holds_alternative<std::string>(value->second)) return {};
        value->second = sized(value->second, *size, *variant.effect->parameter(amount));
    }
    return columns;
}

}  // namespace myo::planning
