#include "experiment/read_trial.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/recording_faults.hpp"
#include "measurement/marker_labels.hpp"

namespace myo::experiment {
namespace {

/// Tracks that a marker may mean, by label or, if the label does not occur, by name.
std::vector<std::size_t> find_tracks(const std::vector<std::string>& labels, const MarkerDeclaration& marker) {
    // The label has precedence: a declared name may occur in the file as the label of another marker.
    const std::vector<std::size_t> found = measurement::find_labels(labels, marker.label);
    return found.empty() ? measurement::find_labels(labels, marker.name) : found;
}

// A sample counts as occluded if any coordinate is missing.
Eigen::Index occluded_samples(const Eigen::Matrix3Xd& track) {
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < track.cols(); ++t) count += track.col(t).array().isNaN().any() ? 1 : 0;
    return count;
}

// Tracks in declared order under declared names; `unused` receives the labels that are not declared.
Result<measurement::Recording> rename_tracks(const Experiment& experiment, const TrialDeclaration& trial,
                                             measurement::Recording raw, std::vector<std::string>& unused) {
    const std::string key = trial_key(experiment, trial) + ".trace";
    const std::string file = trial.trace.filename().string();
    measurement::Recording renamed;
    renamed.time_s = raw.time_s;
    renamed.rate_Hz = raw.rate_Hz;
    renamed.metres_per_unit = raw.metres_per_unit;
    std::vector<bool> used(raw.labels.size(), false);
    // Every declared marker needs one track of its own, by a name that fits no other.
    for (const MarkerDeclaration& marker : recorded_markers(experiment.markers)) {
        const std::vector<std::size_t> tracks = find_tracks(raw.labels, marker);
        if (tracks.empty())
            return declaration_error(experiment, key,
                                     file + " has no marker \"" + marker.label + "\"" +
                                         (marker.label == marker.name ? "" : " (the label of " + marker.name + ")") +
                                         "; it has " + quoted_list(raw.labels));
        if (tracks.size() > 1)
            return declaration_error(experiment, key,
                                     "\"" + marker.name + "\" may be \"" + raw.labels[tracks[0]] + "\" or \"" +
                                         raw.labels[tracks[1]] + "\" of " + file + "; name one in markers.labels");
        const std::size_t track = tracks.front();
        if (used[track])
            return declaration_error(experiment, key,
                                     file + " names two declared markers \"" + raw.labels[track] + "\"");
        used[track] = true;
        renamed.labels.push_back(marker.name);
        renamed.tracks.push_back(std::move(raw.tracks[track]));
        // Residuals of reconstruction are per track, if the format has them.
        if (!raw.residual_m.empty()) renamed.residual_m.push_back(std::move(raw.residual_m[track]));
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i]) unused.push_back(raw.labels[i]);
    return renamed;
}

/// Adds the tracks of the probes, which no camera sees, behind those of the other markers on the body.
void add_probes(const Experiment& experiment, measurement::Recording& recording) {
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Index count = recording.sample_count();
    // Tracks end with the fixed markers, so a probe goes before them: the order of declaration is kept.
    const auto at = [&](auto& list) {
        return list.end() - static_cast<std::ptrdiff_t>(experiment.markers.fixed.size());
    };
    for (const MarkerDeclaration& marker : experiment.markers.on_body) {
        if (!marker.probe) continue;
        recording.labels.insert(at(recording.labels), marker.name);
        recording.tracks.insert(at(recording.tracks), Eigen::Matrix3Xd::Constant(3, count, unseen));
        if (!recording.residual_m.empty())
            recording.residual_m.insert(at(recording.residual_m), Eigen::VectorXd::Constant(count, unseen));
    }
}

