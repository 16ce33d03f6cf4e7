#include "measurement/false_stretches.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "measurement/gaps.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Thresholds of find_false_stretches().
struct FalseStretchPolicy {
    double min_deviations = 20.0;   // of the noise, as for excursions
    double least_offset_m = 1e-3;   // cameras do not take one marker for another that is nearer
    double unexplained = 5.0;       // of the others' distance from the principal motions: what the model misses there
    double min_ratio = 6.0;         // over the fitted samples, as for excursions
    double return_share = 0.5;      // of the threshold within which the samples on both sides must be
    std::size_t side_samples = 5;   // examined on each side ...
    std::size_t min_side = 3;       // ... and needed there
    double min_visible = 0.8;       // share of the marker's samples in which another one must be visible to predict it
    std::size_t min_others = 2;     // a single marker cannot tell a motion of its own from one of the body
    Index max_modes = 4;            // principal motions; a soft body swings in one to three
    double min_mode = 3.0;          // standard deviations of the noise that a mode must exceed
    Index samples_per_mode = 10;    // so that the fit is overdetermined
    double kept_share = 0.75;       // of the samples in the trimmed fit
    int trimming_steps = 4;         // the trimmed set is stable after two or three
    double step_ratio = 3.0;        // of a step over the median step of its track for a break
    std::size_t max_breaks = 12;    // with the largest jumps; bounds the number of candidates
    std::size_t max_fitted = 2000;  // samples of a fit, evenly chosen from longer recordings
    std::size_t max_stretches = 8;  // of one recording; more is no isolated fault
};
constexpr FalseStretchPolicy false_stretch_policy;

/// A place where a track may change over to something else: between the visible samples `before` and `after`.
struct TrackBreak {
    std::size_t after = 0;  // position in the list of visible samples
    bool is_gap = false;
    double jump_m = 0.0;  // of the distance from a first prediction
};

/// The trimmed fit of a marker's positions to the principal motions of others.
struct TrackPrediction {
    MatrixXd map;            // (modes + 1) x 3
    MatrixXd covariance;     // inverse of the normal matrix, for the leverage
    double largest_m = 0.0;  // distance among the kept samples
};

/// A marker with those that predict it.
class TrackPredictor {
public:
    TrackPredictor(const std::vector<Eigen::Matrix3Xd>& tracks, std::size_t marker, double sigma_m)
        : track_(tracks[marker]), sigma_m_(sigma_m) {
        std::vector<Index> seen;
        for (Index t = 0; t < track_.cols(); ++t)
            if (is_seen(track_, t)) seen.push_back(t);
        std::vector<std::size_t> others;
        for (std::size_t k = 0; k < tracks.size(); ++k) {
            if (k == marker) continue;
            const auto both = std::count_if(seen.begin(), seen.end(), [&](Index t) { return is_seen(tracks[k], t); });
            if (static_cast<double>(both) >= false_stretch_policy.min_visible * static_cast<double>(seen.size()))
                others.push_back(k);
        }
        if (others.size() < false_stretch_policy.min_others) return;
        for (const Index t : seen)
            if (std::all_of(others.begin(), others.end(), [&](std::size_t k) { return is_seen(tracks[k], t); }))
                samples_.push_back(t);
        if (samples_.size() > 2 * false_stretch_policy.min_side) set_modes(tracks, others);
    }

    bool is_usable() const { return modes_.rows() > 0; }
    const std::vector<Index>& samples() const { return samples_; }

