#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "experiment/experiment.hpp"
#include "toml/toml_reader.hpp"

namespace myo::experiment {

// One function per table of the schema. Each reads its table from the document, returns SI values and throws
// toml::TomlFailure (key, sentence, line) on the first error. Conditions on two tables are checked by
// check_declarations() after all tables have been read.

/// [geometry]: a box, a surface file or a volume mesh; the file is not opened.
Geometry read_geometry(const toml::TomlReader& document, const std::filesystem::path& folder);
/// [[support]]: boxes and the axes that they hold.
std::vector<SupportDeclaration> read_supports(const toml::TomlReader& document);
/// [material]: constitutive law, moduli and the parameters to fit.
MaterialDeclaration read_material(const toml::TomlReader& document);
/// [[muscle]]: signal files are read here, masks are not.
std::vector<MuscleDeclaration> read_muscles(const toml::TomlReader& document, const std::filesystem::path& folder);
/// Name of a muscle, chamber or tendon, which heads a column of the actuation file.
std::string read_actuator_name(const toml::TomlReader& table);
/// [[chamber]]: whether the point lies in a cavity is checked by check_on_body().
std::vector<ChamberDeclaration> read_chambers(const toml::TomlReader& document);
/// [[tendon]]: path, drive, stiffness and friction.
std::vector<TendonDeclaration> read_tendons(const toml::TomlReader& document);
/// [[part]]: surface files are not opened.
///
/// @param material  values of keys that a part leaves out
std::vector<PartDeclaration> read_parts(const toml::TomlReader& document, const std::filesystem::path& folder,
                                        const MaterialDeclaration& material);
/// [mount]; without this table the clamped region stands still.
MountMotion read_mount(const toml::TomlReader& document);
/// [[obstacle]]: planes, spheres and boxes.
std::vector<ObstacleDeclaration> read_obstacles(const toml::TomlReader& document);
/// [[sensor]]: what it measures is resolved by check_declarations().
std::vector<SensorDeclaration> read_sensors(const toml::TomlReader& document);
/// [limits]; without this table nothing is limited.
LimitsDeclaration read_limits(const toml::TomlReader& document);
/// [registration]; without this table the registration is known.
///
/// @param warnings  receives a sentence for each limit that is ignored
RegistrationDeclaration read_registration(const toml::TomlReader& document, std::vector<std::string>& warnings);
/// [markers]: rest positions on the body, fixed markers and recorded labels.
///
/// @param recorded  a trial has a recording, so that at least one marker is needed
MarkersDeclaration read_markers(const toml::TomlReader& document, bool recorded);
/// [[trial]]: at least one; a trace is opened only if its format is not declared.
std::vector<TrialDeclaration> read_trials(const toml::TomlReader& document, const std::filesystem::path& folder);
/// Start and commands of a trial: hold, start, actuation, actuation_step, constants per actuator, sensors.
void read_commands(const toml::TomlReader& trial, const std::filesystem::path& folder, TrialDeclaration& declared);
/// Keys of a trial that read_commands() reads, for the list of keys that a [[trial]] may hold.
std::vector<std::string> command_keys();
/// [trial.columns]: layout of a text file without a header. Whether its markers are declared is checked by
/// check_declarations().
measurement::ColumnLayout read_columns_declaration(const toml::TomlReader& trial);
/// Rows [t_s, value] that are linear in between and constant outside; two equal times are a jump. At least two rows
/// with ascending times [s]; the unit of the values is that of the key.
fibre::Signal read_curve(const toml::TomlReader& table, const std::string& key);
/// [[unknown]]: bounds of fitted values; names are checked by check_unknowns().
std::vector<UnknownDeclaration> read_unknowns(const toml::TomlReader& document);
/// Checks that [[unknown]] names values that a fit of this experiment can find.
void check_unknowns(const Experiment& experiment);
/// [[trial.load]]: masses and forces of one trial.
std::vector<LoadDeclaration> read_loads(const toml::TomlReader& trial);
/// [[trial.goal]]: places of markers at times. Files of paths are read here.
///
/// @param declared  role, hold and duration of the trial
std::vector<GoalDeclaration> read_goals(const toml::TomlReader& trial, const std::filesystem::path& folder,
                                        const TrialDeclaration& declared);
/// [[trial.repair]]: what is done to the recording by hand; names are checked on reading the recording.
std::vector<measurement::TraceRepair> read_repairs(const toml::TomlReader& trial);
/// `laws`: files of the user's laws, resolved against `folder`; each must exist.
std::vector<std::filesystem::path> law_files(const toml::TomlReader& document, const std::filesystem::path& folder);
/// The laws in these files, each an effect in addition to those of the catalogue. Two laws with one id are an error.
effect::Laws read_laws(const toml::TomlReader& document, const std::vector<std::filesystem::path>& files);
/// [[effect]]: parameters as the laws and the effect catalogue declare them.
std::vector<effect::EffectDeclaration> read_effects(const toml::TomlReader& document, const effect::Laws& laws);

/// Checks conditions on several tables: unique names, references to muscles, markers and trials, cycles of followers.
///
/// @param experiment  column labels are replaced by marker names; warnings are appended
void check_declarations(Experiment& experiment);

/// The part of check_declarations() for chambers, tendons, parts, mount, obstacles, sensors and constant commands.
///
/// @param experiment  readings of sensors get the names of their columns
void check_robot_parts(Experiment& experiment);

/// True if a rigid motion can be found from the points: there are three that are not collinear, else a rotation remains
/// free. The parallelogram that they span is compared with the squared extent, whatever the size of the body.
bool fix_a_rigid_motion(const std::vector<Eigen::Vector3d>& points);

/// Fails if a name in `names` occurs twice; `paths[i]` is the key of names[i].
void check_unique(const Experiment& experiment, const std::vector<std::string>& names,
                  const std::vector<std::string>& paths);

/// Vector normalised to unit length. A length within 1 % of 1 is accepted as rounded input; anything else fails, since
/// a longer one is likely to be a force or a place.
Eigen::Vector3d unit_direction(const toml::TomlReader& table, const std::string& key);

}  // namespace myo::experiment
