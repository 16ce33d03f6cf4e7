#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "report/length.hpp"

namespace myo::check {
namespace {

/// Distance of model and recording at the first sample; noise, the glue of the markers and a few tenths from
/// registration are tolerated.
struct StartPolicy {
    double noise_levels = 5.0;                        // tolerated distance over its noise
    double doubtful_share = 0.05, wrong_share = 0.2;  // of the range of motion
    double first_interval = 0.1;                      // latest first sample that shows the start, in sampling intervals
};
constexpr StartPolicy start_policy;

/// Root mean square length of vectors [m].
double rms_of(const std::vector<Eigen::Vector3d>& distances) {
    double sum = 0.0;
    for (const Eigen::Vector3d& d : distances) sum += d.squaredNorm();
    return std::sqrt(sum / static_cast<double>(distances.size()));
}

/// Range of motion of the markers within a trial, rms over them [m].
double travel(const setup::PreparedTrial& trial) {
    std::vector<Eigen::Vector3d> ranges;
    for (const Eigen::Matrix3Xd& track : trial.measured.tracks) {
        Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
        for (const auto& x : track.colwise())
            if (x.allFinite()) low = low.cwiseMin(x), high = high.cwiseMax(x);
        if ((high.array() >= low.array()).all()) ranges.push_back(high - low);
    }
    return ranges.empty() ? 0.0 : rms_of(ranges);
}

/// Model minus recording at the first sample, per marker; empty if this sample does not show the start.
std::vector<Eigen::Vector3d> at_start(const CheckedJob& job, std::size_t t) {
    const setup::Setup& setup = job.setup;
    const setup::PreparedTrial& trial = setup.trials[t];
    std::vector<Eigen::Vector3d> distances;
    const Eigen::Index first = trial.first_sample;
    // A later first sample shows where the body has moved to, not where it started.
    if (trial.measured.time_s(first) > start_policy.first_interval * setup::sampling_interval_s(trial))
        return distances;
    // Displacements and recordings in an unknown frame have no position in the mesh frame before a fit.
    const bool known = setup.experiment.registration.known && trial.reference_m.empty();
    const bool straight = trial.options.start == dynamics::StartKind::straight;
    // Before a run, only a straight start in a known frame can be compared. After it, an equilibrium depends on the
    // modulus, so only a fitted one is compared.
    if (job.run == nullptr ? !straight || !known : !straight && job.calibration == nullptr) return distances;
    for (std::size_t m = 0; m < trial.measured.tracks.size(); ++m) {
        Eigen::Vector3d distance;
        // A run has its residual in the frame of the recording; before one the rest positions are compared, on a moving
        // mount where it carries them.
        if (job.run != nullptr) {
            if (!job.run->predictions[t].ok()) return {};
            distance = job.run->predictions[t].residual_m[m].col(first);
        } else {
            const Eigen::Vector3d& rest = setup.experiment.markers.on_body[m].rest_m;
            distance = (trial.mount ? Eigen::Vector3d(trial.mount->at(0.0).in_laboratory(rest)) : rest) -
                       trial.measured.tracks[m].col(first);
        }
        if (distance.allFinite()) distances.push_back(distance);
    }
    return distances;
}

}  // namespace

std::vector<Finding> check_start(const CheckedJob& job) {
    std::vector<Finding> findings;
    // Until a fit has found them, the places of the markers are uncertain, too.
    const bool placed = job.run != nullptr && !job.run->values.places_m.empty();
    const double coordinate = placed
                                  ? setup::mean_noise(job.setup)
                                  : std::hypot(setup::mean_noise(job.setup), job.setup.experiment.markers.placement_m);
    const double noise = std::sqrt(3.0) * coordinate;  // of a distance: three independent coordinates
    for (std::size_t t = 0; t < job.setup.trials.size(); ++t) {
        const setup::PreparedTrial& trial = job.setup.trials[t];
        if (trial.hold) continue;  // a pose has no start
        const std::vector<Eigen::Vector3d> distances = at_start(job, t);
        if (distances.empty()) continue;
        const double off = rms_of(distances), moved = travel(trial);
        const bool straight = trial.options.start == dynamics::StartKind::straight;
        Finding finding = passed_finding(trial.name, "trial " + trial.name + ": at the first sample the markers are " +
                                                         report::length_words(off) +
                                                         " rms from where the model begins (start = \"" +
                                                         (straight ? "straight" : "equilibrium") + "\")");
        finding.figure = off;
        // The larger of both limits: a small motion is judged by noise, a large one by its range.
        finding.threshold = std::max(start_policy.noise_levels * noise, start_policy.doubtful_share * moved);
        finding.unit = "m";
        if (off > finding.threshold) {
            finding.level = off > start_policy.wrong_share * moved ? CheckLevel::wrong : CheckLevel::doubtful;
            finding.sentence += ", while they move by " + report::length_words(moved) + " in the trial";
            finding
                .way_out = straight
                               ? "if the body rested under gravity and loads, state start = \"equilibrium\"; if it was "
                                 "held or moving, declare what held it (a load until t = 0)"
                               : "was the body at rest at t = 0, under the loads and levels that are declared?";
        }
        findings.push_back(std::move(finding));
    }
    return findings;
}

}  // namespace myo::check
