#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/recording.hpp"

namespace myo::experiment {

/// A trial's recording under the declared names, and what a person should know about it.
struct TrialRecording {
    measurement::Recording recording;
    double rounding_m = 0.0;            // step of the file's numbers, 0 where none is seen
    std::vector<std::string> warnings;  // each names its key
};

/// Reads a trial's trace and puts it under the declared names: tracks are the markers on the body in the order of their
/// declaration, then the fixed ones. Times and positions stay those of the file: clock, camera frame, metres.
///
/// A recording may name a marker by its label or by its own name. Undeclared markers are an error, except in C3D files:
/// those come straight from a camera session and hold whatever else was in view, so they are left out, with a warning.
/// A second warning: more than half of a marker's samples occluded.
/// Errors: those of the readers (place: line of the trace), a declared marker missing, an undeclared one, start_s or
/// end_s outside the recording (place: line of the key).
Result<TrialRecording> read_trial(const Experiment& experiment, const TrialDeclaration& trial);

/// read_trial() without the warnings.
Result<measurement::Recording> read_trial_recording(const Experiment& experiment, const TrialDeclaration& trial);

/// The recorded signals of a trial, one row for each declared muscle in order; a follower's row is computed from the
/// muscle it follows. Rows of muscles with an actuation_step or a signal of their own, and all rows when there is no
/// file, are 1 (passive): these are added by who runs the trial, for levels of steps may be unknown.
///
/// Errors: those of the reader, a column that is no declared muscle or one that follows or is stepped, a muscle
/// missing.
Result<measurement::ActuationTable> read_trial_actuation(const Experiment& experiment, const TrialDeclaration& trial);

/// a - 1 of a muscle is factor times (a - 1) of muscles[leader]; a muscle that follows none leads itself with factor 1.
struct MuscleLeader {
    std::size_t leader = 0;
    double factor = 1.0;
};
std::vector<MuscleLeader> muscle_leaders(const Experiment& experiment);

/// "trial[2]", for keys in messages.
std::string trial_key(const Experiment& experiment, const TrialDeclaration& trial);

}  // namespace myo::experiment
