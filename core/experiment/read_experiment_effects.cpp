#include <limits>

#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

// Range of the catalogue entry with its wording for messages; +-1e300 and beyond stand for "unbounded".
toml::NumberRange range_of(const effect::EffectParameterEntry& entry) {
    toml::NumberRange range{entry.lowest, entry.highest, false, "finite"};
    if (entry.lowest == 0.0) range.text = "zero or positive";
    if (entry.lowest > 0.0) range.text = "positive";
    if (entry.lowest < 0.0 && entry.lowest > -1e300) range.text = "at least " + format_number(entry.lowest);
    if (entry.highest < 1e300) range.text += " and at most " + format_number(entry.highest);
    return range;
}

/// Value of one parameter, checked against its kind and range in the effect catalogue.
///
/// @param muscles_only  no chamber or tendon is declared; otherwise values in the unit of a signal may be large
/// @param trials        number of trials, for lists of one number per trial
effect::EffectParameter read_parameter(const toml::TomlReader& effect, const effect::EffectParameterEntry& entry,
                                       bool muscles_only, Eigen::Index trials) {
    const std::string& key = entry.name;
    switch (entry.kind) {
        case effect::EffectParameterKind::number: {
            effect::EffectParameterEntry allowed = entry;
            // Upper bounds of the catalogue are those of activations, about 1; pressures are larger by orders of
            // magnitude.
            if (entry.of_signal && !muscles_only) allowed.highest = std::numeric_limits<double>::max();
            return effect.number(key, range_of(allowed));
        }
        case effect::EffectParameterKind::vector3: return Eigen::VectorXd(effect.vector3(key));
        case effect::EffectParameterKind::direction: {
            const Eigen::Vector3d direction = effect.vector3(key);
            if (!(direction.norm() > 0.0)) effect.fail(key, "has no direction: it is zero");
            return Eigen::VectorXd(direction.normalized());
        }
        case effect::EffectParameterKind::number_or_vector3:
            if (effect.is_array(key)) return Eigen::VectorXd(effect.vector3(key));
            return effect.number(key);
        case effect::EffectParameterKind::number_or_list:
            if (effect.is_array(key)) return effect.vector(key, trials);
            return effect.number(key, range_of(entry));
        case effect::EffectParameterKind::axis: {
            const double axis = effect.number(key);
            if (axis != 0.0 && axis != 1.0 && axis != 2.0)
                effect.fail(key, "must be 0 (x), 1 (y) or 2 (z), not " + format_number(axis));
            return axis;
        }
        case effect::EffectParameterKind::marker:
        case effect::EffectParameterKind::actuator:
        case effect::EffectParameterKind::trial: return effect.name(key);
        case effect::EffectParameterKind::marker_pair: {
            const std::vector<std::string> pair = effect.texts(key);
            if (pair.size() != 2 || pair[0] == pair[1]) effect.fail(key, "must name two different markers");
            return pair;
        }
    }
    effect.fail(key, "has no meaning");  // not reached: all kinds are above
}

}  // namespace

// The keys of an [[effect]] table depend on its id, so the id is read before the keys are checked.
std::vector<effect::EffectDeclaration> read_effects(const toml::TomlReader& document, const effect::Laws& laws) {
    std::vector<effect::EffectDeclaration> effects;
    // The unit of a signal is not known here, only whether any signal has another unit than that of muscles, 1.
    const bool muscles_only = !document.has_entry("chamber") && !document.has_entry("tendon");
    const auto trials = static_cast<Eigen::Index>(document.tables_of_names("trial").size());
    for (const toml::TomlReader& table : document.tables_of_names("effect")) {
        if (!table.has_entry("id")) table.fail("id", "required key is missing");
        effect::EffectDeclaration effect;
        effect.id = table.text("id");
        effect.law = effect::find_law(effect.id, laws);
        const effect::Effect* const entry = effect::find_effect(effect);
        // Both ids exist in the output of the diagnosis and are easily copied from there.
        if (effect.id == "none" || effect.id == "unknown")
            table.fail("id", "\"" + effect.id + "\" is a verdict, not an effect the model can have");
        if (entry == nullptr)
            table.fail("id",
                       "unknown effect \"" + effect.id + "\"; " + toml::suggest(effect.id, effect::effect_ids(laws)));

        // A parameter that another effect has is an unknown key here.
        std::vector<std::string> known = {"id", "calibrate"};
        for (const effect::EffectParameterEntry& parameter : entry->parameters) known.push_back(parameter.name);
        const toml::TomlReader checked = table.with_known_keys(known);
        for (const effect::EffectParameterEntry& parameter : entry->parameters)
            if (!parameter.optional || checked.has(parameter.name))
                effect.parameters.emplace(parameter.name, read_parameter(checked, parameter, muscles_only, trials));
        effect.calibrate = checked.boolean_or("calibrate", false);
        effects.push_back(effect);
    }
    return effects;
}

}  // namespace myo::experiment
