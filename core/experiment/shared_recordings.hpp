#pragma once

#include <string>
#include <vector>

#include "experiment/experiment.hpp"

namespace myo::experiment {

/// A validate trial that has the recording of a fit trial, so that predicting it tests nothing.
struct SharedRecording {
    std::size_t fit = 0, validate = 0;  // trials of the experiment
};

/// All such pairs, the first fit trial for each validate trial: traces that are one file or files of the same content,
/// and whose windows start_s ... end_s have times in common. Two parts of one recording are two recordings. A file that
/// cannot be read is in no pair.
std::vector<SharedRecording> shared_recordings(const Experiment& experiment);

/// "trial[1].trace: ...", for a person.
std::string shared_recording_sentence(const Experiment& experiment, const SharedRecording& shared);

}  // namespace myo::experiment
