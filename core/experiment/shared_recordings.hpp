#pragma once

#include <string>
#include <vector>

#include "experiment/experiment.hpp"

namespace myo::experiment {

/// A validation trial that uses the recording of a fit trial, so that its prediction is no independent test.
struct SharedRecording {
    std::size_t fit = 0, validate = 0;  // indices into Experiment::trials
};

/// All such pairs, with the first matching fit trial for each validation trial.
///
/// A pair has the same file, or two files of equal content, and overlapping windows start_s ... end_s. Disjoint parts
/// of one recording are independent recordings. A file that cannot be read is in no pair. Files are read in full only
/// if their sizes agree.
std::vector<SharedRecording> shared_recordings(const Experiment& experiment);

/// Readable warning "trial[1].trace: ..." for one pair.
std::string shared_recording_sentence(const Experiment& experiment, const SharedRecording& shared);

}  // namespace myo::experiment
