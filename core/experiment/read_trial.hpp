#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/recording.hpp"

namespace myo::experiment {

/// Recording of a trial under the declared marker names, with the warnings of reading.
struct TrialRecording {
    measurement::Recording recording;   // 3 x n per marker [m], camera frame, file time [s]; NaN where occluded
    double rounding_m = 0.0;            // increment of the numbers in the file [m], 0 if none is detected
    std::vector<std::string> warnings;  // each names its key
};

/// Reads the trace of a trial and orders its tracks: markers on the body in the order of declaration, then the fixed
/// ones. Probes are not in the trace and seen in no sample. Times and positions stay in the file's clock and camera
/// frame [s, m].
///
/// A recording may name a marker by its label or by its declared name, both also as "subject:name" where that is
/// unique. Undeclared markers are an error, except in files of camera systems, which contain everything in view: there
/// they are dropped with a warning. Faults are corrected, see correct_faults(); each correction gives a warning, as
/// does a marker occluded in more than half of the samples. Then the trial's repairs are made, see repair_trace(), and
/// reported. Positions are turned by the trial's `axes`.
///
/// A trial of role simulate has output times from 0 to the first multiple of the policy's interval at or after its
/// duration, at which only the markers on the body are listed and none is seen.
/// Errors: those of the readers (place: line of the trace), content of another format than the declared one, a declared
/// marker missing or ambiguous, an undeclared one, start_s or end_s outside the recording, a repair that cannot be made
/// (place: line of the key).
Result<TrialRecording> read_trial(const Experiment& experiment, const TrialDeclaration& trial);

/// read_trial() without the warnings. Errors: those of read_trial().
Result<measurement::Recording> read_trial_recording(const Experiment& experiment, const TrialDeclaration& trial);

/// Recorded and constant commands of a trial.
///
/// @return   values actuators x times, rows in the order of actuators(): activations [-], pressures [Pa], tensions [N],
///           shortenings [m]. A follower's row is computed from its leader's. Rows of actuators with an actuation_step
///           or their own signal are at rest (muscle 1, else 0): prepare_setup() adds these because the levels of steps
///           may be unknown. Actuators without a command are at rest
/// Errors: those of the reader; a column of no actuator, of one that follows, is stepped or has a constant; a muscle
/// missing; a negative tension (place: line of the file).
Result<measurement::ActuationTable> read_trial_actuation(const Experiment& experiment, const TrialDeclaration& trial);

/// End of a chain of followers: a - 1 of a muscle is `factor` times (a - 1) of muscles[leader].
struct MuscleLeader {
    std::size_t leader = 0;  // index into Experiment::muscles
    double factor = 1.0;     // product of the ratios along the chain; 1 for a muscle that follows none
};
/// One entry per declared muscle, in the order of declaration.
std::vector<MuscleLeader> muscle_leaders(const Experiment& experiment);

/// Key of a trial in messages, "trial[2]"; "trial" if the experiment has none of this name.
std::string trial_key(const Experiment& experiment, const TrialDeclaration& trial);

}  // namespace myo::experiment
