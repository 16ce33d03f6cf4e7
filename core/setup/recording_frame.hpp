#pragma once

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

/// Significant digits of times of other clocks in messages: of a Unix time ten are seconds.
inline constexpr int clock_digits = 12;

/// Whether a trial's file was recorded without regard to t = 0 or to the mesh frame (the schema's last section): it
/// holds samples from before the start. Otherwise file time and trial time are the same.
bool is_foreign_recording(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration);

/// Puts a trial's recording into the mesh frame and the trial's time: fills measured, first_sample, start_s,
/// start_found, reference_m, registration_rms_m, occluded_fraction.
///
/// recording: declared markers on the body first, then the fixed ones; camera frame, file time.
/// Errors: file times far from t = 0 where they are to be the trial's, no start to be found, no rest pose before it, no
/// rigid fit; nothing left between start_s and end_s.
Result<void> place_recording(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration,
                             const measurement::Recording& recording, PreparedTrial& trial);

/// Sentences on trials whose clock or frame is probably not what was meant: one that begins long after t = 0, one whose
/// markers are far from their declared places at rest.
std::vector<std::string> doubtful_frames(const Setup& setup);

}  // namespace myo::setup
