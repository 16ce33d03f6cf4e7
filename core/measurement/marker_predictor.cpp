#include "measurement/marker_predictor.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

#include "measurement/gaps.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct MarkerPredictorPolicy {
    double min_visible = 0.5;       // share of the marker's samples in which another one must be visible
    std::size_t min_others = 2;     // a single marker cannot tell a motion of its own from one of the body
    Index max_modes = 4;            // principal motions; a soft body swings in one to three
    double min_mode = 3.0;          // standard deviations of the noise that a motion must exceed
    Index samples_per_mode = 10;    // so that the fit is overdetermined
    double min_seen = 0.2;          // least share of a motion that the visible markers must show
    double kept_share = 0.75;       // of the samples in the trimmed fit
    int trimming_steps = 4;         // the trimmed set is stable after two or three
    std::size_t max_fitted = 2000;  // samples of a fit, evenly chosen from longer recordings
};
constexpr MarkerPredictorPolicy marker_predictor_policy;

}  // namespace

MarkerPredictor::MarkerPredictor(const std::vector<Eigen::Matrix3Xd>& tracks, std::size_t marker, double sigma_m,
                                 const std::vector<std::size_t>& without)
    : track_(tracks[marker]) {
    std::vector<Index> seen;
    for (Index t = 0; t < track_.cols(); ++t)
        if (is_seen(track_, t)) seen.push_back(t);
    for (std::size_t k = 0; k < tracks.size(); ++k) {
        if (k == marker || std::find(without.begin(), without.end(), k) != without.end()) continue;
        const auto both = std::count_if(seen.begin(), seen.end(), [&](Index t) { return is_seen(tracks[k], t); });
        if (static_cast<double>(both) >= marker_predictor_policy.min_visible * static_cast<double>(seen.size()))
            others_.push_back(k);
    }
    if (seen.empty() || others_.size() < marker_predictor_policy.min_others || !set_motions(tracks, sigma_m)) return;
    std::vector<double> modes;
    for (const Index t : seen) add_sample(tracks, t, modes);
    if (samples_.empty()) return;
    const auto count = static_cast<Index>(samples_.size());
    modes_ = Eigen::Map<const MatrixXd>(modes.data(), motions_.cols() + 1, count);
    places_ = track_(Eigen::all, samples_);
}

/// Principal motions of the samples in which all others are visible; false if these are too few.
bool MarkerPredictor::set_motions(const std::vector<Eigen::Matrix3Xd>& tracks, double sigma_m) {
    std::vector<Index> complete;
    for (Index t = 0; t < track_.cols(); ++t)
        if (std::all_of(others_.begin(), others_.end(), [&](std::size_t k) { return is_seen(tracks[k], t); }))
            complete.push_back(t);
    const auto count = static_cast<Index>(complete.size()), rows = static_cast<Index>(3 * others_.size());
    if (count < marker_predictor_policy.samples_per_mode) return false;
    MatrixXd motion(rows, count);
    for (std::size_t k = 0; k < others_.size(); ++k)
        motion.middleRows(static_cast<Index>(3 * k), 3) = tracks[others_[k]](Eigen::all, complete);
    mean_m_ = motion.rowwise().mean();
    motion.colwise() -= mean_m_;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> found(motion * motion.transpose() / static_cast<double>(count));
    const double least = marker_predictor_policy.min_mode * marker_predictor_policy.min_mode * sigma_m * sigma_m;
    const Index most = std::min(
        {marker_predictor_policy.max_modes, rows, count / marker_predictor_policy.samples_per_mode});
    Index number = 0;
    // Ascending eigenvalues: the largest motions come last.
    while (number < most &&
           found.eigenvalues()(rows - 1 - number) > std::max(least, std::numeric_limits<double>::min()))
        ++number;
    motions_ = found.eigenvectors().rightCols(number);
    amplitude_ = found.eigenvalues().tail(number).cwiseSqrt();
    return true;
}

