#include "planning/actuator_trials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "experiment/actuators.hpp"
#include "planning/round_numbers.hpp"
#include "toml/toml_text.hpp"

namespace myo::planning {
namespace {

using experiment::Actuator;
using experiment::ActuatorKind;

/// Whether a trial may set the actuator: a muscle that neither follows nor has a signal of its own, or any other.
bool can_be_set(const experiment::Experiment& experiment, const Actuator& actuator) {
    if (actuator.kind != ActuatorKind::muscle) return true;
    const experiment::MuscleDeclaration& muscle = experiment.muscles[actuator.index];
    return !muscle.follows && !muscle.signal;
}

/// Limit of an actuator of this kind, in its unit; empty: none is declared.
std::optional<double> declared_limit(const Actuator& actuator, const experiment::LimitsDeclaration& limits) {
    switch (actuator.kind) {
        case ActuatorKind::muscle: return limits.activation;
        case ActuatorKind::chamber: return limits.pressure_Pa;
        case ActuatorKind::tendon_tension: return limits.tension_N;
        case ActuatorKind::tendon_shortening: return limits.shortening_m;
    }
    return std::nullopt;
}

/// The value farthest from rest in all trials, within the declared limit; the limit where the actuator never acted.
///
/// @param number  among the actuators
double extreme_value(const setup::Setup& setup, std::size_t number, const Actuator& actuator,
                     const experiment::LimitsDeclaration& limits) {
    double extreme = actuator.rest;
    const std::size_t muscles = setup.experiment.muscles.size();
    for (const setup::PreparedTrial& trial : setup.trials) {
        const fibre::Signal& signal = number < muscles ? trial.recorded_activation[number]
                                                       : trial.recorded_commands[number - muscles];
        for (const double value : signal.values)
            if (std::abs(value - actuator.rest) > std::abs(extreme - actuator.rest)) extreme = value;
    }
    const std::optional<double> limit = declared_limit(actuator, limits);
    if (!limit) return extreme;
    if (extreme == actuator.rest) return *limit;
    // The limit holds for both senses of the deviation from rest.
    const double most = std::abs(*limit - actuator.rest);
    return actuator.rest + std::clamp(extreme - actuator.rest, -most, most);
}

/// A curve of one actuator as keys of a trial, or as a file where it is a muscle.
void set_curve(const experiment::Experiment& experiment, const Actuator& actuator,
               const std::vector<Eigen::Vector2d>& rows, PossibleTrial& trial) {
    if (actuator.kind != ActuatorKind::muscle) {
        trial.keys += experiment::constant_key(actuator.kind) + " = { " + toml::toml_key(actuator.name) + " = " +
                      toml::toml_list(rows,
                                      [](const Eigen::Vector2d& row) {
                                          return "[" + toml::toml_number(row(0)) + ", " + toml::toml_number(row(1)) +
                                                 "]";
                                      }) +
                      " }\n";
        return;
    }
    // A file of a trial states all muscles that can be set; the others stay passive, at 1.
    measurement::ActuationTable table;
    for (const Actuator& other : experiment::actuators(experiment))
        if (other.kind == ActuatorKind::muscle && can_be_set(experiment, other)) table.muscles.push_back(other.column);
    const auto count = static_cast<Eigen::Index>(rows.size());
    table.time_s.resize(count);
    table.values.setOnes(static_cast<Eigen::Index>(table.muscles.size()), count);
    const auto own = std::find(table.muscles.begin(), table.muscles.end(), actuator.column) - table.muscles.begin();
    for (Eigen::Index k = 0; k < count; ++k) {
        table.time_s(k) = rows[static_cast<std::size_t>(k)](0);
        table.values(own, k) = rows[static_cast<std::size_t>(k)](1);
    }
    trial.signal = std::move(table);
}

/// Slow rise to the extreme and a faster fall back: rows of time [s] and value.
std::vector<Eigen::Vector2d> ramp(double rest, double extreme, double duration_s, const FamilyPolicy& policy) {
    return {{0.0, rest}, {rounded(policy.ramp_up * duration_s), extreme}, {duration_s, rest}};
}

/// Between rest and the extreme, from rest and back: (1 - cos) / 2.
std::vector<Eigen::Vector2d> sine(double rest, double extreme, double duration_s, const FamilyPolicy& policy) {
    std::vector<Eigen::Vector2d> rows{{0.0, rest}};
    const double period_s = duration_s / policy.sine_periods;
    for (double t = 0.0; t < duration_s; t += policy.sample_s) {
        const double share = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * t / period_s);
        // Whole microseconds, so that the numbers of the file stay short.
        const double at = 1e-6 * std::round(1e6 * (policy.lead_s + t));
        rows.emplace_back(at, rest + rounded(share * (extreme - rest)));
    }
    return rows;
}

}  // namespace

std::vector<PossibleTrial> actuator_trials(const setup::Setup& setup, const experiment::LimitsDeclaration& limits,
                                           const TrialDurations& durations, const FamilyPolicy& policy) {
    const experiment::Experiment& experiment = setup.experiment;
    const std::vector<Actuator> all = experiment::actuators(experiment);
    // Poses are proposed only where the experiment measures some already.
    const bool holds = std::any_of(setup.trials.begin(), setup.trials.end(),
                                   [](const setup::PreparedTrial& trial) { return trial.hold; });
    const auto moving = [](double duration_s) {
        return "duration_s = " + toml::toml_number(duration_s) + "\nstart = \"equilibrium\"\n";
    };
    std::vector<PossibleTrial> trials;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Actuator& actuator = all[i];
        if (!can_be_set(experiment, actuator)) continue;
        const double extreme = extreme_value(setup, i, actuator, limits);
        const double full = actuator.rest + rounded(extreme - actuator.rest),
                     half = actuator.rest + rounded(policy.moderate * (extreme - actuator.rest));
        // No trial has used the actuator, and no limit says how far it may go.
        if (full == actuator.rest) continue;
        const std::string of = actuator.name + " ", unit = actuator.unit.empty() ? "" : " " + actuator.unit;
        const auto step = [&](const char* name, double level, double duration_s) {
            trials.push_back({name + actuator.name,
                              of + "steps to " + format_number(level) + unit + " at t = 0 and stays there for " +
                                  format_number(duration_s) + " s",
                              moving(duration_s) + "actuation_step = { " + toml::toml_key(actuator.name) + " = " +
                                  toml::toml_number(level) + " }\n"});
        };
        step("next_step_", full, durations.usual_s);
        step("next_small_step_", half, durations.usual_s);
        step("next_long_step_", full, durations.long_s);
        trials.push_back({"next_ramp_" + actuator.name,
                          of + "rises slowly to " + format_number(full) + unit + " within " +
                              format_number(policy.ramp_up * durations.long_s, 3) + " s and falls back",
                          moving(durations.long_s)});
        set_curve(experiment, actuator, ramp(actuator.rest, full, durations.long_s, policy), trials.back());
        trials.push_back({"next_sine_" + actuator.name,
                          of + "swings between rest and " + format_number(full) + unit + " with " +
                              format_number(policy.sine_periods / durations.usual_s, 3) + " Hz",
                          moving(durations.usual_s)});
        set_curve(experiment, actuator, sine(actuator.rest, full, durations.usual_s, policy), trials.back());
        if (holds)
            trials.push_back({"next_hold_" + actuator.name, "at rest with " + of + "at " + format_number(full) + unit,
                              "hold = true\n" + experiment::constant_key(actuator.kind) + " = { " +
                                  toml::toml_key(actuator.name) + " = " + toml::toml_number(full) + " }\n"});
    }
    return trials;
}

}  // namespace myo::planning
