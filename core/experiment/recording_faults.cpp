#include "experiment/recording_faults.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"
#include "measurement/exchanges.hpp"
#include "measurement/excursions.hpp"
#include "measurement/false_stretches.hpp"
#include "measurement/frozen.hpp"
#include "measurement/hidden_exchanges.hpp"
#include "measurement/noise.hpp"
#include "measurement/spikes.hpp"
#include "measurement/zeros.hpp"

namespace myo::experiment {
namespace {

using Eigen::Index;

/// Time of a sample in words.
std::string seconds(const measurement::Recording& recording, Index t) {
    return format_number(recording.time_s(t), 4) + " s";
}

/// "1 sample" or "20 samples".
std::string sample_words(Index count) { return std::to_string(count) + (count == 1 ? " sample" : " samples"); }

/// Makes the samples [first, end) of a marker a gap.
void hide(measurement::Recording& recording, std::size_t marker, Index first, Index end) {
    recording.tracks[marker].middleCols(first, end - first).setConstant(std::numeric_limits<double>::quiet_NaN());
}

/// Zeros that some programs write where a marker is hidden.
void leave_out_zeros(const std::string& key, TrialRecording& read) {
    measurement::Recording& recording = read.recording;
    for (std::size_t i = 0; i < recording.labels.size(); ++i) {
        const std::vector<Index> zeros = measurement::find_zero_gaps(recording.tracks[i]);
        if (zeros.empty()) continue;
        for (const Index t : zeros) hide(recording, i, t, t + 1);
        read.warnings.push_back(key + ": marker \"" + recording.labels[i] + "\" is at exactly 0, 0, 0 in " +
                                sample_words(static_cast<Index>(zeros.size())) + " from " +
                                seconds(recording, zeros.front()) + " to " + seconds(recording, zeros.back()) +
                                ", which are taken as a gap");
    }
}

/// Positions that a system repeats after it lost the marker.
void leave_out_frozen(const std::string& key, TrialRecording& read) {
    measurement::Recording& recording = read.recording;
    for (const measurement::FrozenInterval& frozen : measurement::find_frozen(recording.tracks, read.rounding_m)) {
        hide(recording, frozen.marker, frozen.first, frozen.end);
        read.warnings.push_back(key + ": marker \"" + recording.labels[frozen.marker] +
                                "\" repeats one position exactly from " + seconds(recording, frozen.first) + " to " +
                                seconds(recording, frozen.end - 1) + " while others move; these " +
                                sample_words(frozen.end - frozen.first) + " are left out");
    }
}

// Declared or estimated standard deviation; never below the deviation that rounding of the file alone produces.
double noise_of(const Experiment& experiment, const TrialRecording& read, const Eigen::Matrix3Xd& track) {
    return std::max(experiment.markers.noise_m.value_or(measurement::estimate_track_noise(track).sigma_m),
                    measurement::rounding_deviation(read.rounding_m));
}

/// noise_of() for each track [m]. Estimated again before each correction, since the corrections before lower it.
Eigen::VectorXd noise_of_tracks(const Experiment& experiment, const TrialRecording& read) {
    const std::vector<Eigen::Matrix3Xd>& tracks = read.recording.tracks;
    Eigen::VectorXd sigma_m(static_cast<Index>(tracks.size()));
    for (std::size_t i = 0; i < tracks.size(); ++i)
        sigma_m(static_cast<Index>(i)) = noise_of(experiment, read, tracks[i]);
    return sigma_m;
}

// Undoes label swaps: intervals in which the camera software exchanged the names of markers.
void put_names_back(const Experiment& experiment, const std::string& key, TrialRecording& read) {
    const measurement::Recording& recording = read.recording;
    // First the exchanges that positions alone show: the search for the others predicts each marker from the rest,
    // whose names must be right by then.
    std::vector<measurement::Exchange> exchanges = measurement::put_back_exchanges(read.recording.tracks);
    const std::vector<measurement::Exchange> hidden = measurement::put_back_hidden_exchanges(
        read.recording.tracks, noise_of_tracks(experiment, read));
    exchanges.insert(exchanges.end(), hidden.begin(), hidden.end());
    for (const measurement::Exchange& exchange : exchanges) {
        std::vector<std::string> names;
        for (const std::size_t i : exchange.markers) names.push_back(recording.labels[i]);
        const bool lasts = exchange.end == recording.sample_count();
        read.warnings.push_back(key + ": markers " + quoted_list(names) + " have exchanged names from " +
                                format_number(recording.time_s(exchange.first), 4) + " s " +
                                (lasts ? "on, after a gap of both" : "to " + seconds(recording, exchange.end - 1)) +
                                ", which is corrected");
    }
}

/// Stretches next to gaps in which the cameras followed something else.
void leave_out_false_stretches(const Experiment& experiment, const std::string& key, TrialRecording& read) {
    measurement::Recording& recording = read.recording;
    for (const measurement::FalseStretch& stretch :
         measurement::find_false_stretches(recording.tracks, noise_of_tracks(experiment, read))) {
        hide(recording, stretch.marker, stretch.first, stretch.end);
        read.warnings.push_back(key + ": marker \"" + recording.labels[stretch.marker] + "\" is up to " +
                                format_number(1e3 * stretch.offset_m, 3) + " mm from where the others place it from " +
                                seconds(recording, stretch.first) + " to " + seconds(recording, stretch.end - 1) +
                                ", beside a gap; these " + sample_words(stretch.end - stretch.first) + " are left out");
    }
}

// Isolated outliers (reflections, mislabelled samples) are treated as occluded.
void leave_out_spikes(const Experiment& experiment, const std::string& key, TrialRecording& read) {
    for (std::size_t i = 0; i < read.recording.labels.size(); ++i) {
        Eigen::Matrix3Xd& track = read.recording.tracks[i];
        // The noise is estimated from the track as the corrections before have left it.
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
    const std::vector<measurement::Excursion> found = measurement::find_excursions(recording.tracks, recording.time_s,
                                                                                   noise_of_tracks(experiment, read));
    for (std::size_t i = 0; i < recording.tracks.size(); ++i) {
        Eigen::Index times = 0, samples = 0, first = 0;
        double jump_m = 0.0;
        // One warning per marker: a marker that is mistaken often would fill the list otherwise.
        for (const measurement::Excursion& excursion : found) {
            if (excursion.marker != i) continue;
            if (times++ == 0) first = excursion.first;
            samples += excursion.end - excursion.first;
            jump_m = std::max(jump_m, excursion.jump_m);
            hide(recording, i, excursion.first, excursion.end);
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

std::string quoted_list(const std::vector<std::string>& words) { return "\"" + join(words, "\", \"") + "\""; }

void correct_faults(const Experiment& experiment, const std::string& key, TrialRecording& read) {
    // Order matters: repeated positions would lower the estimate of the noise, rounding enters the noise, swapped
    // labels would appear as excursions, a false stretch would make spikes of true samples, and a spike would end an
    // excursion.
    leave_out_zeros(key, read);
    read.rounding_m = measurement::rounding_step(read.recording.tracks);
    leave_out_frozen(key, read);
    put_names_back(experiment, key, read);
    leave_out_false_stretches(experiment, key, read);
    leave_out_spikes(experiment, key, read);
    leave_out_excursions(experiment, key, read);
}

}  // namespace myo::experiment
