#include "setup/activation_range.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "measurement/text_table.hpp"
#include "setup/setup.hpp"

namespace myo::setup {
namespace {

/// Sentence on an activation that no fibre can have.
std::string out_of_range(const std::string& muscle, double a) {
    return "muscle " + muscle + " has the activation " + format_number(a) +
           ", which must be above 0: it is the stretch that the fibres seek, 1 is passive and below 1 they contract";
}

/// Error at the line of a row in a file; at the key if the rows have no line numbers.
Error row_error(const experiment::Experiment& experiment, const std::string& key, const std::filesystem::path& file,
                const std::vector<int>& lines, std::size_t row, const std::string& sentence) {
    if (row >= lines.size()) return experiment::declaration_error(experiment, key, sentence);
    return {key + ": " + sentence, measurement::at_line(file, lines[row])};
}

}  // namespace

Result<void> check_recorded_activation(const experiment::Experiment& experiment,
                                       const experiment::TrialDeclaration& trial,
                                       const measurement::ActuationTable& table) {
    // Row by row, so that the first bad line of the file is reported.
    for (Eigen::Index row = 0; row < table.values.cols(); ++row)
        for (std::size_t m = 0; m < experiment.muscles.size(); ++m) {
            const double a = table.values(static_cast<Eigen::Index>(m), row);
            // A follower's activation depends on its ratio; it is only noted, see activation_notes().
            if (experiment.muscles[m].follows || a > 0.0) continue;
            return row_error(experiment, experiment::trial_key(experiment, trial) + ".actuation",
                             trial.actuation.value_or(""), table.lines, static_cast<std::size_t>(row),
                             out_of_range(experiment.muscles[m].name, a));
        }
    return {};
}

Result<void> check_declared_activation(const experiment::Experiment& experiment) {
    for (std::size_t m = 0; m < experiment.muscles.size(); ++m) {
        const experiment::MuscleDeclaration& muscle = experiment.muscles[m];
        if (!muscle.signal) continue;
        const auto low = std::find_if(muscle.signal->values.begin(), muscle.signal->values.end(),
                                      [](double a) { return !(a > 0.0); });
        if (low == muscle.signal->values.end()) continue;
        // Signal keeps no line numbers, so the file is read again only when there is an error to locate.
        const Result<measurement::ActuationTable> file = muscle.signal_file
                                                             ? measurement::read_actuation_csv(*muscle.signal_file)
                                                             : Result<measurement::ActuationTable>(
                                                                   measurement::ActuationTable{});
        const auto row = static_cast<std::size_t>(low - muscle.signal->values.begin());
        return row_error(experiment, "muscle[" + std::to_string(m) + "].signal", muscle.signal_file.value_or(""),
                         file ? file->lines : std::vector<int>{}, row, out_of_range(muscle.name, *low));
    }
    // Pressures of chambers may have any sign: below 0 is suction.
    const auto is_low = [&](const std::string& actuator, double a) {
        return !(a > 0.0) && std::any_of(experiment.muscles.begin(), experiment.muscles.end(),
                                         [&](const experiment::MuscleDeclaration& m) { return m.name == actuator; });
    };
    for (std::size_t t = 0; t < experiment.trials.size(); ++t) {
        const std::string key = "trial[" + std::to_string(t) + "].";
        for (const experiment::ActuationStep& step : experiment.trials[t].actuation_steps)
            if (step.level && is_low(step.muscle, *step.level))
                return experiment::declaration_error(experiment, key + "actuation_step." + step.muscle,
                                                     out_of_range(step.muscle, *step.level));
        for (const experiment::ConstantCommand& command : experiment.trials[t].constant_commands)
            if (is_low(command.actuator, command.value))
                return experiment::declaration_error(experiment, key + "activation." + command.actuator,
                                                     out_of_range(command.actuator, command.value));
    }
    return {};
}

std::vector<std::string> activation_notes(const Setup& setup) {
    std::vector<std::string> notes;
    for (std::size_t m = 0; m < setup.experiment.muscles.size(); ++m) {
        const experiment::MuscleDeclaration& muscle = setup.experiment.muscles[m];
        // The trials hold the activation after followers and steps are applied, so each muscle is checked as it is
        // simulated.
        double lowest = std::numeric_limits<double>::infinity();
        for (const PreparedTrial& trial : setup.trials) {
            const std::vector<double>& values = trial.model.activation[m].values;
            lowest = std::min(lowest, *std::min_element(values.begin(), values.end()));
        }
        if (lowest > 0.0) continue;
        notes.push_back(
            "muscle[" + std::to_string(m) + "]: the activation of " + muscle.name + " falls to " +
            format_number(lowest) +
            (muscle.follows ? ", for it follows " + muscle.follows->muscle : ", as published formulations allow") +
            "; 1 is passive, and fibres that seek a stretch of 0 or below are not physical");
    }
    return notes;
}

}  // namespace myo::setup
