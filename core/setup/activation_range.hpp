#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/actuation_csv.hpp"

namespace myo::setup {

struct Setup;

/// The activation a of a muscle is the stretch at which its fibres are stress-free: 1 is passive, below 1 they
/// contract. At a = 0 they would contract to length zero. Programs that
/// count 0 as passive and 1 as active write such numbers; these checks reject them.

/// Checks that the recorded activations of one trial are positive.
///
/// @param table  as read_trial_actuation() returns it; rows of followers are not checked
/// Errors: the first activation <= 0 (place: its line in the actuation file).
Result<void> check_recorded_activation(const experiment::Experiment& experiment,
                                       const experiment::TrialDeclaration& trial,
                                       const measurement::ActuationTable& table);

/// Checks that the muscles' own signals, declared step levels and constant activations are positive.
///
/// Errors: the first activation <= 0 (place: line of the signal's file, or the key).
Result<void> check_declared_activation(const experiment::Experiment& experiment);

/// Readable notes on activations <= 0 that the checks accept: followers (their ratio may be fitted), and any muscle
/// with as_published.
std::vector<std::string> activation_notes(const Setup& setup);

}  // namespace myo::setup