    /// Fit to all usable samples outside [first, end); empty if these are too few.
    std::optional<TrackPrediction> fit(std::size_t first, std::size_t end) const {
        std::vector<Index> kept;
        const std::size_t stride = 1 + samples_.size() / false_stretch_policy.max_fitted;
        for (std::size_t i = 0; i < samples_.size(); i += stride)
            if (i < first || i >= end) kept.push_back(static_cast<Index>(i));
        const std::vector<Index> all = kept;
        if (static_cast<Index>(all.size()) < 3 * modes_.rows()) return std::nullopt;
        TrackPrediction found;
        for (int step = 0; step <= false_stretch_policy.trimming_steps; ++step) {
            const MatrixXd A = modes_(Eigen::all, kept), b = places_(Eigen::all, kept);
            const MatrixXd normal = A * A.transpose();
            const Eigen::LDLT<MatrixXd> factor(normal);
            if (factor.info() != Eigen::Success) return std::nullopt;
            found.map = factor.solve(A * b.transpose());
            found.covariance = factor.solve(MatrixXd::Identity(normal.rows(), normal.cols()));
            found.largest_m = 0.0;
            for (const Index i : kept) found.largest_m = std::max(found.largest_m, distance(found, i));
            if (step == false_stretch_policy.trimming_steps) break;
            std::vector<std::pair<double, Index>> order;
            for (const Index i : all) order.emplace_back(distance(found, i), i);
            std::sort(order.begin(), order.end());
            kept.clear();
            const auto count = static_cast<std::size_t>(
                false_stretch_policy.kept_share * static_cast<double>(order.size()) + 1.0);
            for (std::size_t i = 0; i < std::min(count, order.size()); ++i) kept.push_back(order[i].second);
        }
        return found;
    }

    /// Distance of a sample from its prediction [m].
    double distance(const TrackPrediction& by, Index i) const {
        return (places_.col(i) - by.map.transpose() * modes_.col(i)).norm();
    }

    /// Distance beyond which a sample is false [m].
    double threshold(const TrackPrediction& by, Index i) const {
        const double leverage = modes_.col(i).dot(by.covariance * modes_.col(i));
        return std::max({false_stretch_policy.least_offset_m, false_stretch_policy.min_deviations * sigma_m_,
                         false_stretch_policy.min_ratio * by.largest_m}) *
               std::sqrt(1.0 + std::max(0.0, leverage));
    }

    /// What the principal motions leave unexplained in the other markers, and may leave in this one [m].
    double unexplained(Index i) const { return false_stretch_policy.unexplained * unexplained_m_(i); }

private:
    /// Principal motions of the others above the noise, and a row of ones.
    void set_modes(const std::vector<Eigen::Matrix3Xd>& tracks, const std::vector<std::size_t>& others) {
        const auto count = static_cast<Index>(samples_.size()), rows = static_cast<Index>(3 * others.size());
        MatrixXd motion(rows, count);
        for (std::size_t k = 0; k < others.size(); ++k)
            motion.middleRows(static_cast<Index>(3 * k), 3) = tracks[others[k]](Eigen::all, samples_);
        motion.colwise() -= VectorXd(motion.rowwise().mean());
        const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(motion * motion.transpose() / static_cast<double>(count));
        const double least = false_stretch_policy.min_mode * false_stretch_policy.min_mode * sigma_m_ * sigma_m_;
        Index number = 0;
        // Ascending eigenvalues: the largest motions come last.
        while (number <
                   std::min({false_stretch_policy.max_modes, rows, count / false_stretch_policy.samples_per_mode}) &&
               modes.eigenvalues()(rows - 1 - number) > std::max(least, std::numeric_limits<double>::min()))
            ++number;
        modes_.resize(number + 1, count);
        modes_.topRows(number) = modes.eigenvectors().rightCols(number).transpose() * motion;
        modes_.row(number).setOnes();
        const MatrixXd rest = motion - modes.eigenvectors().rightCols(number) * modes_.topRows(number);
        unexplained_m_ = VectorXd::Zero(count);
        for (Index k = 0; k < rows; k += 3)
            unexplained_m_ = unexplained_m_.cwiseMax(rest.middleRows(k, 3).colwise().norm().transpose());
        // Unit variance keeps the normal matrix well conditioned.
        for (Index k = 0; k < number; ++k) modes_.row(k) /= std::sqrt(modes.eigenvalues()(rows - number + k));
        places_ = track_(Eigen::all, samples_);
    }

    const Eigen::Matrix3Xd& track_;
    double sigma_m_;
    std::vector<Index> samples_;  // where the marker and all that predict it are visible
    MatrixXd modes_;              // (modes + 1) x samples
    VectorXd unexplained_m_;      // per sample, largest distance of another marker from the principal motions [m]
    MatrixXd places_;             // 3 x samples [m]
};

