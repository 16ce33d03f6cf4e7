#include "measurement/motion_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "measurement/gaps.hpp"
#include "measurement/noise.hpp"
#include "measurement/recording_edit.hpp"
#include "measurement/robust.hpp"

namespace myo::measurement {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Reference window in samples: its end lies `lag` before the sample.
struct Window {
    Eigen::Index lag;
    Eigen::Index length;
};

/// Samples that are not repetitions of their predecessor.
std::vector<Eigen::Index> new_samples(const Recording& recording) {
    const std::vector<Eigen::Index> repeats = repeated_samples(recording);
    std::vector<Eigen::Index> samples;
    for (Eigen::Index t = 0; t < recording.sample_count(); ++t) {
        if (!std::binary_search(repeats.begin(), repeats.end(), t)) samples.push_back(t);
    }
    return samples;
}

Recording take_samples(const Recording& recording, const std::vector<Eigen::Index>& samples) {
    Recording result;
    result.labels = recording.labels;
    result.rate_Hz = recording.rate_Hz;
    result.time_s = recording.time_s(samples);
    for (const Eigen::Matrix3Xd& track : recording.tracks) result.tracks.emplace_back(track(Eigen::all, samples));
    return result;
}

/// Both lengths have a minimum in samples, so that the median suppresses the noise.
Window reference_window(const Recording& recording, const MotionStartOptions& options) {
    const auto samples = [&](double seconds, double least) {
        return static_cast<Eigen::Index>(std::clamp(std::round(seconds * recording.rate_Hz), least, 1e6));
    };
    return {samples(options.reference_lag_s, 8.0), samples(options.reference_length_s, 16.0)};
}

// Position of the marker shortly before sample t: median of the reference window, which is shorter near the beginning
// of the recording; if nothing is visible there, the first visible sample after it. nullopt if there is none before t.
std::optional<Eigen::Vector3d> reference(const Eigen::Matrix3Xd& track, Eigen::Index t, const Window& window) {
    const Eigen::Index last = std::max<Eigen::Index>(t - window.lag, 0);
    const Eigen::Index first = std::max<Eigen::Index>(last - window.length + 1, 0);
    std::vector<Eigen::Index> seen;
    for (Eigen::Index k = first; k <= last; ++k) {
        if (is_seen(track, k)) seen.push_back(k);
    }
    for (Eigen::Index k = last + 1; k < t && seen.empty(); ++k) {
        if (is_seen(track, k)) seen.push_back(k);
    }
    if (seen.empty()) return std::nullopt;
    const Eigen::Matrix3Xd samples = track(Eigen::all, seen);
    return Eigen::Vector3d(median(samples.row(0)), median(samples.row(1)), median(samples.row(2)));
}

// Distance of every sample from its reference; NaN where unknown.
Eigen::VectorXd departures(const Eigen::Matrix3Xd& track, const Window& window) {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(track.cols(), nan);
    for (Eigen::Index t = 1; t < track.cols(); ++t) {
        if (!is_seen(track, t)) continue;
        if (const std::optional<Eigen::Vector3d> place = reference(track, t, window))
            result(t) = (track.col(t) - *place).norm();
    }
    return result;
}

// Largest value that `count` consecutive known samples reach; unknown samples are skipped.
double sustained_peak(const Eigen::VectorXd& values, int count) {
    std::vector<double> known;
    for (const double value : values) {
        if (!std::isnan(value)) known.push_back(value);
    }
    const auto length = static_cast<std::size_t>(std::max(count, 1));
    double peak = 0.0;
    for (std::size_t k = 0; k + length <= known.size(); ++k) {
        const auto first = known.begin() + static_cast<std::ptrdiff_t>(k);
        peak = std::max(peak, *std::min_element(first, first + count));
    }
    return peak;
}

// Median over the markers, sample by sample.
Eigen::VectorXd group_departure(const std::vector<Eigen::VectorXd>& markers) {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(markers[0].size(), nan);
    for (Eigen::Index t = 0; t < result.size(); ++t) {
        std::vector<double> known;
        for (const Eigen::VectorXd& marker : markers) {
            if (!std::isnan(marker(t))) known.push_back(marker(t));
        }
        if (!known.empty())
            result(t) = median(Eigen::Map<Eigen::VectorXd>(known.data(), static_cast<Eigen::Index>(known.size())));
    }
    return result;
}

// First sample from which the departure exceeds `limit` for `count` consecutive known samples.
std::optional<Eigen::Index> first_sustained(const Eigen::VectorXd& departure, double limit, int count) {
    std::optional<Eigen::Index> first;
    int run = 0;
    for (Eigen::Index t = 0; t < departure.size(); ++t) {
        if (std::isnan(departure(t))) continue;
        if (!(departure(t) > limit)) {
            run = 0;
            continue;
        }
        if (++run == 1) first = t;
        if (run == count) return first;
    }
    return std::nullopt;
}

// Goes back from `t` to the first sample of the connected departure above `threshold`; unknown samples do not interrupt
// it.
Eigen::Index trace_back(const Eigen::VectorXd& departure, Eigen::Index t, double threshold) {
    Eigen::Index first = t;
    for (Eigen::Index k = t - 1; k >= 0; --k) {
        if (std::isnan(departure(k))) continue;
        if (!(departure(k) > threshold)) break;
        first = k;
    }
    return first;
}

// Mean displacement of the moving markers along their own direction of motion, from sample `first` on. The direction is
// that of the last of the `count` samples: a projection averages the noise, which a distance would accumulate.
Eigen::VectorXd displacement_along_motion(const Recording& movers, Eigen::Index first, Eigen::Index count,
                                          const Window& window) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd seen = Eigen::VectorXd::Zero(count);
    for (const Eigen::Matrix3Xd& track : movers.tracks) {
        const std::optional<Eigen::Vector3d> rest = reference(track, first, {1, window.length});
        if (!rest || !is_seen(track, first + count - 1)) continue;
        const Eigen::Vector3d direction = (track.col(first + count - 1) - *rest).normalized();
        for (Eigen::Index k = 0; k < count; ++k) {
            if (!is_seen(track, first + k)) continue;
            sum(k) += direction.dot(track.col(first + k) - *rest);
            seen(k) += 1.0;
        }
    }
    return (seen.array() > 0.0).select(sum.array() / seen.array().max(1.0), nan);
}

