#pragma once

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

struct RecordingFramePolicy {
    /// Significant digits for times of other clocks in messages; ten digits of a Unix time are whole seconds.
    int clock_digits = 12;
    /// Registration residual over the longest extent of the body, above which a wrong label or pose is likely.
    double far_of_body = 0.03;
    /// Time without sight of the mount above which a warning is given [s]: machines and hands change their motion
    /// within a tenth of a second.
    double mount_gap_s = 0.1;
};
inline constexpr RecordingFramePolicy recording_frame_policy;

/// Whether a recording was made without regard to t = 0 or the mesh frame, so that it contains samples before the start
/// (assets/manual/experiment.md, section 4). Otherwise file time equals trial time.
bool is_foreign_recording(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration);

/// Transforms a recording into the mesh frame and trial time.
///
/// @param recording  markers on the body in the order of declaration, then the fixed ones; camera frame [m], file time
///                   [s]
/// @param trial      receives measured, first_sample, start_s, start_found, start_message, reference_m,
///                   registration_rms_m, occluded_fraction, mount and mount_gap_s
/// Errors: times far from t = 0 that should be trial times, no start of motion, no rest pose before it, no rigid fit,
/// a mount whose markers are not seen, a marker not seen before the start where displacements are compared, no sample
/// between start_s and end_s.
Result<void> place_recording(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration,
                             const measurement::Recording& recording, PreparedTrial& trial);

/// Warnings about trials with a suspicious clock or frame: the trace begins long after t = 0, or the markers at rest
/// are far from their declared positions.
std::vector<std::string> doubtful_frames(const Setup& setup);

}  // namespace myo::setup