/// Appends a sample if the visible markers show enough of every motion.
void MarkerPredictor::add_sample(const std::vector<Eigen::Matrix3Xd>& tracks, Index t, std::vector<double>& modes) {
    std::vector<Index> rows;
    VectorXd motion = VectorXd::Zero(mean_m_.size());
    for (std::size_t k = 0; k < others_.size(); ++k) {
        if (!is_seen(tracks[others_[k]], t)) continue;
        for (Index axis = 0; axis < 3; ++axis) {
            rows.push_back(static_cast<Index>(3 * k) + axis);
            motion(rows.back()) = tracks[others_[k]](axis, t) - mean_m_(rows.back());
        }
    }
    if (rows.size() < 3 * marker_predictor_policy.min_others) return;
    const MatrixXd seen = motions_(rows, Eigen::all);
    const VectorXd visible = motion(rows);
    VectorXd along = VectorXd::Zero(motions_.cols());
    if (along.size() > 0) {
        const Eigen::SelfAdjointEigenSolver<MatrixXd> share(seen.transpose() * seen);
        if (share.eigenvalues()(0) < marker_predictor_policy.min_seen) return;
        along = share.eigenvectors() * share.eigenvalues().cwiseInverse().asDiagonal() *
                share.eigenvectors().transpose() * (seen.transpose() * visible);
    }
    const VectorXd rest = visible - seen * along;
    double unexplained_m = 0.0;
    for (Index row = 0; row < rest.size(); row += 3)
        unexplained_m = std::max(unexplained_m, rest.segment(row, 3).norm());
    samples_.push_back(t);
    unexplained_m_.push_back(unexplained_m);
    for (Index k = 0; k < along.size(); ++k) modes.push_back(along(k) / amplitude_(k));
    modes.push_back(1.0);
}

std::optional<MarkerPredictor::Fit> MarkerPredictor::fit(std::size_t first, std::size_t end, bool trimmed) const {
    std::vector<Index> all;
    const std::size_t stride = 1 + samples_.size() / marker_predictor_policy.max_fitted;
    for (std::size_t i = 0; i < samples_.size(); i += stride)
        if (i < first || i >= end) all.push_back(static_cast<Index>(i));
    if (static_cast<Index>(all.size()) < 3 * modes_.rows()) return std::nullopt;
    std::vector<Index> kept = all;
    Fit found;
    for (int step = 0;; ++step) {
        const MatrixXd A = modes_(Eigen::all, kept), b = places_(Eigen::all, kept);
        const Eigen::LDLT<MatrixXd> factor(A * A.transpose());
        if (factor.info() != Eigen::Success) return std::nullopt;
        found.map = factor.solve(A * b.transpose());
        found.covariance = factor.solve(MatrixXd::Identity(A.rows(), A.rows()));
        const VectorXd distances = (b - found.map.transpose() * A).colwise().norm();
        found.largest_m = distances.maxCoeff();
        found.rms_m = std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()));
        if (!trimmed || step == marker_predictor_policy.trimming_steps) return found;
        std::vector<std::pair<double, Index>> order;
        for (const Index i : all) order.emplace_back(distance(found, static_cast<std::size_t>(i)), i);
        std::sort(order.begin(), order.end());
        const auto count = static_cast<std::size_t>(
            marker_predictor_policy.kept_share * static_cast<double>(order.size()) + 1.0);
        kept.clear();
        for (std::size_t i = 0; i < std::min(count, order.size()); ++i) kept.push_back(order[i].second);
    }
}

Eigen::Vector3d MarkerPredictor::residual(const Fit& fit, std::size_t place) const {
    const auto i = static_cast<Index>(place);
    return places_.col(i) - fit.map.transpose() * modes_.col(i);
}

double MarkerPredictor::widening(const Fit& fit, std::size_t place) const {
    const auto i = static_cast<Index>(place);
    return std::sqrt(1.0 + std::max(0.0, modes_.col(i).dot(fit.covariance * modes_.col(i))));
}

}  // namespace myo::measurement
