#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "experiment/experiment.hpp"
#include "toml/toml_reader.hpp"

namespace myo::experiment {

// One function per table of the schema. Each reads its table from the document, returns SI values and throws
// toml::TomlFailure (key, sentence, line) on the first error. Conditions on two tables are checked by
// check_declarations() after all tables have been read.

/// [geometry]: a box or a surface file; the file is not opened.
std::variant<BoxGeometry, StlGeometry> read_geometry(const toml::TomlReader& document,
                                                     const std::filesystem::path& folder);
/// [material]: constitutive law, moduli and the parameters to fit.
MaterialDeclaration read_material(const toml::TomlReader& document);
/// [[muscle]]: signal files are read here, masks are not.
std::vector<MuscleDeclaration> read_muscles(const toml::TomlReader& document, const std::filesystem::path& folder);
/// [registration]; without this table the registration is known.
///
/// @param warnings  receives a sentence for each limit that is ignored
RegistrationDeclaration read_registration(const toml::TomlReader& document, std::vector<std::string>& warnings);
/// [markers]: rest positions on the body, fixed markers and recorded labels.
MarkersDeclaration read_markers(const toml::TomlReader& document);
/// [[trial]]: at least one; the traces are not opened.
std::vector<TrialDeclaration> read_trials(const toml::TomlReader& document, const std::filesystem::path& folder);
/// [trial.columns]: layout of a text file without a header.
measurement::ColumnLayout read_columns_declaration(const toml::TomlReader& trial);
/// [[trial.load]]: masses and forces of one trial.
std::vector<LoadDeclaration> read_loads(const toml::TomlReader& trial);
/// [[effect]]: parameters as the effect catalogue declares them.
std::vector<effect::EffectDeclaration> read_effects(const toml::TomlReader& document);

/// Checks conditions on several tables: unique names, references to muscles, markers and trials, cycles of followers.
///
/// @param experiment  column labels are replaced by marker names; warnings are appended
void check_declarations(Experiment& experiment);

/// Fails if a name in `names` occurs twice; `paths[i]` is the key of names[i].
void check_unique(const Experiment& experiment, const std::vector<std::string>& names,
                  const std::vector<std::string>& paths);

/// Vector normalised to unit length. A length within 1 % of 1 is accepted as rounded input; anything else fails.
Eigen::Vector3d unit_direction(const toml::TomlReader& table, const std::string& key);

}  // namespace myo::experiment
