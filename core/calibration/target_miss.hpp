#pragma once

#include <optional>
#include <string>
#include <vector>

#include "inverse/actuation_fit.hpp"
#include "prediction/run_trials.hpp"

namespace myo::calibration {

/// When a target counts as reached, in noise levels: rms over the noise of a coordinate.
struct TargetRule {
    /// A correct model leaves one level of the recording, knots and cells add about as much; more is a miss.
    double reached = 3.0;
    /// Above this the body at t = 0 is in another pose: one sample of few markers scatters more than a whole trial.
    double same_pose = 5.0;
    /// Half of what a recording's own noise leaves: a search cannot gain more than that noise would reveal.
    double met = 0.5;
    /// Markers and times above this share of the worst are reported.
    double near_worst = 0.5;
    std::size_t max_markers = 3;
};

/// Distance of a run from its target, with the worst markers and times.
struct TargetMiss {
    /// A marker and its error.
    struct Marker {
        std::string name;
        double rms_m = 0.0;
    };
    bool goals = false;                       // the target are goals, no recording
    bool reached = true;                      // rms below TargetRule::reached
    double noise_m = 0.0, rms_m = 0.0;        // of a coordinate, over the trial
    double noise_levels = 0.0;                // rms_m / noise_m
    std::vector<Marker> markers;              // the worst ones, largest error first
    double worst_s = 0.0, worst_rms_m = 0.0;  // time of the largest error and its rms over the markers
    double from_s = 0.0, until_s = 0.0;       // interval around worst_s in which the error is close to the largest
};

/// Distance to the target for a setup with a single trial.
///
/// @param run  complete run of that trial
TargetMiss target_miss(const setup::Setup& setup, const prediction::SetupRun& run, const TargetRule& rule = {});

/// Readable sentence on a target that is not reached: remaining distance, markers and times.
///
/// @param before_rms_m  distance at the start of the search
std::string sentence(const TargetMiss& miss, double before_rms_m);

/// Whether the level before t = 0 is given: by an actuation file, a step, a constant command, or a muscle's own signal.
///
/// @param actuator  number, see actuator_signals.hpp
bool level_is_on_record(const experiment::Experiment& experiment, const experiment::TrialDeclaration& trial,
                        std::size_t actuator);

/// Warning if the body at t = 0 is not in the pose of the target, with the likely cause; empty otherwise.
std::optional<std::string> start_miss(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                                      const prediction::SetupRun& run, const TargetRule& rule = {});

}  // namespace myo::calibration
