#include "experiment/read_experiment.hpp"

#include <system_error>

#include "experiment/check_body.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "toml/toml_override.hpp"
#include "toml/toml_reader.hpp"

namespace myo::experiment {
namespace {

namespace fs = std::filesystem;

const std::string current_schema = "experiment/1";

// A body on supports or obstacles needs no clamp; the box then holds no point.
Box read_clamp(const toml::TomlReader& document) {
    if (document.has("clamp")) return document.table("clamp", {"box_m"}).box("box_m");
    if (!document.has("support") && !document.has("obstacle"))
        document.fail("clamp", "is missing: a [clamp] or [[support]] holds the body, or an [[obstacle]] bears it");
    return {Eigen::Vector3d::Ones(), -Eigen::Vector3d::Ones()};
}

/// Reads all tables and checks them against each other. Throws toml::TomlFailure at the first error.
Experiment read_document(const toml::TomlValue& root, const fs::path& folder) {
    // A file of another schema version has other keys, so the version is reported before unknown keys.
    if (const toml::TomlValue* schema = root.find("schema");
        schema != nullptr && schema->kind == toml::TomlValue::Kind::text && schema->text != current_schema)
        throw toml::TomlFailure{
            Error{"schema: unknown schema \"" + schema->text + "\"; this program reads \"" + current_schema + "\"",
                  schema->where}};
    // Unknown keys are errors: a misspelt key would otherwise silently select a default.
    const toml::TomlReader document(
        root, "",
        {"schema",       "name",    "description", "geometry", "clamp",  "support",  "material", "environment",
         "muscle",       "chamber", "tendon",      "part",     "mount",  "obstacle", "sensor",   "limits",
         "registration", "unknown", "markers",     "trial",    "effect", "laws"});
    document.text("schema");

    Experiment experiment;
    experiment.folder = folder;
    experiment.key_locations = toml::locations(root);
    // The empty key is the document: location_of() ends there if no table encloses a key.
    experiment.key_locations.emplace("", root.where);
    experiment.name = document.text("name");
    if (experiment.name.find_first_not_of(" \t\r\n") == std::string::npos) document.fail("name", "must not be empty");
    experiment.description = document.text_or("description", "");
    experiment.geometry = read_geometry(document, folder);
    experiment.clamp_box_m = read_clamp(document);
    experiment.supports = read_supports(document);
    experiment.material = read_material(document);
    if (document.has("environment")) {
        const toml::TomlReader environment = document.table("environment", {"gravity_m_s2"});
        if (environment.has("gravity_m_s2")) experiment.gravity_m_s2 = environment.vector3("gravity_m_s2");
    }
    experiment.muscles = read_muscles(document, folder);
    experiment.chambers = read_chambers(document);
    experiment.tendons = read_tendons(document);
    // After the material, whose values fill the keys that a part leaves out.
    experiment.parts = read_parts(document, folder, experiment.material);
    experiment.mount = read_mount(document);
    experiment.obstacles = read_obstacles(document);
    experiment.sensors = read_sensors(document);
    experiment.limits = read_limits(document);
    experiment.registration = read_registration(document, experiment.warnings);
    experiment.unknowns = read_unknowns(document);
    experiment.trials = read_trials(document, folder);
    // After the trials: only recordings need markers.
    experiment.markers = read_markers(document, has_recordings(experiment));
    experiment.law_files = law_files(document, folder);
    experiment.laws = read_laws(document, experiment.law_files);
    // After the laws, which are effects that the catalogue does not have.
    experiment.effects = read_effects(document, experiment.laws);
    // Once all tables are read, so that each can name entries of any other.
    check_declarations(experiment);
    check_unknowns(experiment);
    // A box is complete without further files; an STL is checked when its triangles are read.
    if (std::holds_alternative<BoxGeometry>(experiment.geometry))
        if (const Result<void> fits = check_on_body(experiment, *read_body_surface(experiment)); !fits)
            throw toml::TomlFailure{fits.error()};
    return experiment;
}

/// The table readers throw on the first error; it becomes a value here, at the boundary of this module.
Result<Experiment> read_or_error(const toml::TomlValue& document, const fs::path& folder) {
    try {
        return read_document(document, folder);
    } catch (const toml::TomlFailure& failure) {
        return failure.error;
    }
}

}  // namespace

Result<Experiment> read_experiment(const fs::path& folder,
                                   const std::vector<std::pair<std::string, std::string>>& overrides) {
    std::error_code code;
    // Tools pass either the folder or the file; both resolve relative paths against the folder.
    const bool names_the_file = fs::is_regular_file(folder, code);
    if (!fs::exists(folder, code)) return Error{"experiment folder not found", folder.string()};
    const fs::path file = names_the_file ? folder : folder / "experiment.toml";
    // Overrides change the document before it is read, so that they pass the same checks as the file.
    Result<toml::TomlValue> document = toml::read_toml(file);
    if (!document) return document.error();
    for (const auto& [key, value] : overrides)
        if (Result<void> set = toml::override_toml(*document, key, value); !set) return set.error();
    return read_or_error(*document, file.parent_path());
}

Result<Experiment> read_experiment_text(const std::string& text, const fs::path& file) {
    const Result<toml::TomlValue> document = toml::parse_toml(text, file.string());
    if (!document) return document.error();
    return read_or_error(*document, file.parent_path());
}

std::string location_of(const Experiment& experiment, const std::string& key) {
    // Shorten the key at its last '.' or '[' until a table with a recorded location is found.
    std::string known = key;
    while (true) {
        if (const auto found = experiment.key_locations.find(known); found != experiment.key_locations.end())
            return found->second;
        if (known.empty()) return (experiment.folder / "experiment.toml").string();
        const std::size_t end = known.find_last_of(".[");
        known.resize(end == std::string::npos ? 0 : end);
    }
}

Error declaration_error(const Experiment& experiment, const std::string& key, const std::string& sentence) {
    return {key + ": " + sentence, location_of(experiment, key)};
}

}  // namespace myo::experiment
