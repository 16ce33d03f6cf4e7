#include "calibration/sought_signals.hpp"

#include <algorithm>
#include <cassert>

#include "calibration/target_miss.hpp"
#include "experiment/actuators.hpp"
#include "experiment/read_trial.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::calibration {
namespace {

using experiment::ActuatorKind;

struct SoughtSignalsPolicy {
    double lowest_activation = 0.5;  // of any muscle, unless settings or [limits] say otherwise
    double beyond_trials = 1.5;      // undeclared limit, over the largest command of the trials
    /// Scale over the limit: commands then change by a fifth of their scale, as activations do, so that the smoothness
    /// means the same for all signals.
    double scales_of_limit = 3.0;
    /// Scale of a signal that nothing limits, over that of a free level: as those of muscles are, 1 and 0.1.
    double scales_of_level = 10.0;
    double first_shortening = 0.03;  // beyond that before t = 0, over the scale: tight in most poses
};
constexpr SoughtSignalsPolicy sought_signals_policy;

/// Largest magnitude of [limits] for actuators of a kind [Pa, N or m]; empty if none is declared.
std::optional<double> declared_limit(const experiment::LimitsDeclaration& limits, ActuatorKind kind) {
    switch (kind) {
        case ActuatorKind::chamber: return limits.pressure_Pa;
        case ActuatorKind::tendon_tension: return limits.tension_N;
        case ActuatorKind::tendon_shortening: return limits.shortening_m;
        case ActuatorKind::muscle: break;
    }
    return std::nullopt;
}

/// Range of the commands of a kind over all trials; limits are per kind as well.
setup::CommandRange range_of_kind(const setup::Setup& setup, ActuatorKind kind) {
    const std::vector<experiment::Actuator> all = experiment::actuators(setup.experiment);
    const std::size_t muscles = setup.experiment.muscles.size();
    setup::CommandRange range;
    for (std::size_t c = 0; c < setup.command_ranges.size(); ++c) {
        if (all[muscles + c].kind != kind) continue;
        range.lowest = std::min(range.lowest, setup.command_ranges[c].lowest);
        range.highest = std::max(range.highest, setup.command_ranges[c].highest);
    }
    return range;
}

/// Whether the signal of an actuator, or that of its leader, is sought.
bool is_sought(const setup::Setup& setup, const OptimizeSettings& settings, std::size_t actuator) {
    const std::vector<experiment::MuscleLeader> leaders = experiment::muscle_leaders(setup.experiment);
    const std::size_t leader = actuator < leaders.size() ? leaders[actuator].leader : actuator;
    return seeks_signal(settings, experiment::actuators(setup.experiment)[leader]);
}

/// Share of an actuator that keeps the signal of the trial.
inverse::SignalShare kept_signal(const setup::Setup& setup, std::size_t actuator) {
    return {.own = setup::actuator_signal(setup.experiment, setup.trials.front().model, actuator)};
}

/// Signals of the muscles that follow none, with the shares of all muscles.
void add_muscles(const setup::Setup& setup, const OptimizeSettings& settings, inverse::SoughtSignals& sought) {
    const std::vector<experiment::MuscleLeader> leaders = experiment::muscle_leaders(setup.experiment);
    const double lowest = lowest_activation(setup.experiment, settings);
    std::vector<std::size_t> signal_of(leaders.size());
    for (std::size_t m = 0; m < leaders.size(); ++m) {
        if (leaders[m].leader != m || !is_sought(setup, settings, m)) continue;
        signal_of[m] = sought.signals.size();
        sought.signals.push_back({setup.experiment.muscles[m].name, lowest, settings.highest,
                                  setup.trials.front().model.activation[m].value_before(0.0)});
    }
    for (std::size_t m = 0; m < leaders.size(); ++m) {
        const experiment::MuscleLeader& muscle = leaders[m];
        if (!is_sought(setup, settings, m)) {
            sought.groups.push_back(kept_signal(setup, m));
            continue;
        }
        sought.groups.push_back({signal_of[muscle.leader], muscle.factor});
        // A follower with the factor 0 stays passive and restricts nothing.
        if (muscle.factor == 0.0) continue;
        inverse::SoughtSignal& signal = sought.signals[sought.groups.back().signal];
        // Limits of the follower, mapped back to the leader: a_leader = 1 + (a_follower - 1) / factor.
        const double a = 1.0 + (lowest - 1.0) / muscle.factor, b = 1.0 + (settings.highest - 1.0) / muscle.factor;
        signal.lower = std::max(signal.lower, std::min(a, b));
        signal.upper = std::min(signal.upper, std::max(a, b));
    }
}

/// Signals of chambers and tendons; none follows another.
void add_commands(const setup::Setup& setup, const OptimizeSettings& settings, inverse::SoughtSignals& sought) {
    const std::vector<std::string> names = setup::actuator_names(setup.experiment);
    for (std::size_t i = setup.experiment.muscles.size(); i < names.size(); ++i) {
        if (!is_sought(setup, settings, i)) {
            sought.groups.push_back(kept_signal(setup, i));
            continue;
        }
        const setup::LevelBounds bounds = command_bounds(setup, i);
        const fibre::Signal& command = setup::actuator_signal(setup.experiment, setup.trials.front().model, i);
        sought.groups.push_back({sought.signals.size(), 1.0});
        sought.signals.push_back({names[i], bounds.lower, bounds.upper, command.value_before(0.0),
                                  setup::passive_level(setup.experiment, i), bounds.scale});
    }
}

}  // namespace

