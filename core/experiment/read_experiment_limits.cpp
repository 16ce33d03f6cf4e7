#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

LimitsDeclaration read_limits(const toml::TomlReader& document) {
    LimitsDeclaration limits;
    if (!document.has("limits")) return limits;
    const toml::TomlReader table = document.table(
        "limits", {"force_N", "mass_kg", "pressure_Pa", "tension_N", "shortening_m", "activation", "duration_s"});
    // An absent key leaves its quantity without a limit.
    const auto read = [&](const char* key, const toml::NumberRange& range, std::optional<double>& value) {
        if (table.has(key)) value = table.number(key, range);
    };
    read("force_N", toml::positive(), limits.force_N);
    read("mass_kg", toml::positive(), limits.mass_kg);
    read("pressure_Pa", toml::positive(), limits.pressure_Pa);
    read("tension_N", toml::positive(), limits.tension_N);
    read("shortening_m", toml::positive(), limits.shortening_m);
    // 1 is passive: a muscle that may not go below it could not contract.
    read("activation", toml::strictly_between(0.0, 1.0), limits.activation);
    read("duration_s", toml::positive(), limits.duration_s);
    return limits;
}

}  // namespace myo::experiment
