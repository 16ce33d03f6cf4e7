#include "experiment/read_trial.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "measurement/exchanges.hpp"
#include "measurement/excursions.hpp"
#include "measurement/noise.hpp"
#include "measurement/spikes.hpp"

namespace myo::experiment {
namespace {

std::vector<MarkerDeclaration> all_markers(const Experiment& experiment) {
    std::vector<MarkerDeclaration> markers = experiment.markers.on_body;
    markers.insert(markers.end(), experiment.markers.fixed.begin(), experiment.markers.fixed.end());
    return markers;
}

// Index of the marker's track, by label or, if the label does not occur, by name; labels.size() if absent.
std::size_t find_track(const std::vector<std::string>& labels, const MarkerDeclaration& marker) {
    auto found = std::find(labels.begin(), labels.end(), marker.label);
    if (found == labels.end()) found = std::find(labels.begin(), labels.end(), marker.name);
    return static_cast<std::size_t>(found - labels.begin());
}

// A sample counts as occluded if any coordinate is missing.
Eigen::Index occluded_samples(const Eigen::Matrix3Xd& track) {
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < track.cols(); ++t) count += track.col(t).array().isNaN().any() ? 1 : 0;
    return count;
}

std::string quoted_list(const std::vector<std::string>& words) { return "\"" + join(words, "\", \"") + "\""; }

// Tracks in declared order under declared names; `unused` receives the labels that are not declared.
Result<measurement::Recording> rename_tracks(const Experiment& experiment, const TrialDeclaration& trial,
                                             measurement::Recording raw, std::vector<std::string>& unused) {
    const std::string key = trial_key(experiment, trial) + ".trace";
    const std::string file = trial.trace.filename().string();
    measurement::Recording renamed;
    renamed.time_s = raw.time_s;
    renamed.rate_Hz = raw.rate_Hz;
    std::vector<bool> used(raw.labels.size(), false);
    for (const MarkerDeclaration& marker : all_markers(experiment)) {
        const std::size_t track = find_track(raw.labels, marker);
        if (track == raw.labels.size())
            return declaration_error(experiment, key,
                                     file + " has no marker \"" + marker.label + "\"" +
                                         (marker.label == marker.name ? "" : " (the label of " + marker.name + ")") +
                                         "; it has " + quoted_list(raw.labels));
        if (used[track])
            return declaration_error(experiment, key,
                                     file + " names two declared markers \"" + raw.labels[track] + "\"");
        used[track] = true;
        renamed.labels.push_back(marker.name);
        renamed.tracks.push_back(std::move(raw.tracks[track]));
        if (!raw.residual_m.empty()) renamed.residual_m.push_back(std::move(raw.residual_m[track]));
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i]) unused.push_back(raw.labels[i]);
    return renamed;
}

// At least one sample must lie between start_s and end_s.
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

// Undoes label swaps: intervals in which the camera software exchanged the names of markers.
void put_names_back(const std::string& key, TrialRecording& read) {
    const measurement::Recording& recording = read.recording;
    for (const measurement::Exchange& exchange : measurement::put_back_exchanges(read.recording.tracks)) {
        std::vector<std::string> names;
        for (const std::size_t i : exchange.markers) names.push_back(recording.labels[i]);
        read.warnings.push_back(key + ": markers " + quoted_list(names) + " have exchanged names from " +
                                format_number(recording.time_s(exchange.first), 4) + " s to " +
                                format_number(recording.time_s(exchange.end - 1), 4) + " s, which is corrected");
    }
}

// Declared or estimated standard deviation; never below the deviation that rounding of the file alone produces.
double noise_of(const Experiment& experiment, const TrialRecording& read, const Eigen::Matrix3Xd& track) {
    return std::max(experiment.markers.noise_m.value_or(measurement::estimate_track_noise(track).sigma_m),
                    measurement::rounding_deviation(read.rounding_m));
}

