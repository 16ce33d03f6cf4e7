#include "setup/marker_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "measurement/noise.hpp"
#include "measurement/recording_edit.hpp"
#include "setup/hold_recording.hpp"

namespace myo::setup {
namespace {

/// Noise of a track per coordinate [m]; empty if too few consecutive samples are seen, or if it is zero.
std::optional<double> noise(const measurement::Recording& recording, Eigen::Index marker) {
    const measurement::NoiseEstimate estimate = measurement::estimate_track_noise(
        recording.tracks[static_cast<std::size_t>(marker)]);
    return estimate.found && estimate.sigma_m > 0.0 ? std::optional(estimate.sigma_m) : std::nullopt;
}
/// How far the samples of a pose lie from their mean, per coordinate [m]; empty with fewer than two samples.
std::optional<double> spread(const measurement::Recording& recording, Eigen::Index marker) {
    const double sigma_m = spread_of_pose(recording)(marker);
    return sigma_m > 0.0 ? std::optional(sigma_m) : std::nullopt;
}

/// Noise of the markers from their traces, all trials together. `rounded_m`: noise of the rounding of the traces, the
/// least.
void set_estimated_noise(const std::vector<measurement::Recording>& recordings, double rounded_m, Setup& setup) {
    const auto count = static_cast<Eigen::Index>(setup.marker_names.size());
    // Between motions and poses the noise of the motions counts: it is the smaller one, and noise alone.
    const bool poses = std::all_of(setup.trials.begin(), setup.trials.end(),
                                   [](const PreparedTrial& trial) { return trial.hold; });
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(count), found = Eigen::VectorXd::Zero(count);
    for (const measurement::Recording& recording : recordings)
        for (Eigen::Index m = 0; m < count; ++m) {
            const std::optional<double> sigma_m = poses ? spread(recording, m) : noise(recording, m);
            if (!sigma_m) continue;
            sum(m) += *sigma_m * *sigma_m;
            found(m) += 1.0;
        }
    const double typical = found.sum() > 0.0 ? std::sqrt(sum.sum() / found.sum()) : marker_noise_policy.assumed_m;
    if (found.sum() == 0.0 && experiment::has_recordings(setup.experiment))
        setup.warnings.push_back(
            "markers.noise_m: not declared and not to be estimated from the traces; 0.1 mm is assumed");
    setup.noise_m.resize(count);
    // A pose at rest still sways, most where the body is free; the cameras see all markers equally well. Weights by the
    // sway of each marker would let those near the support dominate the fit.
    if (poses) {
        setup.noise_m.setConstant(std::max(typical, rounded_m));
        return;
    }
    // Half the typical noise as a floor: a single marker with a too small estimate would dominate the fit.
    for (Eigen::Index m = 0; m < count; ++m)
        setup.noise_m(m) = std::max(
            {found(m) > 0.0 ? std::sqrt(sum(m) / found(m)) : typical, 0.5 * typical, rounded_m});
}

}  // namespace

measurement::Recording without_made_samples(const experiment::TrialDeclaration& declaration,
                                            const PreparedTrial& trial) {
    measurement::Recording recording = trial.measured;
    for (const measurement::TraceRepair& repair : declaration.repairs) {
        const std::optional<std::size_t> marker = measurement::label_index(recording, repair.marker);
        if (!makes_samples(repair.kind) || !marker) continue;
        // Repairs are declared in file time, the prepared recording is in trial time.
        const auto [first, end] = measurement::samples_within(recording.time_s, repair.from_s - trial.start_s,
                                                              repair.to_s - trial.start_s);
        recording.tracks[*marker].middleCols(first, end - first).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return recording;
}

void set_noise(const std::vector<measurement::Recording>& recordings, Setup& setup) {
    const auto count = static_cast<Eigen::Index>(setup.marker_names.size());
    // One value for all trials: markers have one noise in the whole experiment, and the coarsest file limits it.
    const auto coarsest = std::max_element(
        setup.trials.begin(), setup.trials.end(),
        [](const PreparedTrial& a, const PreparedTrial& b) { return a.rounding_m < b.rounding_m; });
    const double rounded_m = measurement::rounding_deviation(coarsest->rounding_m);
    if (const auto declared = setup.experiment.markers.noise_m) {
        setup.noise_m = Eigen::VectorXd::Constant(count, std::max(*declared, rounded_m));
        if (rounded_m > *declared)
            setup.warnings.push_back("markers.noise_m: the numbers of trial " + coarsest->name + " are rounded to " +
                                     format_number(1e3 * coarsest->rounding_m) + " mm, which is noise of " +
                                     format_number(1e3 * rounded_m, 3) + " mm by itself; it is taken in place of the " +
                                     format_number(1e3 * *declared, 3) + " mm declared");
        return;
    }
    set_estimated_noise(recordings, rounded_m, setup);
}

double mean_noise(const Setup& setup) {
    if (setup.noise_m.size() == 0) return marker_noise_policy.assumed_m;  // no marker: nothing is compared
    return std::sqrt(setup.noise_m.squaredNorm() / static_cast<double>(setup.noise_m.size()));
}

}  // namespace myo::setup
