#include <utility>

#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

// Names head columns of CSV files, hence no comma. Until [markers.labels] is read, the label equals the name.
std::vector<MarkerDeclaration> read_positions(const toml::TomlReader& markers, const std::string& key) {
    std::vector<MarkerDeclaration> declared;
    const toml::TomlReader table = markers.table_of_names(key);
    for (const std::string& name : table.keys()) {
        if (name.find_first_not_of(" \t") == std::string::npos) table.fail(name, "a marker's name must not be empty");
        if (name.find(',') != std::string::npos) table.fail(name, "a marker's name must not hold a comma");
        declared.push_back({name, table.vector3(name), name});
    }
    return declared;
}

// Labels are the names in the recording, where they differ from the declared ones.
void read_labels(const toml::TomlReader& markers, MarkersDeclaration& declared) {
    const toml::TomlReader table = markers.table_of_names("labels");
    std::vector<std::string> names;
    for (auto* group : {&declared.on_body, &declared.fixed}) {
        for (MarkerDeclaration& marker : *group) {
            if (marker.probe) continue;  // no recording has it
            names.push_back(marker.name);
            if (table.has_entry(marker.name)) marker.label = table.name(marker.name);
        }
    }
    for (const std::string& key : table.keys()) {
        bool known = false;
        for (const std::string& name : names) known = known || name == key;
        if (!known) table.fail(key, "no marker has this name; " + toml::suggest(key, names));
    }
}

}  // namespace

MarkersDeclaration read_markers(const toml::TomlReader& document, bool recorded) {
    if (!recorded && !document.has("markers")) return {};
    const toml::TomlReader markers = document.table(
        "markers", {"noise_m", "max_standoff_m", "placement_m", "compare", "rest_m", "probe_m", "fixed_m", "labels"});
    MarkersDeclaration declared;
    declared.noise_m = markers.optional_number("noise_m", toml::positive());
    declared.max_standoff_m = markers.number_or("max_standoff_m", declared.max_standoff_m, toml::not_negative());
    declared.placement_m = markers.number_or("placement_m", declared.placement_m, toml::not_negative());
    if (markers.has("compare"))
        declared.compare = markers.choice<Comparison>(
            "compare", {{"position", Comparison::position}, {"displacement", Comparison::displacement}});
    // Without recordings markers are optional: they are then only places of interest.
    if (recorded || markers.has("rest_m")) declared.on_body = read_positions(markers, "rest_m");
    if (recorded && declared.on_body.empty()) markers.fail("rest_m", "at least one marker is needed");
    // Behind the recorded markers on the body; read_trial() adds tracks without samples for them in this order.
    if (markers.has("probe_m"))
        for (MarkerDeclaration& probe : read_positions(markers, "probe_m")) {
            probe.probe = true;
            declared.on_body.push_back(std::move(probe));
        }
    if (markers.has("fixed_m")) declared.fixed = read_positions(markers, "fixed_m");
    // Last, since labels refer to markers of both groups.
    if (markers.has("labels")) read_labels(markers, declared);
    return declared;
}

}  // namespace myo::experiment
