#include "measurement/false_stretches.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "measurement/gaps.hpp"
#include "measurement/marker_predictor.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;

/// Thresholds of find_false_stretches().
struct FalseStretchPolicy {
    double min_deviations = 20.0;   // of the noise, as for excursions
    double min_ratio = 6.0;         // over the fitted samples, as for excursions
    double least_offset_m = 1e-3;   // cameras do not take one marker for another that is nearer
    double unexplained = 5.0;       // of what the principal motions leave unexplained in the others
    double return_share = 0.5;      // of the threshold within which the samples on both sides must be
    std::size_t side_samples = 5;   // examined on each side ...
    std::size_t min_side = 3;       // ... and needed there
    std::size_t max_breaks = 12;    // with the largest jumps; bounds the number of candidates
    std::size_t max_stretches = 8;  // of one recording; more is no isolated fault
};
constexpr FalseStretchPolicy false_stretch_policy;

/// A place where a track may change over to something else.
struct TrackBreak {
    std::size_t after = 0;  // place behind it in the list of predicted samples
    bool is_gap = false;
    double jump_m = 0.0;  // of the residual of a first prediction
};

/// Distance beyond which a sample is false [m].
double threshold_m(const MarkerPredictor& predictor, const MarkerPredictor::Fit& fit, std::size_t place,
                   double sigma_m) {
    return std::max({false_stretch_policy.least_offset_m, false_stretch_policy.min_deviations * sigma_m,
                     false_stretch_policy.min_ratio * fit.largest_m}) *
           predictor.widening(fit, place);
}

/// First sample behind the longest gap between two visible samples; without a gap, behind the longest step.
Index first_behind_break(const Eigen::Matrix3Xd& track, Index before, Index after) {
    Index last = before, first = after;
    std::pair<Index, double> longest{0, -1.0};  // gap, then step: any gap counts more than any step
    for (Index t = before + 1; t <= after; ++t) {
        if (!is_seen(track, t)) continue;
        const bool gap = t - last > 1;
        const std::pair<Index, double> length{gap ? t - last : 1, gap ? 0.0 : (track.col(t) - track.col(last)).norm()};
        if (length > longest) longest = length, first = t;
        last = t;
    }
    return first;
}

/// Breaks of the track, those with the largest jumps.
std::vector<TrackBreak> breaks_of(const MarkerPredictor& predictor, const Eigen::Matrix3Xd& track, double sigma_m) {
    const std::optional<MarkerPredictor::Fit> first = predictor.fit();
    const std::vector<Index>& samples = predictor.samples();
    if (!first || samples.size() < 2) return {};
    std::vector<TrackBreak> breaks;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        bool is_gap = false;
        for (Index t = samples[i - 1] + 1; t < samples[i]; ++t) is_gap = is_gap || !is_seen(track, t);
        const double jump_m = (predictor.residual(*first, i) - predictor.residual(*first, i - 1)).norm();
        if (jump_m > false_stretch_policy.min_deviations * sigma_m) breaks.push_back({i, is_gap, jump_m});
    }
    std::sort(breaks.begin(), breaks.end(),
              [](const TrackBreak& a, const TrackBreak& b) { return a.jump_m > b.jump_m; });
    if (breaks.size() > false_stretch_policy.max_breaks) breaks.resize(false_stretch_policy.max_breaks);
    std::sort(breaks.begin(), breaks.end(), [](const TrackBreak& a, const TrackBreak& b) { return a.after < b.after; });
    return breaks;
}

