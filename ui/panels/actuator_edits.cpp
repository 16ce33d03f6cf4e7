#include "panels/actuator_edits.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "commands/curve_text.hpp"
#include "commands/place_text.hpp"
#include "panels/curve_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

using commands::DeclarationEdit;
using commands::DeclaredCommand;

/// Key of a command in the declaration. A step has a table of its own; constants and curves share that of the quantity.
toml::TomlPath command_path(const DeclaredActuator& actuator, std::size_t trial, DeclaredCommand::Kind kind,
                            const std::string& name) {
    return {"trial", trial, kind == DeclaredCommand::Kind::step ? "actuation_step" : actuator.command, name};
}

/// A number, or the rows of a curve.
std::string command_text(const DeclaredCommand& command) {
    return command.kind == DeclaredCommand::Kind::curve ? commands::curve_text(command.curve)
                                                        : toml::toml_number(command.value);
}

/// The command of an actuator in a trial that a key of the declaration holds; null if there is none.
const DeclaredCommand* declared_in(const commands::Scene& scene, const DeclaredActuator& actuator, std::size_t trial) {
    const auto& declared = scene.declared.commands[trial];
    const auto found = declared.find(actuator.name);
    return found == declared.end() || found->second.kind == DeclaredCommand::Kind::file ? nullptr : &found->second;
}

/// Removes the commands of an actuator from all trials.
void remove_commands(const commands::Scene& scene, const DeclaredActuator& actuator,
                     std::vector<DeclarationEdit>& edits) {
    for (std::size_t t = 0; t < scene.declared.commands.size(); ++t)
        if (const DeclaredCommand* const command = declared_in(scene, actuator, t))
            edits.push_back(commands::RemoveDeclared{command_path(actuator, t, command->kind, actuator.name)});
}

/// TOML text of guides [m], 3 x n.
std::string path_text(const Eigen::Matrix3Xd& path_m) {
    std::vector<Eigen::Vector3d> guides;
    for (const auto& guide : path_m.colwise()) guides.emplace_back(guide);
    return toml::toml_list(guides, commands::place_text);
}

/// Name of an edit, for undo: "tendon/remove".
std::string item_of(const DeclaredActuator& actuator, const char* edit) {
    return std::string(actuator.table) + "/" + edit;
}

}  // namespace

DeclaredActuator declared_chamber(const commands::Scene& scene, std::size_t index) {
    return {scene.declared.chambers[index], "chamber", index, "pressure_Pa"};
}

DeclaredActuator declared_tendon(const commands::Scene& scene, std::size_t index) {
    const commands::DeclaredTendon& tendon = scene.declared.tendons[index];
    return {tendon.name, "tendon", index, tendon.by_shortening ? "shortening_m" : "tension_N"};
}

std::optional<DeclaredActuator> declared_actuator(const commands::Scene& scene, const std::string& name) {
    for (std::size_t c = 0; c < scene.declared.chambers.size(); ++c)
        if (scene.declared.chambers[c] == name) return declared_chamber(scene, c);
    for (std::size_t t = 0; t < scene.declared.tendons.size(); ++t)
        if (scene.declared.tendons[t].name == name) return declared_tendon(scene, t);
    return std::nullopt;
}

std::string free_actuator_name(const commands::WorkbenchState& state, const std::string& stem) {
    std::vector<std::string> taken = state.scene->declared.chambers;
    for (const commands::DeclaredTendon& tendon : state.scene->declared.tendons) taken.push_back(tendon.name);
    for (const commands::Muscle& muscle : state.settings.muscles) taken.push_back(muscle.name);
    for (int k = 1;; ++k)
        if (std::string name = stem + std::to_string(k); std::find(taken.begin(), taken.end(), name) == taken.end())
            return name;
}

void add_chamber(PanelContext& context, const commands::SceneCavity& cavity) {
    context.emit(commands::EditDeclaration{
        {commands::AppendDeclared{{"chamber"},
                                  "name = " + toml::toml_text(free_actuator_name(context.state, "chamber")) +
                                      "\ninside_m = " + commands::place_text(cavity.inside_m) + "\n"}},
        "chamber/add"});
}

void add_tendon(PanelContext& context, const Eigen::Matrix3Xd& path_m) {
    context.emit(commands::EditDeclaration{
        {commands::AppendDeclared{{"tendon"},
                                  "name = " + toml::toml_text(free_actuator_name(context.state, "tendon")) +
                                      "\npath_m = " + path_text(path_m) + "\ndrive = \"tension\"\n"}},
        "tendon/add"});
}

void set_tendon_path(PanelContext& context, std::size_t tendon, const Eigen::Matrix3Xd& path_m, const std::string& item,
                     bool goes_on) {
    context.emit(commands::EditDeclaration{
        {commands::SetDeclared{{"tendon", tendon, "path_m"}, path_text(path_m)}}, item, goes_on});
}

void set_tendon_drive(PanelContext& context, std::size_t tendon, bool by_shortening) {
    std::vector<DeclarationEdit> edits;
    remove_commands(*context.state.scene, declared_tendon(*context.state.scene, tendon), edits);
    edits.push_back(
        commands::SetDeclared{{"tendon", tendon, "drive"}, toml::toml_text(by_shortening ? "shortening" : "tension")});
    // Only a thread of prescribed shortening stretches.
    if (!by_shortening) edits.push_back(commands::RemoveDeclared{{"tendon", tendon, "stiffness_N_m"}});
    context.emit(commands::EditDeclaration{std::move(edits), "tendon/drive"});
}

void rename_actuator(PanelContext& context, const DeclaredActuator& actuator, const std::string& wanted) {
    const commands::Scene& scene = *context.state.scene;
    // Trials refer to the actuator by its name, so each command is written again under the new one.
    std::vector<DeclarationEdit> edits;
    remove_commands(scene, actuator, edits);
    for (std::size_t t = 0; t < scene.declared.commands.size(); ++t)
        if (const DeclaredCommand* const command = declared_in(scene, actuator, t))
            edits.push_back(
                commands::SetDeclared{command_path(actuator, t, command->kind, wanted), command_text(*command)});
    edits.push_back(commands::SetDeclared{{actuator.table, actuator.index, "name"}, toml::toml_text(wanted)});
    context.emit(commands::EditDeclaration{std::move(edits), item_of(actuator, "name")});
}

void remove_actuator(PanelContext& context, const DeclaredActuator& actuator) {
    std::vector<DeclarationEdit> edits;
    remove_commands(*context.state.scene, actuator, edits);
    edits.push_back(commands::RemoveDeclared{{actuator.table, actuator.index}});
    context.emit(commands::EditDeclaration{std::move(edits), item_of(actuator, "remove")});
}

void set_command(PanelContext& context, const DeclaredActuator& actuator, std::size_t trial,
                 const std::optional<DeclaredCommand>& command, bool goes_on) {
    std::vector<DeclarationEdit> edits;
    const DeclaredCommand* const before = declared_in(*context.state.scene, actuator, trial);
    const auto steps = [](const DeclaredCommand& c) { return c.kind == DeclaredCommand::Kind::step; };
    // A constant and a curve replace each other under one key. Only a change from or to a step leaves a key behind.
    if (before && (!command || steps(*before) != steps(*command)))
        edits.push_back(commands::RemoveDeclared{command_path(actuator, trial, before->kind, actuator.name)});
    if (command)
        edits.push_back(
            commands::SetDeclared{command_path(actuator, trial, command->kind, actuator.name), command_text(*command)});
    context.emit(commands::EditDeclaration{std::move(edits), item_of(actuator, "command/") + actuator.name, goes_on});
}

}  // namespace myo::ui::panels