// Isolated outliers (reflections, mislabelled samples) are treated as occluded.
void leave_out_spikes(const Experiment& experiment, const std::string& key, TrialRecording& read) {
    for (std::size_t i = 0; i < read.recording.labels.size(); ++i) {
        Eigen::Matrix3Xd& track = read.recording.tracks[i];
        const measurement::Spikes spikes = measurement::find_spikes(track, read.recording.time_s,
                                                                    noise_of(experiment, read, track));
        if (spikes.samples.empty()) continue;
        for (const Eigen::Index t : spikes.samples) track.col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
        read.warnings.push_back(
            key + ": marker \"" + read.recording.labels[i] + "\" stands out from its own motion by up to " +
            format_number(1e3 * spikes.largest_m, 3) + " mm in " + std::to_string(spikes.samples.size()) +
            (spikes.samples.size() == 1 ? " sample, which is" : " samples, which are") + " left out, the first at " +
            format_number(read.recording.time_s(spikes.samples.front()), 4) + " s");
    }
}

// Outliers over several samples: the marker jumps away and back. The samples between are treated as occluded.
void leave_out_excursions(const Experiment& experiment, const std::string& key, TrialRecording& read) {
    measurement::Recording& recording = read.recording;
    Eigen::VectorXd sigma_m(static_cast<Eigen::Index>(recording.tracks.size()));
    for (std::size_t i = 0; i < recording.tracks.size(); ++i)
        sigma_m(static_cast<Eigen::Index>(i)) = noise_of(experiment, read, recording.tracks[i]);
    const std::vector<measurement::Excursion> found = measurement::find_excursions(recording.tracks, recording.time_s,
                                                                                   sigma_m);
    for (std::size_t i = 0; i < recording.tracks.size(); ++i) {
        Eigen::Index times = 0, samples = 0, first = 0;
        double jump_m = 0.0;
        for (const measurement::Excursion& excursion : found) {
            if (excursion.marker != i) continue;
            if (times++ == 0) first = excursion.first;
            samples += excursion.end - excursion.first;
            jump_m = std::max(jump_m, excursion.jump_m);
            recording.tracks[i]
                .middleCols(excursion.first, excursion.end - excursion.first)
                .setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        if (times > 0)
            read.warnings.push_back(key + ": marker \"" + recording.labels[i] + "\" jumps by up to " +
                                    format_number(1e3 * jump_m, 3) + " mm and back" +
                                    (times > 1 ? ", " + std::to_string(times) + " times" : "") + "; " +
                                    std::to_string(samples) + " samples between are left out, the first at " +
                                    format_number(recording.time_s(first), 4) + " s");
    }
}

}  // namespace

std::string trial_key(const Experiment& experiment, const TrialDeclaration& trial) {
    for (std::size_t i = 0; i < experiment.trials.size(); ++i)
        if (experiment.trials[i].name == trial.name) return "trial[" + std::to_string(i) + "]";
    return "trial";
}

Result<TrialRecording> read_trial(const Experiment& experiment, const TrialDeclaration& trial) {
    const std::string key = trial_key(experiment, trial) + ".trace";
    Result<measurement::Recording> raw = measurement::read_trace(trial.trace,
                                                                 {trial.format, trial.columns, std::nullopt});
    if (!raw) return Error{key + ": " + raw.error().what, raw.error().where};
    if (raw->sample_count() == 0)
        return declaration_error(experiment, key, trial.trace.filename().string() + " holds no samples");

    TrialRecording read;
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
    // Order matters: rounding enters the noise, swapped labels would appear as excursions, and a spike would end one.
    read.rounding_m = measurement::rounding_step(read.recording.tracks);
    put_names_back(key, read);
    leave_out_spikes(experiment, key, read);
    leave_out_excursions(experiment, key, read);
    for (std::size_t i = 0; i < read.recording.labels.size(); ++i) {
        const Eigen::Index occluded = occluded_samples(read.recording.tracks[i]);
        // Such a marker contributes little and its gaps may hide a mislabelled interval.
        if (2 * occluded > read.recording.sample_count())
            read.warnings.push_back(key + ": marker \"" + read.recording.labels[i] + "\" is occluded in " +
                                    std::to_string(occluded) + " of " + std::to_string(read.recording.sample_count()) +
                                    " samples");
    }
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