// The window must meet the recording: start_s lies in it, before its last sample, and end_s after its first. A window
// between two neighbouring samples passes.
Result<void> check_window(const Experiment& experiment, const TrialDeclaration& trial,
                          const measurement::Recording& recording) {
    const std::string path = trial_key(experiment, trial);
    const double first = recording.time_s[0], last = recording.time_s[recording.time_s.size() - 1];
    const std::string extent = "the recording runs from " + format_number(first) + " s to " + format_number(last) +
                               " s";
    if (trial.start_s && (*trial.start_s < first || *trial.start_s >= last))
        return declaration_error(experiment, path + ".start_s",
                                 format_number(*trial.start_s) + " s is outside: " + extent);
    if (trial.end_s && *trial.end_s <= first)
        return declaration_error(experiment, path + ".end_s",
                                 format_number(*trial.end_s) + " s leaves no sample: " + extent);
    return {};
}

/// Reads the file of a trial and turns it to the axes of the mesh frame.
Result<measurement::Recording> read_trace_of(const Experiment& experiment, const TrialDeclaration& trial) {
    const std::string key = trial_key(experiment, trial);
    Result<measurement::Recording> raw = measurement::read_trace(
        trial.trace, {trial.format, trial.columns, trial.metres_per_unit, trial.seconds_per_unit});
    if (!raw) {
        // A declared format that the content contradicts is the likely reason.
        const Result<measurement::TraceSource> content = measurement::guess_trace_source(trial.trace);
        if (content && !content->columns && content->format != trial.format)
            return declaration_error(experiment, key + ".format",
                                     trial.trace.filename().string() + " is no \"" + trial.format +
                                         "\" file, but one of format = \"" + content->format + "\"");
        return Error{key + ".trace: " + raw.error().what, raw.error().where};
    }
    // Residuals of reconstruction are lengths and need no turn.
    if (trial.axes)
        for (Eigen::Matrix3Xd& track : raw->tracks) track = Eigen::Matrix3Xd(*trial.axes * track);
    return raw;
}

/// Advice where the recording's y axis is likely to point up and nothing turns it to the mesh frame; otherwise empty.
std::string unturned_axes(const Experiment& experiment, const TrialDeclaration& trial) {
    const measurement::TraceReader& reader = *measurement::find_trace_reader(trial.format);
    if (!reader.is_y_up || trial.axes || !experiment.registration.known) return {};
    return "exports of " + reader.label +
           " have y upwards; axes = [\"x\", \"-z\", \"y\"] turns it to z, and axes = "
           "[\"x\", \"y\", \"z\"] states that it is right";
}

/// Output times of a trial without a recording; no marker is seen. A hold is one pose.
measurement::Recording planned_times(const Experiment& experiment, const TrialDeclaration& trial) {
    measurement::Recording planned;
    planned.rate_Hz = planned_trial_policy.rate_Hz;
    // The last time is at or after the end; 1e-9 keeps rounding of a whole number of intervals from adding one.
    const auto count = static_cast<Eigen::Index>(std::ceil(trial.duration_s * planned.rate_Hz - 1e-9)) + 1;
    planned.time_s = Eigen::VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1) / planned.rate_Hz);
    for (const MarkerDeclaration& marker : experiment.markers.on_body) {
        planned.labels.push_back(marker.name);
        planned.tracks.push_back(Eigen::Matrix3Xd::Constant(3, count, std::numeric_limits<double>::quiet_NaN()));
    }
    return planned;
}

/// The repairs that the trial declares, in their order. Each adds a warning, as a correction does.
Result<void> make_repairs(const Experiment& experiment, const TrialDeclaration& trial, TrialRecording& read) {
    for (std::size_t r = 0; r < trial.repairs.size(); ++r) {
        const std::string key = trial_key(experiment, trial) + ".repair[" + std::to_string(r) + "]";
        const Result<Eigen::Index> changed = measurement::repair_trace(read.recording, trial.repairs[r]);
        if (!changed) return declaration_error(experiment, key, changed.error().what);
        read.warnings.push_back(key + ": repaired by hand: " + measurement::repair_words(trial.repairs[r]) + ", " +
                                std::to_string(*changed) + (*changed == 1 ? " sample" : " samples"));
    }
    return {};
}

}  // namespace