double lowest_activation(const experiment::Experiment& experiment, const OptimizeSettings& settings) {
    return settings.lowest.value_or(experiment.limits.activation.value_or(sought_signals_policy.lowest_activation));
}

std::vector<std::string> unrecorded_levels(const setup::Setup& setup, const OptimizeSettings& settings) {
    const std::vector<experiment::MuscleLeader> leaders = experiment::muscle_leaders(setup.experiment);
    const std::vector<std::string> all = setup::actuator_names(setup.experiment);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < all.size(); ++i)
        if ((i >= leaders.size() || leaders[i].leader == i) && is_sought(setup, settings, i) &&
            !level_is_on_record(setup.experiment, setup.experiment.trials.front(), i))
            names.push_back(all[i]);
    return names;
}

Eigen::MatrixXd first_values(const setup::Setup& setup, const inverse::SoughtSignals& sought) {
    Eigen::MatrixXd values = inverse::unmoved_values(sought);
    for (Eigen::Index s = 0; s < values.rows(); ++s) {
        const inverse::SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
        const std::size_t actuator = *experiment::find_actuator(setup.experiment, signal.name);
        if (experiment::actuators(setup.experiment)[actuator].kind != ActuatorKind::tendon_shortening) continue;
        values.row(s).array() += sought_signals_policy.first_shortening * signal.scale;
        values.row(s) = values.row(s).cwiseMin(signal.upper);
    }
    return values;
}

std::vector<fibre::Signal> found_commands(const inverse::SoughtSignals& sought, const Eigen::MatrixXd& values) {
    std::vector<fibre::Signal> commands = inverse::commands_of(sought, values);
    if (sought.constant || sought.hold) return commands;
    for (std::size_t g = 0; g < commands.size(); ++g) {
        // A signal of the trial is no result and stays as it is.
        if (sought.groups[g].own) continue;
        fibre::Signal& signal = commands[g];
        const std::size_t count = signal.times_s.size();
        if (count < 2 || !(signal.times_s[count - 2] < sought.end_s && sought.end_s < signal.times_s[count - 1]))
            continue;
        // The last knot moves back to the end, on the line to it.
        signal.values.back() = signal.value(sought.end_s);
        signal.times_s.back() = sought.end_s;
    }
    return commands;
}

setup::LevelBounds command_bounds(const setup::Setup& setup, std::size_t actuator) {
    const ActuatorKind kind = experiment::actuators(setup.experiment)[actuator].kind;
    assert(kind != ActuatorKind::muscle);
    const setup::LevelBounds possible = setup::level_bounds(setup.experiment, actuator);
    const setup::CommandRange range = range_of_kind(setup, kind);
    const double largest = std::max(-range.lowest, range.highest);
    const std::optional<double> limit = declared_limit(setup.experiment.limits, kind);
    if (!limit && largest == 0.0)
        return {possible.lower, possible.upper, sought_signals_policy.scales_of_level * possible.scale};
    const double most = limit.value_or(sought_signals_policy.beyond_trials * largest);
    // A device that was only driven to one side may not reach the other.
    const bool both_signs = range.lowest < 0.0 && range.highest > 0.0;
    const double lower = range.lowest < 0.0 ? -most : 0.0, upper = range.lowest < 0.0 && !both_signs ? 0.0 : most;
    return {std::max(lower, possible.lower), std::min(upper, possible.upper),
            sought_signals_policy.scales_of_limit * most};
}

inverse::SoughtSignals sought_signals(const setup::Setup& setup, const OptimizeSettings& settings, double end_s) {
    const setup::PreparedTrial& trial = setup.trials.front();
    inverse::SoughtSignals sought;
    sought.frequency_Hz = settings.frequency_Hz;
    sought.end_s = end_s;
    sought.hold = settings.hold;
    sought.constant = trial.hold;
    add_muscles(setup, settings, sought);
    add_commands(setup, settings, sought);
    if (sought.signals.empty()) return sought;
    sought.from_before = trial.options.start == dynamics::StartKind::equilibrium && !trial.hold;
    // Levels before t = 0 are sought only if none is given; otherwise those on no record are taken as passive.
    sought.seek_before = sought.from_before && unrecorded_levels(setup, settings).size() == sought.signals.size();
    return sought;
}

}  // namespace myo::calibration
