#pragma once

#include <optional>

#include "panels/panel.hpp"

// Edits of declared chambers and tendons, as the panels and the tools of the view make them.

namespace myo::ui::panels {

/// A chamber or tendon in the declaration.
struct DeclaredActuator {
    std::string name;
    const char* table = "";    // "chamber" or "tendon"
    std::size_t index = 0;     // in the table
    const char* command = "";  // table of a trial with constants: "pressure_Pa", "tension_N" or "shortening_m"
};
/// A chamber of the declaration by its index in the table, which must exist.
DeclaredActuator declared_chamber(const commands::Scene& scene, std::size_t index);
/// A tendon of the declaration by its index in the table, which must exist. Its command is the quantity that its motor
/// prescribes.
DeclaredActuator declared_tendon(const commands::Scene& scene, std::size_t index);
/// The chamber or tendon of a name; empty if the declaration has none.
std::optional<DeclaredActuator> declared_actuator(const commands::Scene& scene, const std::string& name);

/// First of "chamber1", "chamber2", ... that neither a muscle nor a chamber nor a tendon has.
std::string free_actuator_name(const commands::WorkbenchState& state, const std::string& stem);

/// Makes a chamber of a cavity.
void add_chamber(PanelContext& context, const commands::SceneCavity& cavity);
/// Adds a tendon of prescribed tension through guides [m], 3 x n, motor's end first.
void add_tendon(PanelContext& context, const Eigen::Matrix3Xd& path_m);
/// Replaces the guides of a tendon.
///
/// @param tendon   index in the declaration
/// @param path_m   guides [m], 3 x n, motor's end first
/// @param item     name of the edit
/// @param goes_on  continues a drag: undo takes both edits as one
void set_tendon_path(PanelContext& context, std::size_t tendon, const Eigen::Matrix3Xd& path_m, const std::string& item,
                     bool goes_on = false);
/// Lets the motor of a tendon prescribe the other quantity. Commands of the former one are removed, and so is the
/// thread's stiffness where the motor prescribes the tension.
void set_tendon_drive(PanelContext& context, std::size_t tendon, bool by_shortening);

/// Renames a chamber or tendon, also in the commands of the trials.
void rename_actuator(PanelContext& context, const DeclaredActuator& actuator, const std::string& wanted);
/// Removes a chamber or tendon and its commands.
void remove_actuator(PanelContext& context, const DeclaredActuator& actuator);
/// Sets the command of a chamber or tendon in a trial; empty: at rest. A command from the trial's actuation file is no
/// part of the declaration and stays.
///
/// @param trial    index in Scene::trials
/// @param goes_on  continues a drag: undo takes both edits as one
void set_command(PanelContext& context, const DeclaredActuator& actuator, std::size_t trial,
                 const std::optional<commands::DeclaredCommand>& command, bool goes_on);

}  // namespace myo::ui::panels
