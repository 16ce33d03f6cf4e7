#include "inverse/marker_target.hpp"

#include <cassert>

namespace myo {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

Eigen::Index MarkerTarget::coordinates() const {
    Eigen::Index count = 0;
    for (const Matrix3Xd& track : positions_m) count += track.array().isFinite().count();
    return count;
}

std::vector<Matrix3Xd> target_residuals(const MarkerTarget& target, const NodeMotion& motion) {
    std::vector<Matrix3Xd> residuals = observe(motion, target.markers, target.times_s).positions;
    const std::vector<Matrix3Xd> origin = observe(motion, target.markers, VectorXd::Zero(1)).positions;
    for (std::size_t m = 0; m < residuals.size(); ++m) {
        residuals[m] -= target.positions_m[m];
        if (target.from_start) residuals[m].colwise() -= Eigen::Vector3d(origin[m].col(0));
    }
    return residuals;
}

MotionLoss mean_square(const MarkerTarget& target, const NodeMotion& motion) {
    const auto count = static_cast<double>(target.coordinates());
    assert(count > 0.0);
    std::vector<Matrix3Xd> pulls = target_residuals(target, motion);
    double sum = 0.0;
    for (Matrix3Xd& residual : pulls) {
        residual = residual.array().isFinite().select(residual, 0.0);
        sum += residual.squaredNorm();
        residual *= 2.0 / count;
    }
    MotionLoss loss = pull_on_nodes(motion, target.markers, target.times_s, pulls);
    if (target.from_start) {
        std::vector<Matrix3Xd> back;
        for (const Matrix3Xd& pull : pulls) back.emplace_back(-pull.rowwise().sum());
        const MotionLoss of_origin = pull_on_nodes(motion, target.markers, VectorXd::Zero(1), back);
        loss.d_positions.front() += of_origin.d_positions.front();
    }
    loss.value = sum / count;
    return loss;
}

LossOfMotion mean_square_of(const MarkerTarget& target) {
    return {target.markers.nodes, [&target](const NodeMotion& motion) { return mean_square(target, motion); }};
}

}  // namespace myo
