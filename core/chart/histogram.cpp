#include <algorithm>
#include <cmath>

#include "chart/chart.hpp"
#include "chart/ticks.hpp"

namespace myo::chart {
namespace {

/// Quantile of sorted values without interpolation.
double quantile(const std::vector<double>& sorted, double q) {
    return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
}

// Rule of Freedman & Diaconis 1981: bin width 2 IQR n^(-1/3). Ten bins if the spread is zero.
int bins_by_spread(const std::vector<double>& sorted) {
    const double width = 2.0 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) /
                         std::cbrt(static_cast<double>(sorted.size()));
    const double range = sorted.back() - sorted.front();
    if (!(width > 0.0) || !(range > 0.0)) return 10;
    return static_cast<int>(std::clamp(std::ceil(range / width), 5.0, 60.0));
}

}  // namespace

Histogram histogram_of(const std::vector<double>& samples, int wanted_bins) {
    std::vector<double> sorted;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(sorted),
                 [](double v) { return std::abs(v) < 1e150; });
    Histogram histogram;
    // No edges and no counts: an empty chart.
    if (sorted.empty()) return histogram;
    std::sort(sorted.begin(), sorted.end());
    double lowest = sorted.front(), highest = sorted.back();
    // Equal samples: a range around their value.
    make_drawable(lowest, highest);
    // Ticks give the round bin width; edges are its multiples that cover all samples.
    const Ticks ticks = linear_ticks(lowest, highest, wanted_bins > 0 ? wanted_bins : bins_by_spread(sorted));
    const double width = ticks.values[1] - ticks.values[0];
    const double first = std::floor(lowest / width + 1e-9);
    // Tolerance: a sample on an edge up to rounding needs no further bin.
    const double bins = std::max(1.0, std::ceil(highest / width - 1e-9) - first);
    for (double k = 0.0; k <= bins; k += 1.0) histogram.edges.push_back((first + k) * width);
    histogram.counts.assign(histogram.edges.size() - 1, 0.0);
    // The tolerance matches that of the edges: a sample on an edge belongs to the bin above.
    for (const double value : sorted) {
        const double bin = std::clamp(std::floor(value / width + 1e-9) - first, 0.0, bins - 1.0);
        histogram.counts[static_cast<std::size_t>(bin)] += 1.0;
    }
    return histogram;
}

}  // namespace myo::chart
