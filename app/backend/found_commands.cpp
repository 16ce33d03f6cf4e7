#include "backend/found_commands.hpp"

#include <algorithm>

#include "commands/curve_text.hpp"
#include "experiment/actuators.hpp"
#include "measurement/actuation_csv.hpp"
#include "toml/toml_text.hpp"

namespace myo::backend {
namespace {

using ui::commands::RemoveDeclared;
using ui::commands::SetDeclared;

/// Whether the actuation file of a trial holds commands of an actuator; true as well if it cannot be read.
bool is_recorded(const experiment::TrialDeclaration& trial, const experiment::Actuator& actuator) {
    if (!trial.actuation) return false;
    const Result<measurement::ActuationTable> table = measurement::read_actuation_csv(*trial.actuation);
    return !table || std::find(table->muscles.begin(), table->muscles.end(), actuator.column) != table->muscles.end();
}

}  // namespace

std::vector<ui::commands::DeclarationEdit> found_command_edits(
    const experiment::Experiment& experiment, std::size_t trial,
    const std::vector<std::optional<fibre::Signal>>& commands) {
    std::vector<ui::commands::DeclarationEdit> edits;
    const std::vector<experiment::Actuator> actuators = experiment::actuators(experiment);
    const experiment::TrialDeclaration& declared = experiment.trials[trial];
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (!commands[i]) continue;
        const fibre::Signal& command = *commands[i];
        // Muscles come first in actuators() and are set in the window, not declared.
        const experiment::Actuator& actuator = actuators[experiment.muscles.size() + i];
        // A column of the file would contradict a key of the trial, so nothing is declared at all.
        if (is_recorded(declared, actuator)) return {};
        // A step and a command of one actuator exclude each other; removing what is not there is no error.
        edits.push_back(RemoveDeclared{{"trial", trial, "actuation_step", actuator.name}});
        const bool is_constant = declared.hold || command.times_s.size() < 2;
        edits.push_back(
            SetDeclared{{"trial", trial, experiment::constant_key(actuator.kind), actuator.name},
                        is_constant ? toml::toml_number(command.value(0.0)) : ui::commands::curve_text(command)});
    }
    return edits;
}

}  // namespace myo::backend