std::string trial_key(const Experiment& experiment, const TrialDeclaration& trial) {
    for (std::size_t i = 0; i < experiment.trials.size(); ++i)
        if (experiment.trials[i].name == trial.name) return "trial[" + std::to_string(i) + "]";
    return "trial";
}

Result<TrialRecording> read_trial(const Experiment& experiment, const TrialDeclaration& trial) {
    if (trial.role == TrialRole::simulate) return TrialRecording{planned_times(experiment, trial), 0.0, {}};
    const std::string key = trial_key(experiment, trial) + ".trace";
    Result<measurement::Recording> raw = read_trace_of(experiment, trial);
    if (!raw) return raw.error();
    if (raw->sample_count() == 0)
        return declaration_error(experiment, key, trial.trace.filename().string() + " holds no samples");

    TrialRecording read;
    for (const std::string& warning : raw->warnings)
        read.warnings.push_back(key + ": " + trial.trace.filename().string() + ": " + warning);
    std::vector<std::string> unused;
    Result<measurement::Recording> renamed = rename_tracks(experiment, trial, *std::move(raw), unused);
    if (!renamed) return renamed.error();
    read.recording = *std::move(renamed);
    if (!unused.empty()) {
        const std::string sentence = trial.trace.filename().string() +
                                     " holds markers that are not declared: " + quoted_list(unused);
        // Cameras record everything in view; other files are written for this experiment.
        if (!measurement::find_trace_reader(trial.format)->with_other_markers)
            return declaration_error(experiment, key, sentence);
        read.warnings.push_back(key + ": " + sentence + "; they are ignored");
    }
    if (Result<void> window = check_window(experiment, trial, read.recording); !window) return window.error();
    // On the whole recording, not its window: samples outside show what the motion and the noise of a track are.
    correct_faults(experiment, key, read);
    // Last: a person repairs what the corrections leave, and sees the corrected traces.
    if (Result<void> repaired = make_repairs(experiment, trial, read); !repaired) return repaired.error();
    for (std::size_t i = 0; i < read.recording.labels.size(); ++i) {
        const Eigen::Index occluded = occluded_samples(read.recording.tracks[i]);
        // Such a marker contributes little and its gaps may hide a mislabelled interval.
        if (2 * occluded > read.recording.sample_count())
            read.warnings.push_back(key + ": marker \"" + read.recording.labels[i] + "\" is occluded in " +
                                    std::to_string(occluded) + " of " + std::to_string(read.recording.sample_count()) +
                                    " samples");
    }
    // After the corrections, which would take a track without samples for a hidden marker.
    add_probes(experiment, read.recording);
    if (const std::string turned = unturned_axes(experiment, trial); !turned.empty())
        read.warnings.push_back(key + ": " + turned);
    return read;
}

Result<measurement::Recording> read_trial_recording(const Experiment& experiment, const TrialDeclaration& trial) {
    Result<TrialRecording> read = read_trial(experiment, trial);
    if (!read) return read.error();
    return std::move(read->recording);
}

std::vector<MuscleLeader> muscle_leaders(const Experiment& experiment) {
    const auto& muscles = experiment.muscles;
    std::vector<MuscleLeader> leaders(muscles.size());
    for (std::size_t i = 0; i < muscles.size(); ++i) {
        leaders[i] = {i, 1.0};
        // Cycles were rejected on reading, so the chain is shorter than the list.
        for (std::size_t steps = 0; muscles[leaders[i].leader].follows && steps < muscles.size(); ++steps) {
            const FollowsDeclaration& follows = *muscles[leaders[i].leader].follows;
            const auto next = std::find_if(muscles.begin(), muscles.end(), [&](const MuscleDeclaration& muscle) {
                return muscle.name == follows.muscle;
            });
            assert(next != muscles.end());
            leaders[i] = {static_cast<std::size_t>(next - muscles.begin()), leaders[i].factor * follows.ratio};
        }
    }
    return leaders;
}

}  // namespace myo::experiment
