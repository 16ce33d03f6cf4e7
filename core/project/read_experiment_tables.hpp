#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "project/experiment.hpp"
#include "project/toml_reader.hpp"

namespace myo {

// One function per table of the schema; each reads its own table from the document and fails by TomlFailure.
// What depends on two tables is looked at by check_declarations() once all are read.

std::variant<BoxGeometry, StlGeometry> read_geometry(const TomlReader& document, const std::filesystem::path& folder);
MaterialDeclaration read_material(const TomlReader& document);
std::vector<MuscleDeclaration> read_muscles(const TomlReader& document, const std::filesystem::path& folder);
RegistrationDeclaration read_registration(const TomlReader& document, std::vector<std::string>& warnings);
MarkersDeclaration read_markers(const TomlReader& document);
std::vector<TrialDeclaration> read_trials(const TomlReader& document, const std::filesystem::path& folder);
ColumnLayout read_columns_declaration(const TomlReader& trial);
std::vector<LoadDeclaration> read_loads(const TomlReader& trial);
std::vector<EffectDeclaration> read_effects(const TomlReader& document);

/// Names that one table uses and another declares, and what needs two tables to be wrong; adds warnings.
void check_declarations(Experiment& experiment);

/// Fails when a name in `names` occurs twice; `paths[i]` is the key of names[i].
void check_unique(const Experiment& experiment, const std::vector<std::string>& names, const std::vector<std::string>& paths);

/// The direction as a unit vector. Within 1 % of unit length it is taken as rounded by hand and normalised.
Eigen::Vector3d unit_direction(const TomlReader& table, const std::string& key);

}  // namespace myo
