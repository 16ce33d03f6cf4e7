#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measurement/actuation_csv.hpp"
#include "planning/planning_policy.hpp"
#include "setup/setup.hpp"

namespace myo::planning {

/// A trial that could be made.
struct PossibleTrial {
    std::string name;                                        // unique in the experiment
    std::string words;                                       // what is done, one line
    std::string keys;                                        // TOML of the trial after its name and role
    std::optional<measurement::ActuationTable> signal = {};  // of muscles, which needs a file
};

/// File of the signal of a trial that is proposed, in the folder of the experiment.
inline constexpr const char* signal_file = "next_trial_signal.csv";

/// Trials that the loads, muscles, chambers and tendons of an experiment span, within its limits:
///
/// * a force released at t = 0, in the directions across the body and of two sizes, or one that stays; a mass, straight
///   and let go; each at the places of the declared loads, or at the free end where nothing loads or drives the body;
/// * a longer release from straight;
/// * of each actuator a step, a smaller one, a slow ramp and a faster sine over the range seen in the trials;
/// * the body at rest under a force or a command.
///
/// Limits that are not declared are FamilyPolicy::beyond_seen times the largest of the trials, or a share of the body's
/// weight or mass where no trial has a load. Gravity, supports and markers are those of the experiment. Directions,
/// sizes and times are round numbers.
std::vector<PossibleTrial> trial_family(const setup::Setup& setup, const experiment::LimitsDeclaration& limits,
                                        const FamilyPolicy& policy);

/// Declaration as `[[trial]]`, of role simulate until it is recorded; its signal, if it has one, is in signal_file.
std::string trial_text(const PossibleTrial& trial);

}  // namespace myo::planning
