#pragma once

#include <limits>
#include <string>
#include <vector>

namespace myo {

/// What a parameter of an effect may hold.
enum class EffectParameterKind {
    number,
    vector3,             // position, direction or shift, mesh frame
    number_or_vector3,   // a size, or one with its direction
    axis,                // 0 x, 1 y, 2 z
    marker,
    marker_pair,
    trial,
};

struct EffectParameterEntry {
    std::string name;   // carries the unit
    EffectParameterKind kind = EffectParameterKind::number;
    bool optional = false;
    double lowest = -std::numeric_limits<double>::max();   // of a number, bounds included
    double highest = std::numeric_limits<double>::max();
};

struct EffectEntry {
    std::string id;
    std::vector<EffectParameterEntry> parameters;
};

/// The agreed ids and parameter names of effects, in the order of the vocabulary; "none" and "unknown" are verdicts, not
/// effects, and are left out.
const std::vector<EffectEntry>& effect_vocabulary();

/// The entry with this id, or null.
const EffectEntry* find_effect_entry(const std::string& id);

std::vector<std::string> effect_ids();

}  // namespace myo
