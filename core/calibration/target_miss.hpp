#pragma once

#include <optional>
#include <string>
#include <vector>

#include "inverse/actuation_fit.hpp"
#include "prediction/run_trials.hpp"

namespace myo::calibration {

/// When the markers follow their target, in noise levels: rms over the noise of a coordinate.
struct TargetRule {
    /// A recording leaves one level of a right model, as much again is lost to knots and cells; more is not followed.
    double reached = 3.0;
    /// So much at t = 0 is another pose, not noise: one sample of few markers scatters more than the whole trial.
    double same_pose = 5.0;
    /// Half of what a recording's own noise leaves: no search can gain what that noise would let one see.
    double met = 0.5;
    /// Markers and times belong to where the target is missed down to this share of the worst.
    double near_worst = 0.5;
    std::size_t most_markers = 3;
};

/// How far the markers of a run stay from their target, and where.
struct TargetMiss {
    struct Marker {
        std::string name;
        double rms_m = 0.0;
    };
    bool reached = true;
    double noise_m = 0.0, rms_m = 0.0;
    double noise_levels = 0.0;
    std::vector<Marker> markers;              // those that are farthest off, the worst first
    double worst_s = 0.0, worst_rms_m = 0.0;  // over the markers at that time
    double from_s = 0.0, until_s = 0.0;       // around it, as long as the error is near the worst
};

/// Of a setup's only trial.
TargetMiss target_miss(const setup::Setup& setup, const prediction::SetupRun& run, const TargetRule& rule = {});

/// A sentence on a target that is not reached: how much is left, where, when. @param before_rms_m  at the start of the
/// search
std::string sentence(const TargetMiss& miss, double before_rms_m);

/// Whether trial and muscle say which level was held before t = 0: an actuation file, a step, a signal of the muscle's
/// own.
bool level_is_on_record(const experiment::Experiment& experiment, const experiment::TrialDeclaration& trial,
                        std::size_t muscle);

/// A sentence on what is not known of a body that does not stand where its target begins; none where it does.
std::optional<std::string> start_miss(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                                      const prediction::SetupRun& run, const TargetRule& rule = {});

}  // namespace myo::calibration
