#include "statistics/residual_tests.hpp"

#include <cassert>
#include <cmath>

#include "statistics/autocorrelation.hpp"

namespace myo::statistics {

namespace {

/// Estimate of a mean square and its variance.
struct MeanSquare {
    double value = 0.0, variance = 0.0;
    double entries = 0.0;  // of the residual, on which it rests
};

/// Autocovariance up to lag 2, summed over the series of more than one sample.
Autocovariance pooled_in_time(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    Autocovariance pooled{Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)};
    for (const ResidualSeries& series : layout.series) {
        if (series.size() < 2) continue;
        const Autocovariance own = autocovariance(gridded(r, layout, series), 2);
        pooled.sums.head(own.sums.size()) += own.sums;
        pooled.pairs.head(own.pairs.size()) += own.pairs;
    }
    return pooled;
}

/// From the autocovariance of series in time: white noise drops out regardless of its variance.
MeanSquare systematic_in_time(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    const Autocovariance pooled = pooled_in_time(r, layout);
    if (!(pooled.pairs(1) > 0.0 && pooled.pairs(2) > 0.0)) return {};
    MeanSquare result;
    // The parabola c(k) = a - b k^2 through k = 1 and 2 has a = (4 c1 - c2) / 3.
    result.value = (4.0 * pooled.sums(1) / pooled.pairs(1) - pooled.sums(2) / pooled.pairs(2)) / 3.0;
    // Variance of the estimate: products of white noise w contribute w^2 per pair; products of w with a smooth signal s
    // contribute 4 s^2 w^2 and are common to both lags.
    const double total = pooled.sums(0) / pooled.pairs(0);
    const double smooth = std::min(std::max(0.0, result.value), total);
    const double white = total - smooth;
    result.variance = (16.0 / pooled.pairs(1) + 1.0 / pooled.pairs(2)) / 9.0 * white * white +
                      4.0 * smooth * white / pooled.pairs(0);
    result.entries = pooled.pairs(0);
    return result;
}

/// From series of a single sample, such as poses: the mean square beyond that of the noise, 1.
MeanSquare systematic_of_poses(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    MeanSquare result;
    double squares = 0.0;
    for (const ResidualSeries& series : layout.series)
        if (series.size() == 1) {
            squares += r(series.begin) * r(series.begin);
            result.entries += 1.0;
        }
    if (!(result.entries > 0.0)) return {};
    result.value = squares / result.entries - 1.0;
    // Variance of the square of s + w with white noise w of variance 1: 2 + 4 s^2.
    result.variance = (2.0 + 4.0 * std::max(0.0, result.value)) / result.entries;
    return result;
}

}  // namespace

SystematicRms systematic_rms(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    assert(r.size() == layout.size());
    const MeanSquare in_time = systematic_in_time(r, layout), of_poses = systematic_of_poses(r, layout);
    SystematicRms result;
    const double entries = in_time.entries + of_poses.entries;
    if (!(entries > 0.0)) return result;
    const double weight = in_time.entries / entries, other = of_poses.entries / entries;
    result.mean_square = weight * in_time.value + other * of_poses.value;
    result.rms = std::sqrt(std::max(0.0, result.mean_square));
    result.mean_square_deviation = std::sqrt(weight * weight * in_time.variance + other * other * of_poses.variance);
    // Delta method. It fails near zero, where the square root of the deviation of the square bounds the rms.
    if (result.mean_square_deviation > 0.0)
        result.deviation = result.mean_square_deviation /
                           (2.0 * std::max(result.rms, std::sqrt(result.mean_square_deviation)));
    return result;
}

ResidualTests test_residuals(const Eigen::VectorXd& r, const ResidualLayout& layout, int parameters,
                             const ResidualTestOptions& options) {
    assert(is_consistent(layout) && r.size() == layout.size());
    ResidualTests tests;
    tests.samples = r.size();
    tests.alpha = options.alpha;
    tests.threshold = options.alpha / 4.0;
    tests.variance = variance_test(r, parameters, options.noise_tolerance);
    tests.ljung_box = ljung_box_test(r, layout, options.lags, options.draws, options.seed);
    tests.periodicity = periodicity_test(r, layout);
    tests.space = space_test(r, layout, options.draws, options.seed);
    tests.systematic = systematic_rms(r, layout);
    return tests;
}

}  // namespace myo::statistics
