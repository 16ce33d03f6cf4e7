#include "backend/found_commands.hpp"

#include <algorithm>

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

/// Rows "[t_s, value]" from t = 0 on.
std::string rows_of(const fibre::Signal& signal) {
    std::vector<Eigen::Vector2d> rows;
    for (std::size_t k = 0; k < signal.times_s.size(); ++k)
        if (signal.times_s[k] >= 0.0) rows.emplace_back(signal.times_s[k], signal.values[k]);
    return toml::toml_list(rows, [](const Eigen::Vector2d& row) {
        return toml::toml_list(row, [](double number) { return toml::toml_number(number); });
    });
}

}  // namespace

std::vector<ui::commands::DeclarationEdit> found_command_edits(const experiment::Experiment& experiment,
                                                               std::size_t trial,
                                                               const std::vector<fibre::Signal>& commands) {
    std::vector<ui::commands::DeclarationEdit> edits;
    const std::vector<experiment::Actuator> actuators = experiment::actuators(experiment);
    const experiment::TrialDeclaration& declared = experiment.trials[trial];
    for (std::size_t i = 0; i < actuators.size() && i < commands.size(); ++i) {
        if (actuators[i].kind == experiment::ActuatorKind::muscle) continue;
        if (is_recorded(declared, actuators[i])) return {};
        edits.push_back(RemoveDeclared{{"trial", trial, "actuation_step", actuators[i].name}});
        const bool is_constant = declared.hold || commands[i].times_s.size() < 2;
        edits.push_back(SetDeclared{{"trial", trial, experiment::constant_key(actuators[i].kind), actuators[i].name},
                                    is_constant ? toml::toml_number(commands[i].value(0.0)) : rows_of(commands[i])});
    }
    return edits;
}

}  // namespace myo::backend