// Onset law d = (slope (t - start))^power for given displacements.
struct OnsetLaw {
    double start_s = 0.0;
    double slope = 0.0;
    double power = 1.0;
    double squared_error = std::numeric_limits<double>::infinity();

    double at(double t) const { return t > start_s ? std::pow(slope * (t - start_s), power) : 0.0; }
};

/// Calls visit(point, weight) for the positive displacements: point (t, d^(1/power)), with the weight that converts
/// errors of the root to errors of d, which have equal variance.
template <class Visit>
void for_each_root(const Eigen::VectorXd& time_s, const Eigen::VectorXd& displacement, double power,
                   const Visit& visit) {
    for (Eigen::Index k = 0; k < time_s.size(); ++k) {
        const double d = displacement(k);
        if (d > 0.0)
            visit(Eigen::Vector2d(time_s(k), std::pow(d, 1.0 / power)), std::pow(d, 2.0 * (power - 1.0) / power));
    }
}

// Weighted least-squares fit of the onset law for a given power.
OnsetLaw fit_onset(const Eigen::VectorXd& time_s, const Eigen::VectorXd& displacement, double power) {
    OnsetLaw law;
    law.power = power;
    // Linear regression of d^(1/power).
    double weight = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for_each_root(time_s, displacement, power, [&](const Eigen::Vector2d& point, double w) {
        weight += w;
        mean += w * point;
    });
    if (!(weight > 0.0)) return law;
    mean /= weight;
    double moment = 0.0;
    double spread = 0.0;
    for_each_root(time_s, displacement, power, [&](const Eigen::Vector2d& point, double w) {
        moment += w * (point.x() - mean.x()) * (point.y() - mean.y());
        spread += w * (point.x() - mean.x()) * (point.x() - mean.x());
    });
    if (!(moment > 0.0) || !(spread > 0.0)) return law;
    law.slope = moment / spread;
    law.start_s = mean.x() - mean.y() / law.slope;
    law.squared_error = 0.0;
    for (Eigen::Index k = 0; k < time_s.size(); ++k) {
        if (std::isnan(displacement(k))) continue;
        const double error = law.at(time_s(k)) - displacement(k);
        law.squared_error += error * error;
    }
    return law;
}

