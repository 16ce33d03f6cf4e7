#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "experiment/experiment.hpp"
#include "toml/toml_reader.hpp"

namespace myo::experiment {

// One function per table of the schema; each reads its own table from the document and fails by TomlFailure.
// What depends on two tables is looked at by check_declarations() once all are read.

std::variant<BoxGeometry, StlGeometry> read_geometry(const toml::TomlReader& document,
                                                     const std::filesystem::path& folder);
MaterialDeclaration read_material(const toml::TomlReader& document);
std::vector<MuscleDeclaration> read_muscles(const toml::TomlReader& document, const std::filesystem::path& folder);
RegistrationDeclaration read_registration(const toml::TomlReader& document, std::vector<std::string>& warnings);
MarkersDeclaration read_markers(const toml::TomlReader& document);
std::vector<TrialDeclaration> read_trials(const toml::TomlReader& document, const std::filesystem::path& folder);
measurement::ColumnLayout read_columns_declaration(const toml::TomlReader& trial);
std::vector<LoadDeclaration> read_loads(const toml::TomlReader& trial);
std::vector<effect::EffectDeclaration> read_effects(const toml::TomlReader& document);

/// Names that one table uses and another declares, and what needs two tables to be wrong; adds warnings.
void check_declarations(Experiment& experiment);

/// Fails when a name in `names` occurs twice; `paths[i]` is the key of names[i].
void check_unique(const Experiment& experiment, const std::vector<std::string>& names,
                  const std::vector<std::string>& paths);

/// The direction as a unit vector. Within 1 % of unit length it is taken as rounded by hand and normalised.
Eigen::Vector3d unit_direction(const toml::TomlReader& table, const std::string& key);

}  // namespace myo::experiment
