#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

std::vector<LoadDeclaration> read_loads(const toml::TomlReader& trial) {
    std::vector<LoadDeclaration> loads;
    for (const toml::TomlReader& table :
         trial.tables("load", {"kind", "box_m", "mass_kg", "force_N", "from_s", "until_s", "curve"})) {
        LoadDeclaration load;
        load.kind = table.choice<LoadKind>("kind", {{"mass", LoadKind::mass}, {"force", LoadKind::force}});
        load.box_m = table.box("box_m");
        if (load.kind == LoadKind::mass) {
            table.reject("force_N", "belongs to kind = \"force\", not to \"mass\"");
            // A mass belongs to the mass matrix, which is constant during a trial.
            for (const char* key : {"from_s", "until_s", "curve"})
                table.reject(key, "belongs to kind = \"force\": a mass is fixed to the body for the whole trial");
            load.mass_kg = table.number("mass_kg", toml::not_negative());
        } else {
            table.reject("mass_kg", "belongs to kind = \"mass\", not to \"force\"");
            load.force_N = table.vector3("force_N");
            if (table.has("curve")) {
                for (const char* key : {"from_s", "until_s"})
                    table.reject(key, "cannot be combined with curve: the curve says when the force acts");
                load.curve = read_curve(table, "curve");
            }
        }
        // Without these keys a force acts for all time. Infinite numbers state the same.
        load.from_s = table.number_or("from_s", load.from_s, toml::any_or_infinite());
        load.until_s = table.number_or("until_s", load.until_s, toml::any_or_infinite());
        if (load.from_s >= load.until_s)
            table.fail(table.has("until_s") ? "until_s" : "from_s", "the load ends before it begins (from_s " +
                                                                        format_number(load.from_s) + ", until_s " +
                                                                        format_number(load.until_s) + ")");
        loads.push_back(load);
    }
    return loads;
}

}  // namespace myo::experiment