// Onset time between the samples.
double onset_time(const Recording& movers, const Eigen::VectorXd& departure, Eigen::Index first, double peak,
                  double threshold, const Window& window) {
    const double at_first = movers.time_s(first);
    const double still = movers.time_s(first - 1);
    // Use the beginning of the motion only: up to a fifth of the peak (half of it for the first three samples, for fast
    // bodies), and at most as many samples as the lag of the reference.
    const auto belongs = [&](Eigen::Index k) {
        return k < window.lag && first + k < departure.size() && departure(first + k) < (k < 3 ? 0.5 : 0.2) * peak;
    };
    Eigen::Index count = 1;
    while (belongs(count)) ++count;
    const Eigen::VectorXd displacement = displacement_along_motion(movers, first, count, window);
    const Eigen::VectorXd times = movers.time_s.segment(first, count);
    // A mass that starts from rest moves as t^2. The linear law is for slow drives and is accepted only if many samples
    // show that its error is smaller.
    OnsetLaw law = fit_onset(times, displacement, 2.0);
    if (count >= 6) {
        const OnsetLaw linear = fit_onset(times, displacement, 1.0);
        if (linear.squared_error < 0.25 * law.squared_error) law = linear;
    }
    if (!std::isfinite(law.squared_error)) return 0.5 * (still + at_first);
    // Bounds of the extrapolation: the law may exceed the last still and the first moving sample by at most the
    // threshold, and extend beyond its data by at most half of their duration.
    const auto time_to_reach = [&](double d) { return std::pow(std::max(d, 0.0), 1.0 / law.power) / law.slope; };
    const double first_displacement = std::isnan(displacement(0)) ? departure(first) : displacement(0);
    const double earliest = std::max({still - time_to_reach(threshold),
                                      at_first - time_to_reach(first_displacement + threshold),
                                      still - 0.5 * (times(count - 1) - times(0))});
    return std::clamp(std::max(law.start_s, earliest), movers.time_s(0), at_first);
}

std::string seconds_text(double seconds) { return format_number(seconds, 5) + " s"; }

/// Markers that depart from their recent position, as a recording of them alone.
struct MovingMarkers {
    std::vector<std::string> labels;
    std::vector<Eigen::VectorXd> departures;  // [m], one vector per marker
};

MovingMarkers moving_markers(const Recording& chosen, const Window& window, const MotionStartOptions& options) {
    std::vector<Eigen::VectorXd> departure;
    std::vector<double> peaks;
    for (const Eigen::Matrix3Xd& track : chosen.tracks) {
        departure.push_back(departures(track, window));
        peaks.push_back(sustained_peak(departure.back(), options.sustained_samples));
    }
    const double largest = peaks.empty() ? 0.0 : *std::max_element(peaks.begin(), peaks.end());
    MovingMarkers moving;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        if (!(peaks[i] > options.mover_fraction * largest)) continue;
        moving.departures.push_back(departure[i]);
        moving.labels.push_back(chosen.labels[i]);
    }
    return moving;
}

/// A low quantile of the departures of the group. In a still recording all departures have similar size, whatever the
/// type of noise.
double quiet_departure(const Eigen::VectorXd& group) {
    std::vector<double> known;
    for (const double value : group) {
        if (!std::isnan(value)) known.push_back(value);
    }
    std::sort(known.begin(), known.end());
    return known.empty() ? 0.0 : known[known.size() / 5];
}

