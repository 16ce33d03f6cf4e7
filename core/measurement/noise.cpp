#include "measurement/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "measurement/gaps.hpp"
#include "measurement/robust.hpp"

namespace myo::measurement {
namespace {

struct NoisePolicy {
    /// Sixth differences pass 1e-4 of a 6 Hz vibration at 100 Hz, fifth ones 5 times as much. Higher orders would
    /// respond only to noise near half the frame rate, where cameras have less of it.
    Eigen::Index order = 6;
    double white_gain = 924.0;  // sum of the squared binomial coefficients
    /// Windows in samples: short enough to find still intervals, long enough for a stable mean square.
    Eigen::Index longest_window = 21;
    Eigen::Index shortest_window = 6;
    /// The iteration starts from this quantile of the windows and keeps windows up to the still quantile of chance.
    double start_quantile = 0.1;
    double still_quantile = 0.98;
    int quantile_steps = 200;  // of the midpoint rule for the truncated mean
    int min_changes = 20;
    double exact = 1e-6;  // relative to a unit: decimal text is not exact in binary
};
constexpr NoisePolicy noise_policy;
constexpr std::array<double, noise_policy.order + 1> binomials{1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0};

// Quantile of chi^2 / degrees of freedom by the approximation of Wilson and Hilferty 1931 (cube of a normal variable).
double mean_square_quantile(double probability, double freedom) {
    // Normal quantile by Abramowitz and Stegun 26.2.23, accurate to 5e-4.
    const double tail = std::min(probability, 1.0 - probability);
    const double t = std::sqrt(-2.0 * std::log(tail));
    const double z = t - (2.515517 + 0.802853 * t + 0.010328 * t * t) /
                             (1.0 + 1.432788 * t + 0.189269 * t * t + 0.001308 * t * t * t);
    const double spread = 2.0 / (9.0 * freedom);
    return std::pow(1.0 - spread + (probability < 0.5 ? -z : z) * std::sqrt(spread), 3.0);
}

// Effective degrees of freedom of the mean of `window` squared differences in three coordinates; neighbouring
// differences are correlated because they share samples.
double degrees_of_freedom(Eigen::Index window) {
    double squares = 1.0;
    for (Eigen::Index lag = 1; lag <= std::min<Eigen::Index>(noise_policy.order, window - 1); ++lag) {
        double covariance = 0.0;
        for (Eigen::Index k = 0; k + lag <= noise_policy.order; ++k) {
            covariance += binomials[static_cast<std::size_t>(k)] * binomials[static_cast<std::size_t>(k + lag)];
        }
        // Variance of a mean of correlated terms: sum of squared correlations, weighted by the number of pairs at each
        // lag.
        const double correlation = covariance / noise_policy.white_gain;
        squares += 2.0 * (1.0 - static_cast<double>(lag) / static_cast<double>(window)) * correlation * correlation;
    }
    return 3.0 * static_cast<double>(window) / squares;
}

// Runs of consecutive visible samples, repetitions removed, long enough for one difference.
std::vector<Eigen::Matrix3Xd> runs_of(const Eigen::Matrix3Xd& track, const std::vector<Eigen::Index>& repeats) {
    std::vector<Eigen::Matrix3Xd> runs;
    std::vector<Eigen::Index> run;
    const auto close = [&] {
        if (run.size() > static_cast<std::size_t>(noise_policy.order)) runs.emplace_back(track(Eigen::all, run));
        run.clear();
    };
    for (Eigen::Index t = 0; t < track.cols(); ++t) {
        if (!is_seen(track, t))
            close();
        else if (!std::binary_search(repeats.begin(), repeats.end(), t))
            run.push_back(t);
    }
    close();
    return runs;
}

// Squared norm of the differences per coordinate, scaled to unit gain for white noise.
Eigen::VectorXd squared_differences(const Eigen::Matrix3Xd& run) {
    Eigen::VectorXd squares(run.cols() - noise_policy.order);
    for (Eigen::Index t = 0; t < squares.size(); ++t) {
        Eigen::Vector3d difference = Eigen::Vector3d::Zero();
        for (Eigen::Index k = 0; k <= noise_policy.order; ++k)
            difference += binomials[static_cast<std::size_t>(k)] * run.col(t + k);
        squares(t) = difference.squaredNorm() / (3.0 * noise_policy.white_gain);
    }
    return squares;
}

// Smallest difference between distinct values of a coordinate: an estimate of the rounding unit.
double smallest_step(const Eigen::Matrix3Xd& track) {
    double step = 0.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (Eigen::Index t = 0; t < track.cols(); ++t) {
            if (is_seen(track, t)) values.push_back(track(axis, t));
        }
        std::sort(values.begin(), values.end());
        for (std::size_t k = 1; k < values.size(); ++k) {
            const double gap = values[k] - values[k - 1];
            // Decimal text is not exact in binary: equal differences, and equal values after scaling, differ by
            // rounding.
            if (gap > 1e-12 && (step == 0.0 || gap < step)) step = gap;
        }
    }
    return step;
}

// Variance of the still windows, by fixed-point iteration: the limit of still windows depends on the variance, and the
// variance on the windows below the limit.
double still_variance(std::vector<double> means, double freedom) {
    std::sort(means.begin(), means.end());
    const auto low = static_cast<std::size_t>(noise_policy.start_quantile * static_cast<double>(means.size()));
    // Start from a low quantile of the windows, which is unaffected if at least that fraction is still.
    double variance = means[low] /
                      mean_square_quantile(
                          std::max(noise_policy.start_quantile, 0.5 / static_cast<double>(means.size())), freedom);
    double kept_mean = 0.0;  // mean of chi^2 / freedom below the still quantile: corrects the truncation
    for (int k = 0; k < noise_policy.quantile_steps; ++k)
        kept_mean += mean_square_quantile(noise_policy.still_quantile * (k + 0.5) / noise_policy.quantile_steps,
                                          freedom) /
                     noise_policy.quantile_steps;
    for (int pass = 0; pass < 100; ++pass) {
        const double limit = variance * mean_square_quantile(noise_policy.still_quantile, freedom);
        const auto end = std::upper_bound(means.begin(), means.end(), limit);
        if (end == means.begin()) break;
        const double next = std::accumulate(means.begin(), end, 0.0) / static_cast<double>(end - means.begin()) /
                            kept_mean;
        if (std::abs(next - variance) <= 1e-9 * variance) break;
        variance = next;
    }
    return variance;
}

NoiseEstimate estimate(const Eigen::Matrix3Xd& track, const std::vector<Eigen::Index>& repeats) {
    NoiseEstimate result;
    std::vector<Eigen::VectorXd> squares;
    Eigen::Index longest = 0;
    for (const Eigen::Matrix3Xd& run : runs_of(track, repeats)) {
        squares.push_back(squared_differences(run));
        longest = std::max(longest, squares.back().size());
    }
    const Eigen::Index window = std::min(longest, noise_policy.longest_window);
    if (window < noise_policy.shortest_window) return result;

    std::vector<double> means;
    // Windows overlap by half.
    for (const Eigen::VectorXd& run : squares) {
        for (Eigen::Index t = 0; t + window <= run.size(); t += std::max<Eigen::Index>(window / 2, 1)) {
            means.push_back(run.segment(t, window).mean());
        }
    }
    const double freedom = degrees_of_freedom(window);
    const double variance = still_variance(means, freedom);
    const double limit = variance * mean_square_quantile(noise_policy.still_quantile, freedom);
    const auto still = std::count_if(means.begin(), means.end(), [&](double mean) { return mean <= limit; });
    result.found = true;
    result.quantum_m = smallest_step(track);
    result.sigma_m = std::max(std::sqrt(variance), rounding_deviation(result.quantum_m));
    result.still_samples = std::min<Eigen::Index>(still * std::max<Eigen::Index>(window / 2, 1), track.cols());
    return result;
}

}  // namespace

