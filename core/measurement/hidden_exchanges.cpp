#include "measurement/hidden_exchanges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "measurement/gaps.hpp"
#include "measurement/marker_predictor.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;

/// Thresholds of put_back_hidden_exchanges().
struct HiddenExchangePolicy {
    double max_ratio = 0.25;         // of the residuals with and without the exchange, as for exchanges
    double min_residual_m = 1e-3;    // of the recording as it is; cameras tell nearer markers apart
    double min_deviations = 6.0;     // of the noise, likewise
    Index min_samples = 5;           // of an exchange that residuals can tell
    std::size_t max_exchanges = 8;   // of one recording
    std::size_t max_candidates = 8;  // beginnings and ends tried per pair of markers, bounds the effort
};
constexpr HiddenExchangePolicy hidden_exchange_policy;

/// An interval in which two markers may carry each other's names.
struct Suspect {
    std::size_t i = 0, j = 0;
    Index first = 0, end = 0;
};

/// Samples behind the common gaps of two tracks.
std::vector<Index> ends_of_common_gaps(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    std::vector<Index> ends;
    bool seen_before = false;
    for (Index t = 1; t < a.cols(); ++t) {
        seen_before = seen_before || (is_seen(a, t - 1) && is_seen(b, t - 1));
        if (seen_before && !is_seen(a, t - 1) && !is_seen(b, t - 1) && (is_seen(a, t) || is_seen(b, t)))
            ends.push_back(t);
    }
    return ends;
}

/// Samples at which two visible tracks continue each other better than themselves.
std::vector<Index> visible_exchanges(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    std::vector<Index> found;
    for (Index t = 1; t < a.cols(); ++t) {
        if (!is_seen(a, t) || !is_seen(b, t) || !is_seen(a, t - 1) || !is_seen(b, t - 1)) continue;
        const double own = (a.col(t) - a.col(t - 1)).norm() + (b.col(t) - b.col(t - 1)).norm(),
                     other = (a.col(t) - b.col(t - 1)).norm() + (b.col(t) - a.col(t - 1)).norm();
        if (other < hidden_exchange_policy.max_ratio * own) found.push_back(t);
    }
    return found;
}

void exchange_tracks(std::vector<Eigen::Matrix3Xd>& tracks, const Suspect& suspect) {
    const Index length = suspect.end - suspect.first;
    const Eigen::Matrix3Xd kept = tracks[suspect.i].middleCols(suspect.first, length);
    tracks[suspect.i].middleCols(suspect.first, length) = tracks[suspect.j].middleCols(suspect.first, length);
    tracks[suspect.j].middleCols(suspect.first, length) = kept;
}

/// Residual of both markers in fits to the others [m]; empty if these are too few.
std::optional<double> residual_m(const std::vector<Eigen::Matrix3Xd>& tracks, std::size_t i, std::size_t j,
                                 const Eigen::VectorXd& sigma_m) {
    double squares = 0.0;
    for (const auto& [marker, other] : {std::pair{i, j}, {j, i}}) {
        const MarkerPredictor predictor(tracks, marker, sigma_m(static_cast<Index>(marker)), {other});
        if (!predictor.is_usable()) return std::nullopt;
        const std::optional<MarkerPredictor::Fit> fit = predictor.fit(0, 0, false);
        if (!fit) return std::nullopt;
        squares += fit->rms_m * fit->rms_m;
    }
    return std::sqrt(0.5 * squares);
}

/// Intervals of two markers that may be exchanged.
std::vector<Suspect> suspects_of(const std::vector<Eigen::Matrix3Xd>& tracks, std::size_t i, std::size_t j) {
    std::vector<Index> begins = ends_of_common_gaps(tracks[i], tracks[j]);
    if (begins.empty() || begins.size() > hidden_exchange_policy.max_candidates) return {};
    std::vector<Index> ends = visible_exchanges(tracks[i], tracks[j]);
    if (ends.size() > hidden_exchange_policy.max_candidates) return {};
    ends.insert(ends.end(), begins.begin(), begins.end());
    ends.push_back(tracks[i].cols());
    std::vector<Suspect> suspects;
    for (const Index first : begins)
        for (const Index end : ends)
            if (end - first >= hidden_exchange_policy.min_samples) suspects.push_back({i, j, first, end});
    return suspects;
}

/// The suspect whose exchange reduces the residuals most, if any does enough.
std::optional<Suspect> worst_suspect(const std::vector<Eigen::Matrix3Xd>& tracks, const Eigen::VectorXd& sigma_m) {
    std::optional<Suspect> worst;
    double least = hidden_exchange_policy.max_ratio;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        for (std::size_t j = i + 1; j < tracks.size(); ++j) {
            const std::vector<Suspect> suspects = suspects_of(tracks, i, j);
            const std::optional<double> own_m = suspects.empty() ? std::nullopt : residual_m(tracks, i, j, sigma_m);
            const double noise_m = std::max(sigma_m(static_cast<Index>(i)), sigma_m(static_cast<Index>(j)));
            if (!own_m || *own_m < std::max(hidden_exchange_policy.min_residual_m,
                                            hidden_exchange_policy.min_deviations * noise_m))
                continue;
            for (const Suspect& suspect : suspects) {
                std::vector<Eigen::Matrix3Xd> exchanged = tracks;
                exchange_tracks(exchanged, suspect);
                const std::optional<double> other_m = residual_m(exchanged, i, j, sigma_m);
                if (other_m && *other_m < least * *own_m) worst = suspect, least = *other_m / *own_m;
            }
        }
    return worst;
}

}  // namespace

std::vector<Exchange> put_back_hidden_exchanges(std::vector<Eigen::Matrix3Xd>& tracks, const Eigen::VectorXd& sigma_m) {
    std::vector<Exchange> found;
    while (found.size() < hidden_exchange_policy.max_exchanges) {
        const std::optional<Suspect> worst = worst_suspect(tracks, sigma_m);
        if (!worst) break;
        exchange_tracks(tracks, *worst);
        found.push_back({{worst->i, worst->j}, worst->first, worst->end});
    }
    std::sort(found.begin(), found.end(), [](const Exchange& a, const Exchange& b) { return a.first < b.first; });
    return found;
}

}  // namespace myo::measurement