/// Departure that counts as motion in the search backwards from the first certain motion, sample `gross`.
double backward_threshold(const Eigen::VectorXd& group, Eigen::Index gross, double peak, double noise_m,
                          const MotionStartOptions& options) {
    double threshold_m = std::max(options.noise_factor * noise_m, 0.002 * peak);
    if (gross < 12) return threshold_m;
    std::vector<double> before;
    for (Eigen::Index t = 1; t < gross; ++t) {
        if (!std::isnan(group(t))) before.push_back(group(t));
    }
    // Noise need not be white: departures before the motion count as well (2.5 medians are about 4 deviations).
    if (!before.empty()) {
        const double usual = median(
            Eigen::Map<Eigen::VectorXd>(before.data(), static_cast<Eigen::Index>(before.size())));
        threshold_m = std::max(threshold_m, std::min(2.5 * usual, options.gross_fraction * peak));
    }
    return threshold_m;
}

/// The start of the motion whose first certain sample is known: the first moving sample, and the onset between the
/// samples.
///
/// @param samples  indices in the recording of the samples in `group`
void locate_start(StartOfMotion& result, const Recording& movers, const Eigen::VectorXd& group,
                  const std::vector<Eigen::Index>& samples, Eigen::Index gross, double peak, const Window& window) {
    const Eigen::Index first = trace_back(group, gross, result.threshold_m);
    if (first <= 1) {
        // Sample 0 is its own reference: whether the body was at rest then is unknown.
        result.message = "the motion has started by the second sample, so the start is taken at the first one, " +
                         seconds_text(result.time_s) + "; give the start if the recording begins later";
        return;
    }
    result.found = true;
    result.first_moving = samples[static_cast<std::size_t>(first)];
    result.last_still = result.first_moving - 1;
    result.time_s = onset_time(movers, group, first, peak, result.threshold_m, window);
    result.message = "motion starts at " + seconds_text(result.time_s) + " (sample " +
                     std::to_string(result.first_moving) + " is the first to leave the rest by more than " +
                     format_number(1e3 * result.threshold_m, 3) + " mm)";
}

/// The start of the motion of the moving markers: departure of the group, first certain motion, threshold of the search
/// backwards, first moving sample.
void find_group_start(StartOfMotion& result, const Recording& movers, const std::vector<Eigen::VectorXd>& moving,
                      const std::vector<Eigen::Index>& samples, const Window& window,
                      const MotionStartOptions& options) {
    const Eigen::VectorXd group = group_departure(moving);
    const double peak = sustained_peak(group, options.sustained_samples);
    result.noise_m = mean_noise(estimate_noise(movers));
    if (!(peak > std::max(10.0 * result.noise_m, 5.0 * quiet_departure(group)))) {
        result.message = "no marker leaves its rest clearly: the largest departure is " + format_number(1e3 * peak, 3) +
                         " mm";
        return;
    }
    const std::optional<Eigen::Index> gross = first_sustained(group, options.gross_fraction * peak,
                                                              options.sustained_samples);
    if (!gross) {
        result.message = "no sustained motion";
        return;
    }
    result.threshold_m = backward_threshold(group, *gross, peak, result.noise_m, options);
    locate_start(result, movers, group, samples, *gross, peak, window);
}

}  // namespace

StartOfMotion find_motion_start(const Recording& recording, const std::vector<std::string>& labels,
                                const MotionStartOptions& options) {
    StartOfMotion result;
    if (recording.sample_count() == 0) {
        result.message = "the recording is empty";
        return result;
    }
    result.time_s = recording.time_s(0);
    // Repeated samples have no time of their own: without them the sample intervals are those of the motion.
    const std::vector<Eigen::Index> samples = new_samples(recording);
    const Result<Recording> chosen = select_labels(take_samples(recording, samples),
                                                   labels.empty() ? recording.labels : labels);
    if (!chosen) {
        result.message = chosen.error().what;
        return result;
    }
    const Window window = reference_window(recording, options);
    const MovingMarkers moving = moving_markers(*chosen, window, options);
    result.movers = moving.labels;
    if (moving.labels.empty()) {
        result.message = "no marker moves";
        return result;
    }
    const Recording movers = select_labels(*chosen, result.movers).value();
    find_group_start(result, movers, moving.departures, samples, window, options);
    return result;
}

}  // namespace myo::measurement