std::vector<NoiseEstimate> estimate_noise(const Recording& recording) {
    const std::vector<Eigen::Index> repeats = repeated_samples(recording);
    std::vector<NoiseEstimate> result;
    for (std::size_t i = 0; i < recording.labels.size(); ++i) {
        result.push_back(estimate(recording.tracks[i], repeats));
        result.back().label = recording.labels[i];
    }
    return result;
}

NoiseEstimate estimate_track_noise(const Eigen::Matrix3Xd& track) {
    Recording single;
    single.labels = {""};
    single.tracks = {track};
    single.time_s = Eigen::VectorXd::LinSpaced(track.cols(), 0.0, static_cast<double>(track.cols()));
    return estimate(track, repeated_samples(single));
}

double rounding_step(const std::vector<Eigen::Matrix3Xd>& tracks) {
    constexpr std::array<double, 12> per_metre{2e2, 5e2, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4, 1e5, 2e5, 5e5, 1e6};
    int changes = 0;
    for (const Eigen::Matrix3Xd& track : tracks)
        for (Eigen::Index t = 1; t < track.cols(); ++t)
            if (is_seen(track, t - 1) && is_seen(track, t))
                changes += static_cast<int>((track.col(t).array() != track.col(t - 1).array()).count());
    if (changes < noise_policy.min_changes) return 0.0;
    const auto all_are_multiples = [&](double steps) {
        return std::all_of(tracks.begin(), tracks.end(), [&](const Eigen::Matrix3Xd& track) {
            return std::all_of(track.reshaped().begin(), track.reshaped().end(), [&](double x) {
                return !std::isfinite(x) || std::abs(x * steps - std::round(x * steps)) < noise_policy.exact;
            });
        });
    };
    const auto found = std::find_if(per_metre.begin(), per_metre.end(), all_are_multiples);
    return found != per_metre.end() ? 1.0 / *found : 0.0;
}

double rounding_deviation(double step) { return step / std::sqrt(12.0); }

double mean_noise(const std::vector<NoiseEstimate>& estimates) {
    double squares = 0.0;
    int count = 0;
    for (const NoiseEstimate& estimate : estimates) {
        if (!estimate.found) continue;
        squares += estimate.sigma_m * estimate.sigma_m;
        ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : 0.0;
}

}  // namespace myo::measurement
