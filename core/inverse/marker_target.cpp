#include "inverse/marker_target.hpp"

#include <cassert>
#include <cmath>

#include "measurement/rigid_motion.hpp"

namespace myo::inverse {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Eigen::Index MarkerTarget::coordinates() const {
    Eigen::Index count = 0;
    for (const Matrix3Xd& track : positions_m) count += track.array().isFinite().count();
    return count;
}

namespace {

/// Model times of the samples: stamps minus the time shift.
VectorXd model_times(const MarkerTarget& target) { return target.times_s.array() - target.placement.start_shift_s; }

/// Marker motion at the model times, before placement; displacements if the target is one.
measurement::MarkerTracks unplaced(const MarkerTarget& target, const sensitivity::NodeMotion& motion) {
    measurement::MarkerTracks tracks = measurement::observe(motion, target.markers, model_times(target));
    if (!target.from_start) return tracks;
    const std::vector<Matrix3Xd> origin = measurement::observe(motion, target.markers, VectorXd::Zero(1)).positions;
    for (std::size_t m = 0; m < origin.size(); ++m) tracks.positions[m].colwise() -= Vector3d(origin[m].col(0));
    return tracks;
}

/// R x (+ translation) - target; displacements are not translated.
Matrix3Xd residual_of(const MarkerTarget& target, const Eigen::Matrix3d& R, const Matrix3Xd& x, std::size_t marker) {
    Matrix3Xd residual = R * x - target.positions_m[marker];
    if (!target.from_start) residual.colwise() += target.placement.translation_m;
    return residual;
}

/// NaN replaced by zero, so that missing targets contribute nothing.
Matrix3Xd or_zero(const Matrix3Xd& residual) { return residual.array().isFinite().select(residual, 0.0); }

}  // namespace

std::vector<Matrix3Xd> shares_of_coordinates(const MarkerTarget& target) {
    std::vector<Matrix3Xd> shares;
    double sum = 0.0;
    for (std::size_t m = 0; m < target.positions_m.size(); ++m) {
        const Matrix3Xd& track = target.positions_m[m];
        shares.emplace_back(Matrix3Xd::Zero(3, track.cols()));
        for (Eigen::Index k = 0; k < track.size(); ++k) {
            if (!std::isfinite(track(k))) continue;
            shares[m](k) = target.weights.empty() ? 1.0 : target.weights[m](k);
            sum += shares[m](k);
        }
    }
    assert(sum > 0.0);
    for (Matrix3Xd& share : shares) share /= sum;
    return shares;
}

std::vector<Matrix3Xd> target_residuals(const MarkerTarget& target, const sensitivity::NodeMotion& motion) {
    const Eigen::Matrix3d R = measurement::small_rotation(target.placement.rotation_rad);
    std::vector<Matrix3Xd> residuals = unplaced(target, motion).positions;
    for (std::size_t m = 0; m < residuals.size(); ++m) residuals[m] = residual_of(target, R, residuals[m], m);
    return residuals;
}

SensitiveResiduals target_residuals(const MarkerTarget& target, const sensitivity::SensitiveTrace& run) {
    const Eigen::Matrix3d R = measurement::small_rotation(target.placement.rotation_rad);
    measurement::SensitiveTracks seen = measurement::observe(run, target.markers, model_times(target));
    const measurement::SensitiveTracks origin = measurement::observe(run, target.markers, VectorXd::Zero(1));
    const auto from_origin = [&](std::vector<Matrix3Xd>& tracks, const std::vector<Matrix3Xd>& starts) {
        for (std::size_t m = 0; target.from_start && m < tracks.size(); ++m)
            tracks[m].colwise() -= Vector3d(starts[m].col(0));
    };
    from_origin(seen.tracks.positions, origin.tracks.positions);
    SensitiveResiduals result;
    for (std::size_t m = 0; m < seen.tracks.positions.size(); ++m)
        result.residuals_m.push_back(residual_of(target, R, seen.tracks.positions[m], m));
    for (std::size_t p = 0; p < seen.tangents.size(); ++p) {
        from_origin(seen.tangents[p], origin.tangents[p]);
        for (Matrix3Xd& track : seen.tangents[p]) track = (R * track).eval();
    }
    result.tangents = std::move(seen.tangents);
    return result;
}

sensitivity::MotionLoss mean_square(const MarkerTarget& target, const sensitivity::NodeMotion& motion) {
    const std::vector<Matrix3Xd> shares = shares_of_coordinates(target);
    // Adjoint of the placed residual: 2 R' (share residual) on the marker; R' is the rotation by the negative vector.
    const Eigen::Matrix3d back_turned = measurement::small_rotation(-target.placement.rotation_rad);
    std::vector<Matrix3Xd> pulls = target_residuals(target, motion);
    double sum = 0.0;
    for (std::size_t m = 0; m < pulls.size(); ++m) {
        const Matrix3Xd residual = or_zero(pulls[m]), shared = residual.cwiseProduct(shares[m]);
        sum += residual.cwiseProduct(shared).sum();
        pulls[m] = 2.0 * back_turned * shared;
    }
    sensitivity::MotionLoss loss = measurement::pull_on_nodes(motion, target.markers, model_times(target), pulls);
    // Displacements: each sample also depends on the marker at t = 0, with the opposite sign.
    if (target.from_start) {
        std::vector<Matrix3Xd> back;
        for (const Matrix3Xd& pull : pulls) back.emplace_back(-pull.rowwise().sum());
        const sensitivity::MotionLoss of_origin = measurement::pull_on_nodes(motion, target.markers, VectorXd::Zero(1),
                                                                             back);
        loss.d_positions.front() += of_origin.d_positions.front();
    }
    loss.value = sum;
    return loss;
}

MarkerPlacement mean_square_by_placement(const MarkerTarget& target, const sensitivity::NodeMotion& motion) {
    const std::vector<Matrix3Xd> shares = shares_of_coordinates(target);
    const Vector3d omega = target.placement.rotation_rad;
    const Eigen::Matrix3d R = measurement::small_rotation(omega);
    const measurement::MarkerTracks tracks = unplaced(target, motion);
    MarkerPlacement gradient;
    for (std::size_t m = 0; m < tracks.positions.size(); ++m) {
        const Matrix3Xd& x = tracks.positions[m];
        const Matrix3Xd pull = 2.0 * shares[m].cwiseProduct(or_zero(residual_of(target, R, x, m)));
        if (!target.from_start) gradient.translation_m += pull.rowwise().sum();
        for (Eigen::Index t = 0; t < x.cols(); ++t)
            gradient.rotation_rad += measurement::d_rotated_d_omega(omega, x.col(t)).transpose() * pull.col(t);
        gradient.start_shift_s -= pull.cwiseProduct(R * tracks.velocities[m]).sum();
    }
    return gradient;
}

sensitivity::LossOfMotion mean_square_of(const MarkerTarget& target) {
    return {target.markers.nodes,
            [&target](const sensitivity::NodeMotion& motion) { return mean_square(target, motion); }};
}

}  // namespace myo::inverse
