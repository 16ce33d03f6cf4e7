#include <algorithm>

#include "experiment/actuators.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"

namespace myo::experiment {
namespace {

/// Questions about the commands of one trial, by actuator.
struct TrialCommands {
    const Experiment& experiment;
    const TrialDeclaration& trial;
    std::vector<Actuator> all;

    const MuscleDeclaration* muscle(const Actuator& actuator) const {
        return actuator.kind == ActuatorKind::muscle ? &experiment.muscles[actuator.index] : nullptr;
    }
    /// Muscles only: chambers and tendons are driven per trial.
    bool has_signal(const Actuator& actuator) const {
        return muscle(actuator) != nullptr && muscle(actuator)->signal.has_value();
    }
    /// Levels of steps may be fitted, so prepare_setup() adds them.
    bool stepped(const Actuator& actuator) const {
        return std::any_of(trial.actuation_steps.begin(), trial.actuation_steps.end(),
                           [&](const ActuationStep& step) { return step.muscle == actuator.name; });
    }
    /// Constant or curve of an actuator in this trial; null if there is none.
    const ConstantCommand* constant(const Actuator& actuator) const {
        for (const ConstantCommand& command : trial.constant_commands)
            if (command.actuator == actuator.name) return &command;
        return nullptr;
    }
    /// Name of the recorded commands in messages.
    std::string recorded_name() const {
        return trial.tried_actuation ? "the tried signal" : trial.actuation->filename().string();
    }
    // Neither a follower nor with a step, a constant or a signal of its own.
    bool recordable(const Actuator& actuator) const {
        const bool follows = muscle(actuator) != nullptr && muscle(actuator)->follows;
        return !follows && !has_signal(actuator) && !stepped(actuator) && constant(actuator) == nullptr;
    }
};

/// Reason why a column of the actuation file cannot be used; empty if it can.
std::string column_fault(const TrialCommands& commands, const std::string& column) {
    for (const Actuator& actuator : commands.all) {
        if (actuator.column != column) {
            // The name without its unit, or with that of another drive.
            const bool near_miss = column == actuator.name ||
                                   (commands.muscle(actuator) == nullptr && column.starts_with(actuator.name + "_"));
            if (near_miss && !std::any_of(commands.all.begin(), commands.all.end(),
                                          [&](const Actuator& other) { return other.column == column; }))
                return "but the column of \"" + actuator.name + "\" is \"" + actuator.column + "\"";
            continue;
        }
        // A recorded column of a muscle with a signal of its own is allowed and not used: the file may serve other
        // experiments.
        if (commands.has_signal(actuator) || commands.recordable(actuator)) return "";
        const MuscleDeclaration* muscle = commands.muscle(actuator);
        if (muscle != nullptr && muscle->follows)
            return "a muscle that follows \"" + muscle->follows->muscle + "\" and has no signal of its own";
        if (const ConstantCommand* constant = commands.constant(actuator))
            return "whose signal is declared by " + constant->key + " as well";
        return "whose signal is declared by actuation_step as well";
    }
    const bool only_muscles = commands.all.size() == commands.experiment.muscles.size();
    return only_muscles ? "which is no declared muscle" : "which is no declared muscle, chamber or tendon";
}

/// Recorded rows; a muscle without a column is an error, a chamber or tendon without one rests.
Result<void> fill_recorded(const TrialCommands& commands, const std::string& key,
                           const measurement::ActuationTable& recorded, measurement::ActuationTable& table) {
    const std::string file = commands.recorded_name();
    for (std::size_t i = 0; i < commands.all.size(); ++i) {
        const Actuator& actuator = commands.all[i];
        if (!commands.recordable(actuator)) continue;
        const auto column = std::find(recorded.muscles.begin(), recorded.muscles.end(), actuator.column);
        if (column == recorded.muscles.end()) {
            if (actuator.kind != ActuatorKind::muscle) continue;
            return declaration_error(commands.experiment, key,
                                     file + " has no column \"" + actuator.name + "\", a declared muscle");
        }
        // Rows are in the order of actuators(), whatever the order of the columns.
        const auto row = static_cast<Eigen::Index>(i);
        table.values.row(row) = recorded.values.row(column - recorded.muscles.begin());
        Eigen::Index lowest = 0;
        if (actuator.kind == ActuatorKind::tendon_tension && table.values.row(row).minCoeff(&lowest) < 0.0)
            return Error{key + ": column \"" + actuator.column + "\" holds a negative tension; a tendon never pushes",
                         recorded.lines.empty() ? file
                                                : commands.trial.actuation->string() + ":" +
                                                      std::to_string(recorded.lines[static_cast<std::size_t>(lowest)])};
    }
    return {};
}

/// Values without a recording: constants (of a curve that at t = 0), and rest for all others.
void fill_constants(const TrialCommands& commands, measurement::ActuationTable& table) {
    table.values.resize(static_cast<Eigen::Index>(commands.all.size()), table.time_s.size());
    for (std::size_t i = 0; i < commands.all.size(); ++i) {
        const ConstantCommand* constant = commands.constant(commands.all[i]);
        table.values.row(static_cast<Eigen::Index>(i))
            .setConstant(constant != nullptr ? constant->value : commands.all[i].rest);
    }
}

// Followers are linear in a - 1, so passive (a = 1) stays passive.
void fill_followers(const Experiment& experiment, Eigen::MatrixXd& values) {
    const std::vector<MuscleLeader> leaders = muscle_leaders(experiment);
    for (std::size_t i = 0; i < leaders.size(); ++i)
        if (leaders[i].leader != i)
            values.row(static_cast<Eigen::Index>(
                i)) = 1.0 +
                      leaders[i].factor * (values.row(static_cast<Eigen::Index>(leaders[i].leader)).array() - 1.0);
}

}  // namespace

Result<measurement::ActuationTable> read_trial_actuation(const Experiment& experiment, const TrialDeclaration& trial) {
    const TrialCommands commands{experiment, trial, actuators(experiment)};
    measurement::ActuationTable table;
    for (const Actuator& actuator : commands.all) table.muscles.push_back(actuator.name);
    // One sample without a recording: Signal extends its first and last value to all times.
    table.time_s = Eigen::VectorXd::Zero(1);
    if (!trial.actuation && !trial.tried_actuation) {
        fill_constants(commands, table);
        fill_followers(experiment, table.values);
        return table;
    }
    const std::string key = trial_key(experiment, trial) + ".actuation";
    const Result<measurement::ActuationTable> recorded = trial.tried_actuation
                                                             ? *trial.tried_actuation
                                                             : measurement::read_actuation_csv(*trial.actuation);
    if (!recorded) return Error{key + ": " + recorded.error().what, recorded.error().where};
    for (const std::string& warning : recorded->warnings) table.warnings.push_back(key + ": " + warning);
    for (const std::string& column : recorded->muscles)
        if (const std::string fault = column_fault(commands, column); !fault.empty())
            return declaration_error(experiment, key,
                                     commands.recorded_name() + " has a column \"" + column + "\", " + fault);
    // Constants and rest first: rows of the recording then replace those that it contains.
    table.time_s = recorded->time_s;
    table.lines = recorded->lines;
    fill_constants(commands, table);
    if (const Result<void> filled = fill_recorded(commands, key, *recorded, table); !filled) return filled.error();
    fill_followers(experiment, table.values);
    return table;
}

}  // namespace myo::experiment