/// Breaks of the track, those with the largest jumps.
std::vector<TrackBreak> breaks_of(const TrackPredictor& predictor, const Eigen::Matrix3Xd& track, double sigma_m) {
    const std::optional<TrackPrediction> first = predictor.fit(0, 0);
    const std::vector<Index>& samples = predictor.samples();
    if (!first) return {};
    std::vector<double> steps_m;
    for (std::size_t i = 1; i < samples.size(); ++i)
        steps_m.push_back((track.col(samples[i]) - track.col(samples[i - 1])).norm());
    std::vector<double> sorted = steps_m;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double usual_m = sorted[sorted.size() / 2];
    std::vector<TrackBreak> breaks;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        bool is_gap = false;
        for (Index t = samples[i - 1] + 1; t < samples[i]; ++t) is_gap = is_gap || !is_seen(track, t);
        if (!is_gap && !(steps_m[i - 1] > false_stretch_policy.step_ratio * usual_m)) continue;
        const auto index = static_cast<Index>(i);
        const double jump_m = std::abs(predictor.distance(*first, index) - predictor.distance(*first, index - 1));
        if (jump_m > false_stretch_policy.min_deviations * sigma_m) breaks.push_back({i, is_gap, jump_m});
    }
    std::sort(breaks.begin(), breaks.end(),
              [](const TrackBreak& a, const TrackBreak& b) { return a.jump_m > b.jump_m; });
    if (breaks.size() > false_stretch_policy.max_breaks) breaks.resize(false_stretch_policy.max_breaks);
    std::sort(breaks.begin(), breaks.end(), [](const TrackBreak& a, const TrackBreak& b) { return a.after < b.after; });
    return breaks;
}

/// Least distance of the samples [first, end) over the threshold; 0 if the stretch is not false.
double falsehood(const TrackPredictor& predictor, std::size_t first, std::size_t end, double& offset_m) {
    const std::size_t count = predictor.samples().size();
    if (first < false_stretch_policy.min_side || end + false_stretch_policy.min_side > count ||
        2 * (end - first) > count)
        return 0.0;
    const std::optional<TrackPrediction> fit = predictor.fit(first, end);
    if (!fit) return 0.0;
    const auto over = [&](std::size_t i) {
        const auto index = static_cast<Index>(i);
        return predictor.distance(*fit, index) / predictor.threshold(*fit, index);
    };
    for (std::size_t k = 1; k <= false_stretch_policy.side_samples; ++k) {
        if (first >= k && over(first - k) > false_stretch_policy.return_share) return 0.0;
        if (end + k <= count && over(end + k - 1) > false_stretch_policy.return_share) return 0.0;
    }
    double least = std::numeric_limits<double>::infinity();
    offset_m = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        const auto index = static_cast<Index>(i);
        least = std::min(
            least, predictor.distance(*fit, index) / (predictor.threshold(*fit, index) + predictor.unexplained(index)));
        offset_m = std::max(offset_m, predictor.distance(*fit, static_cast<Index>(i)));
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
    const TrackPredictor predictor(tracks, marker, sigma_m);
    if (!predictor.is_usable()) return std::nullopt;
    const std::vector<TrackBreak> breaks = breaks_of(predictor, track, sigma_m);
    const std::vector<Index>& samples = predictor.samples();
    std::optional<std::pair<double, FalseStretch>> worst;
    for (std::size_t a = 0; a < breaks.size(); ++a)
        for (std::size_t b = a + 1; b < breaks.size(); ++b) {
            if (!breaks[a].is_gap && !breaks[b].is_gap) continue;
            double offset_m = 0.0;
            const double certainty = falsehood(predictor, breaks[a].after, breaks[b].after, offset_m);
            if (!(certainty > (worst ? worst->first : 0.0))) continue;
            worst = {certainty, {marker, samples[breaks[a].after], samples[breaks[b].after - 1] + 1, offset_m}};
        }
    return worst;
}

}  // namespace

std::vector<FalseStretch> find_false_stretches(const std::vector<Eigen::Matrix3Xd>& tracks, const VectorXd& sigma_m) {
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
