#include "statistics/residual_spot.hpp"

#include <algorithm>
#include <cassert>
#include <map>

namespace myo::statistics {
namespace {

using Eigen::Index;

struct ResidualSpotPolicy {
    double most = 0.8;
    double short_time = 0.25;  // share of all squares; largest duration relative to the trial
    /// Share of the squares in the interval that the listed markers must reach.
    double nearly_all = 0.9;
};
constexpr ResidualSpotPolicy residual_spot_policy;

/// Calls see(series, entry) for all entries of a trial.
template <class See>
void for_entries(const ResidualLayout& layout, int trial, const See& see) {
    for (const ResidualSeries& series : layout.series)
        if (series.trial == trial)
            for (Index k = series.begin; k < series.end; ++k) see(series, k);
}

/// Sum of squares at each time of a trial.
std::map<double, double> squares_over_time(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial) {
    std::map<double, double> squares;
    for_entries(layout, trial, [&](const ResidualSeries&, Index k) {
        squares[layout.time_s[static_cast<std::size_t>(k)]] += r(k) * r(k);
    });
    return squares;
}

/// Smallest set of markers with nearly all squares between `spot.from_s` and `spot.to_s`.
std::vector<int> loudest_markers(const Eigen::VectorXd& r, const ResidualLayout& layout, const ResidualSpot& spot) {
    std::map<int, double> squares;
    double all = 0.0;
    for_entries(layout, spot.trial, [&](const ResidualSeries& series, Index k) {
        const double time = layout.time_s[static_cast<std::size_t>(k)];
        if (time < spot.from_s || time > spot.to_s) return;
        squares[series.marker] += r(k) * r(k);
        all += r(k) * r(k);
    });
    std::vector<std::pair<double, int>> loud;
    for (const auto& [marker, own] : squares) loud.emplace_back(own, marker);
    std::sort(loud.rbegin(), loud.rend());
    std::vector<int> markers;
    double sum = 0.0;
    for (std::size_t i = 0; i < loud.size() && sum < residual_spot_policy.nearly_all * all; sum += loud[i++].first)
        markers.push_back(loud[i].second);
    std::sort(markers.begin(), markers.end());
    return markers;
}

}  // namespace

std::optional<ResidualSpot> residual_spot(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    assert(r.size() == layout.size());
    const double all = r.squaredNorm();
    if (!(all > 0.0)) return std::nullopt;
    for (const int trial : trials_of(layout)) {
        const std::map<double, double> squares = squares_over_time(r, layout, trial);
        const double longest = residual_spot_policy.short_time * (squares.rbegin()->first - squares.begin()->first);
        std::optional<ResidualSpot> spot;
        double within = 0.0;
        // Two-pointer sweep: for each end, the latest start that still holds the required share.
        for (auto first = squares.begin(), last = squares.begin(); last != squares.end(); ++last) {
            within += last->second;
            for (; within - first->second >= residual_spot_policy.most * all; ++first) within -= first->second;
            const double length = last->first - first->first;
            if (within >= residual_spot_policy.most * all && length <= longest &&
                (!spot || length < spot->to_s - spot->from_s))
                spot = ResidualSpot{trial, {}, first->first, last->first, within / all};
        }
        if (!spot) continue;
        spot->markers = loudest_markers(r, layout, *spot);
        return spot;
    }
    return std::nullopt;
}

}  // namespace myo::statistics
