#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/actuation_csv.hpp"

namespace myo::setup {

struct Setup;

/// The activation a of a muscle is the stretch that its fibres seek: 1 is passive, below 1 they contract. At 0 they
/// would contract to nothing; programs that count 0 as passive and 1 as active write such numbers.

/// Errors: the first activation of 0 or below in a trial's actuation file (place: its line), of a muscle that follows
/// none.
/// @param table  as read_trial_actuation() returns it
Result<void> check_recorded_activation(const experiment::Experiment& experiment,
                                       const experiment::TrialDeclaration& trial,
                                       const measurement::ActuationTable& table);

/// Errors: the same of the muscles' own signals (place: line of the signal's file, or its key) and of the levels of
/// steps (their keys).
Result<void> check_declared_activation(const experiment::Experiment& experiment);

/// What is let through, for a person: followers that reach 0 or below, as fitted ones may, and, as published, any
/// muscle.
std::vector<std::string> activation_notes(const Setup& setup);

}  // namespace myo::setup
