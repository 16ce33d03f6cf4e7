#include "measurement/recording_edit.hpp"

#include <algorithm>
#include <cassert>

#include "base/text.hpp"

namespace myo::measurement {

std::optional<std::size_t> label_index(const Recording& recording, const std::string& label) {
    const auto found = std::find(recording.labels.begin(), recording.labels.end(), label);
    if (found == recording.labels.end()) return std::nullopt;
    return static_cast<std::size_t>(found - recording.labels.begin());
}

Recording transform(const Recording& recording, const RigidMotion& motion) {
    Recording result = recording;
    for (Eigen::Matrix3Xd& track : result.tracks) track = motion.apply_all(track);
    return result;
}

Recording slice(const Recording& recording, Eigen::Index first, Eigen::Index end) {
    assert(0 <= first && first <= end && end <= recording.sample_count());
    Recording result;
    result.labels = recording.labels;
    result.rate_Hz = recording.rate_Hz;
    result.time_s = recording.time_s.segment(first, end - first);
    for (const Eigen::Matrix3Xd& track : recording.tracks)
        result.tracks.emplace_back(track.middleCols(first, end - first));
    for (const Eigen::VectorXd& residual : recording.residual_m)
        result.residual_m.emplace_back(residual.segment(first, end - first));
    return result;
}

Recording slice_time(const Recording& recording, double from_s, double to_s) {
    const auto begin = recording.time_s.begin();
    const auto first = std::lower_bound(begin, recording.time_s.end(), from_s) - begin;
    const auto end = std::upper_bound(begin, recording.time_s.end(), to_s) - begin;
    return slice(recording, first, std::max(first, end));
}

Recording shift_time(const Recording& recording, double by_s) {
    Recording result = recording;
    result.time_s.array() += by_s;
    return result;
}

Result<Recording> select_labels(const Recording& recording, const std::vector<std::string>& labels,
                                const std::vector<std::string>& new_names) {
    assert(new_names.empty() || new_names.size() == labels.size());
    Recording result;
    result.labels = new_names.empty() ? labels : new_names;
    result.time_s = recording.time_s;
    result.rate_Hz = recording.rate_Hz;
    for (const std::string& label : labels) {
        const std::optional<std::size_t> i = label_index(recording, label);
        if (!i) {
            // Suggest a similar label; if none is similar, list all of them.
            const std::string near = closest_word(label, recording.labels);
            const std::string hint = near.empty() ? "it has " + join(recording.labels)
                                                  : "the closest one is '" + near + "'";
            return Error{"the recording has no marker '" + label + "'; " + hint, ""};
        }
        result.tracks.push_back(recording.tracks[*i]);
        if (!recording.residual_m.empty()) result.residual_m.push_back(recording.residual_m[*i]);
    }
    return result;
}

}  // namespace myo::measurement
