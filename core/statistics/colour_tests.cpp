#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/autocorrelation.hpp"
#include "statistics/distributions.hpp"
#include "statistics/periodogram.hpp"
#include "statistics/random_signs.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::statistics {
namespace {

struct ColourTestsPolicy {
    /// Shorter series: the reference distributions are inaccurate, and autocorrelation is not detectable.
    Eigen::Index min_samples = 8;
};
constexpr ColourTestsPolicy colour_tests_policy;

// 1 / (duration of the grid): the grid of L samples lasts L sample intervals.
double frequency_step_Hz(const ResidualLayout& layout, const ResidualSeries& series) {
    const auto first = static_cast<std::size_t>(series.begin), last = static_cast<std::size_t>(series.end - 1);
    const double steps = layout.sample[last] - layout.sample[first];
    return steps / ((layout.time_s[last] - layout.time_s[first]) * (steps + 1.0));
}

// Ljung-Box sum of one series, evaluated repeatedly with flipped signs. The weights do not depend on signs.
struct Portmanteau {
    Eigen::VectorXd weights;  // per lag, from lag 1, of the squared sum of products
    double lags = 0.0;

    Portmanteau(const GriddedSeries& grid, int most) {
        const Autocovariance covariance = autocovariance(grid, most);
        weights.setZero(covariance.sums.size() - 1);
        if (!(covariance.sums(0) > 0.0)) return;
        // For a white Gaussian series about zero, the square of sums(lag) / sums(0) has expectation pairs / (n (n +
        // 2)).
        const double n = covariance.pairs(0);
        for (Eigen::Index lag = 1; lag < covariance.sums.size(); ++lag) {
            if (covariance.pairs(lag) < 4.0) continue;  // too few products for an estimate
            weights(lag - 1) = n * (n + 2.0) / (covariance.pairs(lag) * covariance.sums(0) * covariance.sums(0));
            lags += 1.0;
        }
    }

    double of(const Eigen::VectorXd& values) const {
        double sum = 0.0;
        for (Eigen::Index k = 0; k < weights.size(); ++k) {
            const Eigen::Index both = values.size() - k - 1;
            const double product = values.head(both).dot(values.tail(both));
            sum += weights(k) * product * product;
        }
        return sum;
    }
};

}  // namespace

LjungBoxTest ljung_box_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int lags, int draws,
                            unsigned seed) {
    assert(r.size() == layout.size() && lags > 0 && draws > 1);
    LjungBoxTest test;
    Eigen::ArrayXd null = Eigen::ArrayXd::Zero(draws);
    RandomSigns random(seed);
    for (const ResidualSeries& series : layout.series) {
        if (series.size() < colour_tests_policy.min_samples) continue;
        GriddedSeries grid = gridded(r, layout, series);
        const Portmanteau portmanteau(grid, std::min(lags, static_cast<int>(series.size() / 4)));
        if (portmanteau.lags == 0.0) continue;
        test.statistic += portmanteau.of(grid.values);
        test.lags += portmanteau.lags;
        // The null statistic is summed over series as the statistic itself: entry d of `null` uses draw d of every
        // series.
        for (double& statistic : null) {
            random.flip(grid.values);
            statistic += portmanteau.of(grid.values);
        }
    }
    if (test.lags == 0.0) return test;
    const double mean = null.mean();
    const double variance = (null - mean).square().sum() / (draws - 1);
    // Moment matching with c chi^2(f): mean c f, variance 2 c^2 f.
    if (variance > 0.0) test.p = chi_squared_tail(test.statistic * 2.0 * mean / variance, 2.0 * mean * mean / variance);
    return test;
}

PeriodicityTest periodicity_test(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    assert(r.size() == layout.size());
    PeriodicityTest test;
    double least = 1.0;
    double tried = 0.0;
    for (std::size_t i = 0; i < layout.series.size(); ++i) {
        const ResidualSeries& series = layout.series[i];
        if (series.size() < colour_tests_policy.min_samples) continue;
        const Eigen::VectorXd shares = energy_shares(gridded(r, layout, series));
        const double n = static_cast<double>(series.size());
        // With gaps fewer frequencies are independent, but the maximum is taken over all of them: a conservative count.
        tried += static_cast<double>(shares.size());
        for (Eigen::Index k = 0; k < shares.size(); ++k) {
            const double rest = std::max(0.0, 1.0 - shares(k));
            // Share of one direction: Student's t. Share of two directions (cosine and sine): (1 - x)^((n - 2) / 2).
            const double p = k == 0
                                 ? student_two_sided(std::sqrt(shares(0) * (n - 1.0) / std::max(rest, 1e-300)), n - 1.0)
                                 : std::pow(rest, 0.5 * (n - 2.0));
            if (test.series >= 0 && p >= least) continue;
            least = p;
            test.series = static_cast<int>(i);
            test.share = shares(k);
            test.frequency_Hz = static_cast<double>(k) * frequency_step_Hz(layout, series);
        }
    }
    if (test.series >= 0) test.p = std::min(1.0, tried * least);
    return test;
}

}  // namespace myo::statistics
