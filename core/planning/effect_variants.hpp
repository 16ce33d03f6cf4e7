#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/effect.hpp"
#include "planning/planning_policy.hpp"
#include "setup/setup.hpp"

namespace myo::planning {

/// A form of an effect whose size may be chosen: at a place, or along the columns that span its directions.
struct EffectVariant {
    const effect::Effect* effect = nullptr;
    std::vector<effect::EffectParameters> columns;  // one, or those of a probe (EffectProbe::columns)
};

/// Forms of an effect that a diagnosis would try, or a typical one where it scans the recordings instead; at
/// most PowerPolicy::most_forms.
///
/// @param trials  of the search, indices of the setup
/// @return        empty if the effect cannot be seen in these trials
std::vector<EffectVariant> effect_variants(const effect::Effect& effect, const effect::EffectSearch& search,
                                           const setup::Setup& setup, const std::vector<std::size_t>& trials,
                                           const PowerPolicy& policy);

/// Sizes of an effect over its plausible range, from small to large by their influence; empty if it has none.
/// @param count  number of sizes, in equal ratios; values of the amount in its unit
std::vector<double> effect_sizes(const effect::Effect& effect, int count);

/// The columns of a variant with this size; as they are if the effect has no size. Empty if a column lacks the amount.
std::vector<effect::EffectParameters> sized_columns(const EffectVariant& variant, std::optional<double> size);

}  // namespace myo::planning
