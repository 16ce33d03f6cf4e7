#include "statistics/autocorrelation.hpp"

#include <algorithm>
#include <cassert>

namespace myo::statistics {
namespace {

// Lags of the variance inflation and their triangular weights. The triangular window keeps the estimated variance from
// becoming negative.
int window_lags(Eigen::Index length) { return static_cast<int>(length / 3); }

double window_weight(Eigen::Index lag, int lags) { return 1.0 - static_cast<double>(lag) / (lags + 1.0); }

// Variance of sum r s for independent r and s, and its value for white r.
struct Inflated {
    double variance = 0.0;
    double white = 0.0;
};

Inflated inflated(const GriddedSeries& r, const GriddedSeries& s) {
    const int lags = window_lags(r.values.size());
    const Autocovariance of_r = autocovariance(r, lags);
    const Autocovariance of_s = autocovariance(s, lags);
    Inflated result;
    if (!(of_r.pairs(0) > 0.0)) return result;
    const double mean_square = of_r.sums(0) / of_r.pairs(0);
    result.white = mean_square * of_s.sums(0);
    result.variance = result.white;
    for (Eigen::Index lag = 1; lag < of_r.sums.size(); ++lag) {
        if (!(of_r.pairs(lag) > 0.0)) continue;
        // Biased estimate (division by all samples): smaller variance at lags with few pairs.
        const double covariance = of_r.sums(lag) / of_r.pairs(lag) *
                                  (1.0 - static_cast<double>(lag) / static_cast<double>(r.values.size()));
        result.variance += 2.0 * window_weight(lag, lags) * covariance * of_s.sums(lag);
    }
    return result;
}

}  // namespace

Eigen::VectorXd Autocovariance::correlation() const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(sums.size());
    if (sums.size() == 0 || !(sums(0) > 0.0)) return result;
    const double mean_square = sums(0) / pairs(0);
    for (Eigen::Index lag = 0; lag < sums.size(); ++lag)
        if (pairs(lag) > 0.0) result(lag) = sums(lag) / pairs(lag) / mean_square;
    return result;
}

Autocovariance autocovariance(const GriddedSeries& series, int lags) {
    assert(lags >= 0 && series.seen.size() == series.values.size());
    const Eigen::Index length = series.values.size();
    const Eigen::Index count = std::max<Eigen::Index>(std::min<Eigen::Index>(lags, length - 1), 0) + 1;
    Autocovariance result{Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)};
    if (length == 0) return result;
    const bool complete = series.seen.minCoeff() == 1.0;
    // Unseen samples are zero, so they drop out of the sums. Only the pair count needs the mask.
    for (Eigen::Index lag = 0; lag < count; ++lag) {
        const Eigen::Index both = length - lag;
        result.sums(lag) = series.values.head(both).dot(series.values.tail(both));
        result.pairs(lag) = complete ? static_cast<double>(both) : series.seen.head(both).dot(series.seen.tail(both));
    }
    return result;
}

Autocovariance pooled_autocovariance(const Eigen::VectorXd& r, const ResidualLayout& layout, int lags, int trial) {
    Autocovariance pooled{Eigen::VectorXd::Zero(lags + 1), Eigen::VectorXd::Zero(lags + 1)};
    for (const ResidualSeries& series : layout.series) {
        if ((trial >= 0 && series.trial != trial) || series.size() == 0) continue;
        const Autocovariance own = autocovariance(gridded(r, layout, series), lags);
        pooled.sums.head(own.sums.size()) += own.sums;
        pooled.pairs.head(own.pairs.size()) += own.pairs;
    }
    return pooled;
}

double variance_inflation(const GriddedSeries& r, const GriddedSeries& s) {
    const Inflated sum = inflated(r, s);
    return sum.white > 0.0 ? std::max(1.0, sum.variance / sum.white) : 1.0;
}

double variance_inflation(const Eigen::VectorXd& r, const Eigen::VectorXd& s, const ResidualLayout& layout) {
    assert(r.size() == layout.size() && s.size() == layout.size());
    Inflated sum;
    for (const ResidualSeries& series : layout.series) {
        if (series.size() == 0) continue;
        const Inflated own = inflated(gridded(r, layout, series), gridded(s, layout, series));
        sum.variance += own.variance;
        sum.white += own.white;
    }
    return sum.white > 0.0 ? std::max(1.0, sum.variance / sum.white) : 1.0;
}

double effective_samples(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    double total = 0.0;
    for (const ResidualSeries& series : layout.series) {
        if (series.size() == 0) continue;
        const GriddedSeries grid = gridded(r, layout, series);
        const int lags = window_lags(grid.values.size());
        const Autocovariance covariance = autocovariance(grid, lags);
        const Eigen::VectorXd rho = covariance.correlation();
        double squares = 0.0, by_chance = 0.0;
        for (Eigen::Index lag = 1; lag < rho.size(); ++lag)
            if (covariance.pairs(lag) > 0.0) {
                squares += window_weight(lag, lags) * rho(lag) * rho(lag);
                by_chance += window_weight(lag, lags) / covariance.pairs(lag);
            }
        const double n = static_cast<double>(series.size());
        // An estimated rho has variance V / pairs with V = 1 + 2 sum rho^2. Hence V = 1 + 2 squares - 2 V by_chance,
        // solved for V.
        const double inflation = (1.0 + 2.0 * squares) / (1.0 + 2.0 * by_chance);
        total += std::max(1.0, n / std::max(1.0, inflation));
    }
    return total;
}

}  // namespace myo::statistics
