#include "panels/command_rows.hpp"

#include "panels/command_field.hpp"
#include "panels/curve_rows.hpp"

namespace myo::ui::panels {
namespace {

using commands::DeclaredCommand;

/// Ids of the kinds of a command, as they are listed.
const char* const rest_id = "rest";
const char* const constant_id = "constant";
const char* const step_id = "step";
const char* const curve_id = "curve";
const char* const file_id = "file";

/// Id of the kind of a command; null: none.
const char* id_of(const DeclaredCommand* command) {
    if (!command) return rest_id;
    return command->kind == DeclaredCommand::Kind::constant ? constant_id
           : command->kind == DeclaredCommand::Kind::step   ? step_id
           : command->kind == DeclaredCommand::Kind::curve  ? curve_id
                                                            : file_id;
}

}  // namespace

void command_rows(PanelContext& context, const DeclaredActuator& actuator, const std::string& name,
                  NumberEdits& edits) {
    const CommandField& field = command_field(actuator);
    const commands::Scene& scene = *context.state.scene;
    const auto trial = static_cast<std::size_t>(context.state.trial);
    if (trial >= scene.declared.commands.size()) return;
    const auto found = scene.declared.commands[trial].find(actuator.name);
    const DeclaredCommand* const command = found == scene.declared.commands[trial].end() ? nullptr : &found->second;
    std::vector<commands::Choice> choices{
        {constant_id, "Constant", "Also before the start, so that an equilibrium includes it."},
        {step_id, "From the start on", "Zero before t = 0 and this value from then on."},
        {curve_id, "A curve", "Rows of time and value, linear in between."}};
    // The file is listed only where it is in use, and then without rest: a column of it can neither be made nor removed
    // here.
    if (command && command->kind == DeclaredCommand::Kind::file)
        choices.push_back({file_id, "From the trial's file",
                           "A column of the trial's actuation file, which alone changes or removes it."});
    else
        choices.insert(choices.begin(), {rest_id, "None", "Zero in this trial."});
    std::string chosen = id_of(command);
    const std::string before = chosen;
    const std::string label = field.quantity + " in " + scene.trials[trial].name;
    if (choice_row(context, field.quantity, name + "/kind", label + ".", choices, chosen) && chosen != before &&
        chosen != file_id) {
        std::optional<DeclaredCommand> wanted;
        // A change of kind keeps the value. A zero one, as of a curve that begins at 0, would show no motion.
        const double value = command && command->value != 0.0 ? command->value : field.usual;
        if (chosen == curve_id)
            wanted = DeclaredCommand{DeclaredCommand::Kind::curve, 0.0, new_curve(value)};
        else if (chosen != rest_id)
            wanted = DeclaredCommand{
                chosen == constant_id ? DeclaredCommand::Kind::constant : DeclaredCommand::Kind::step, value};
        set_command(context, actuator, trial, wanted, false);
    }
    // Neither rest nor a file has numbers to edit.
    if (!command || command->kind == DeclaredCommand::Kind::file) return;
    DeclaredCommand changed = *command;
    if (command->kind == DeclaredCommand::Kind::curve) {
        const NumberField value{field.quantity, name + "/curve", field.dimension,     field.unit,
                                label + ".",    field.limits,    field.smallest_step, field.quantity};
        const auto edit = curve_rows(context, value, edits, command->curve, actuator.name + scene.trials[trial].name);
        if (!edit) return;
        changed.curve = edit->curve;
        return set_command(context, actuator, trial, changed, edit->goes_on);
    }
    bool goes_on = false;
    const NumberField row{"Value",     name + "/value", field.dimension,     field.unit,
                          label + ".", field.limits,    field.smallest_step, field.quantity};
    if (number_row(context, row, edits, changed.value, goes_on, actuator.name + scene.trials[trial].name))
        set_command(context, actuator, trial, changed, goes_on);
}

}  // namespace myo::ui::panels
