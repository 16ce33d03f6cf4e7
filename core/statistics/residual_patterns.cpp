#include "statistics/residual_patterns.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "base/decompositions.hpp"

namespace myo::statistics {
namespace {

std::vector<int> markers_of(const GriddedTrial& grid, const ResidualLayout& layout) {
    std::set<int> markers;
    for (const int i : grid.series) markers.insert(layout.series[static_cast<std::size_t>(i)].marker);
    return {markers.begin(), markers.end()};
}

ResidualPatterns patterns_of(const GriddedTrial& grid, const ResidualLayout& layout, int modes) {
    ResidualPatterns result;
    result.trial = grid.trial;
    result.time_s = grid.time_s;
    result.markers = markers_of(grid, layout);
    const double energy = grid.values.squaredNorm();
    if (!(energy > 0.0)) return result;
    const LeadingSvd svd = leading_svd(grid.values, modes);
    const double rows = static_cast<double>(grid.values.rows());
    for (Eigen::Index k = 0; k < svd.sizes.size(); ++k) {
        const double size = svd.sizes(k);
        Eigen::VectorXd left = svd.left.col(k);
        Eigen::Index largest = 0;
        left.cwiseAbs().maxCoeff(&largest);
        // The sign of a singular vector is arbitrary: the largest entry is made positive, for reproducible reports.
        const double sign = left(largest) < 0.0 ? -1.0 : 1.0;
        // Root mean square 1 over the rows; the course then has the units of the residual.
        left *= sign * std::sqrt(rows);
        ResidualMode mode;
        mode.share = size * size / energy;
        mode.course = svd.right.col(k) * (sign * size / std::sqrt(rows));
        mode.pattern.setZero(3, static_cast<Eigen::Index>(result.markers.size()));
        for (std::size_t row = 0; row < grid.series.size(); ++row) {
            const ResidualSeries& series = layout.series[static_cast<std::size_t>(grid.series[row])];
            const auto place = std::lower_bound(result.markers.begin(), result.markers.end(), series.marker);
            mode.pattern(series.axis, place - result.markers.begin()) = left(static_cast<Eigen::Index>(row));
        }
        result.modes.push_back(std::move(mode));
    }
    return result;
}

}  // namespace

std::vector<ResidualPatterns> residual_patterns(const Eigen::VectorXd& r, const ResidualLayout& layout, int modes) {
    assert(r.size() == layout.size() && modes >= 0);
    std::vector<ResidualPatterns> result;
    for (const int trial : trials_of(layout)) {
        const GriddedTrial grid = gridded_trial(r, layout, trial);
        if (!grid.series.empty()) result.push_back(patterns_of(grid, layout, modes));
    }
    return result;
}

}  // namespace myo::statistics