/// Least distance of the samples at the places [first, end) over the threshold; 0 if the stretch is not false.
double falsehood(const MarkerPredictor& predictor, std::size_t first, std::size_t end, double sigma_m,
                 double& offset_m) {
    const std::size_t count = predictor.samples().size();
    if (first < false_stretch_policy.min_side || end + false_stretch_policy.min_side > count ||
        2 * (end - first) > count)
        return 0.0;
    const std::optional<MarkerPredictor::Fit> fit = predictor.fit(first, end);
    if (!fit) return 0.0;
    const auto returns = [&](std::size_t i) {
        return predictor.distance(*fit, i) <=
               false_stretch_policy.return_share * threshold_m(predictor, *fit, i, sigma_m);
    };
    for (std::size_t k = 1; k <= false_stretch_policy.side_samples; ++k) {
        if (first >= k && !returns(first - k)) return 0.0;
        if (end + k <= count && !returns(end + k - 1)) return 0.0;
    }
    double least = std::numeric_limits<double>::infinity();
    offset_m = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        const double distance_m = predictor.distance(*fit, i);
        least = std::min(least, distance_m / (threshold_m(predictor, *fit, i, sigma_m) +
                                              false_stretch_policy.unexplained * predictor.unexplained_m(i)));
        offset_m = std::max(offset_m, distance_m);
    }
    return least > 1.0 ? least : 0.0;
}

/// Whether a hidden sample lies between visible ones.
bool has_inner_gap(const Eigen::Matrix3Xd& track) {
    Index changes = 0;
    for (Index t = 1; t < track.cols(); ++t) changes += is_seen(track, t) != is_seen(track, t - 1) ? 1 : 0;
    return changes >= 2;
}

/// The most certain false stretch of a marker.
std::optional<std::pair<double, FalseStretch>> worst_of(const std::vector<Eigen::Matrix3Xd>& tracks, std::size_t marker,
                                                        double sigma_m) {
    const Eigen::Matrix3Xd& track = tracks[marker];
    if (!has_inner_gap(track)) return std::nullopt;
    const MarkerPredictor predictor(tracks, marker, sigma_m);
    if (!predictor.is_usable()) return std::nullopt;
    const std::vector<TrackBreak> breaks = breaks_of(predictor, track, sigma_m);
    const std::vector<Index>& samples = predictor.samples();
    const auto behind = [&](const TrackBreak& place) {
        return first_behind_break(track, samples[place.after - 1], samples[place.after]);
    };
    std::optional<std::pair<double, FalseStretch>> worst;
    for (std::size_t a = 0; a < breaks.size(); ++a)
        for (std::size_t b = a + 1; b < breaks.size(); ++b) {
            if (!breaks[a].is_gap && !breaks[b].is_gap) continue;
            double offset_m = 0.0;
            const double certainty = falsehood(predictor, breaks[a].after, breaks[b].after, sigma_m, offset_m);
            if (!(certainty > (worst ? worst->first : 0.0))) continue;
            worst = {certainty, {marker, behind(breaks[a]), behind(breaks[b]), offset_m}};
            // The gap behind the stretch is no part of it.
            while (!is_seen(track, worst->second.end - 1)) --worst->second.end;
        }
    return worst;
}

}  // namespace

std::vector<FalseStretch> find_false_stretches(const std::vector<Eigen::Matrix3Xd>& tracks,
                                               const Eigen::VectorXd& sigma_m) {
    assert(sigma_m.size() == static_cast<Index>(tracks.size()));
    std::vector<Eigen::Matrix3Xd> left = tracks;
    std::vector<FalseStretch> found;
    // The most certain one first: as long as it is there, it disturbs the predictions of other markers.
    while (found.size() < false_stretch_policy.max_stretches) {
        std::optional<std::pair<double, FalseStretch>> worst;
        for (std::size_t m = 0; m < left.size(); ++m) {
            const auto own = worst_of(left, m, sigma_m(static_cast<Index>(m)));
            if (own && (!worst || own->first > worst->first)) worst = own;
        }
        if (!worst) break;
        const FalseStretch& stretch = worst->second;
        left[stretch.marker]
            .middleCols(stretch.first, stretch.end - stretch.first)
            .setConstant(std::numeric_limits<double>::quiet_NaN());
        found.push_back(stretch);
    }
    std::sort(found.begin(), found.end(),
              [](const FalseStretch& a, const FalseStretch& b) { return a.first < b.first; });
    return found;
}

}  // namespace myo::measurement
