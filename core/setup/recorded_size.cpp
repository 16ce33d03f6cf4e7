#include "setup/recorded_size.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "measurement/gaps.hpp"
#include "measurement/units.hpp"

namespace myo::setup {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Sizes of recordings that only another unit explains.
struct RecordedSizePolicy {
    double max_ratio = 5.0;        // recorded over declared: elastomers break at a stretch of 5 to 10
    double min_ratio = 1.0 / 8.0;  // a curled body brings its markers together, rarely all of them
    double least_distance = 0.05;  // of the body's size: shorter distances depend on where exactly a marker sits
    double body_lengths = 2.0;     // that a single marker may move
    double same_unit = 2.0;        // a ratio within this factor of a unit's is attributed to that unit
    Index max_samples = 50;        // evenly chosen; the median needs no more
};
constexpr RecordedSizePolicy recorded_size_policy;

/// Middle value; empty without values.
std::optional<double> median(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Recorded over declared distances between the markers; empty if no two of them are far enough apart.
std::optional<double> distance_ratio(const std::vector<Vector3d>& rest_m, const measurement::Recording& recording,
                                     double body_m) {
    // Medians over time and over pairs: a few exchanged names or stretched pairs do not decide.
    const Index stride = 1 + recording.sample_count() / recorded_size_policy.max_samples;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < rest_m.size(); ++i)
        for (std::size_t j = i + 1; j < rest_m.size(); ++j) {
            const double declared_m = (rest_m[i] - rest_m[j]).norm();
            if (!(declared_m > recorded_size_policy.least_distance * body_m)) continue;
            std::vector<double> distances_m;
            for (Index t = 0; t < recording.sample_count(); t += stride)
                if (measurement::is_seen(recording.tracks[i], t) && measurement::is_seen(recording.tracks[j], t))
                    distances_m.push_back((recording.tracks[i].col(t) - recording.tracks[j].col(t)).norm());
            if (const std::optional<double> middle = median(std::move(distances_m)))
                ratios.push_back(*middle / declared_m);
        }
    return median(std::move(ratios));
}

/// Largest range of motion over what a body of this size allows.
double motion_ratio(const measurement::Recording& recording, double body_m, double standoff_m) {
    double largest_m = 0.0;
    for (const Eigen::Matrix3Xd& track : recording.tracks) {
        std::optional<Vector3d> low, high;
        for (Index t = 0; t < track.cols(); ++t) {
            if (!measurement::is_seen(track, t)) continue;
            low = low ? Vector3d(low->cwiseMin(track.col(t))) : Vector3d(track.col(t));
            high = high ? Vector3d(high->cwiseMax(track.col(t))) : Vector3d(track.col(t));
        }
        // Diagonal of the box that the marker moves in.
        if (low) largest_m = std::max(largest_m, (*high - *low).norm());
    }
    return largest_m / (recorded_size_policy.body_lengths * (body_m + standoff_m));
}

}  // namespace

Result<void> check_recorded_size(const experiment::Experiment& experiment,
                                 const experiment::TrialDeclaration& declaration, const mesh::SurfaceMesh& surface,
                                 const measurement::Recording& recording) {
    std::vector<Vector3d> rest_m;
    for (const auto* group : {&experiment.markers.on_body, &experiment.markers.fixed})
        for (const experiment::MarkerDeclaration& marker : *group) rest_m.push_back(marker.rest_m);
    const double body_m = mesh::bounding_box(surface.vertices).size().norm();
    const std::optional<double> distances = distance_ratio(rest_m, recording, body_m);
    const double ratio = distances.value_or(motion_ratio(recording, body_m, experiment.markers.max_standoff_m));
    // A motion may be arbitrarily small, so only distances can be too small.
    const bool too_small = distances && ratio < recorded_size_policy.min_ratio;
    if (ratio <= recorded_size_policy.max_ratio && !too_small) return {};
    const std::string size = distances
                                 ? "has its markers " + format_number(ratio, 4) + " times as far apart as declared"
                                 : "has a motion of " + format_number(ratio, 4) + " times what the body's size allows";
    // Numbers that are too large by the ratio are in a unit that is smaller by it.
    const std::string likely = measurement::unit_word(recording.metres_per_unit / ratio,
                                                      recorded_size_policy.same_unit),
                      stated = measurement::unit_word(recording.metres_per_unit);
    return experiment::declaration_error(
        experiment, experiment::trial_key(experiment, declaration) + ".trace",
        declaration.trace.filename().string() + " " + size +
            (likely.empty() || likely == stated ? "; correct its unit of length"
                                                : "; its numbers look like " + likely + " instead of " + stated +
                                                      ": correct the unit in the file (the header of a csv: tip_x_" +
                                                      likely + ") or the trial's key unit"));
}

}  // namespace myo::setup
