#include "dynamics/undeformed.hpp"

#include "material/polar.hpp"

namespace myo::dynamics {

Eigen::Matrix3Xd undeformed_near(const model::Body& body, const Eigen::Matrix3Xd& x) {
    const Eigen::Matrix3Xd& X = body.mesh.nodes;
    if (body.pattern.free_count < body.node_count() || !body.guided.empty()) return X;
    // Best rigid motion: centroids and the rotation of the polar decomposition of the correlation matrix.
    const Eigen::Vector3d rest = X.rowwise().mean(), now = x.rowwise().mean();
    const Eigen::Matrix3d R = material::polar_rotation(
        Eigen::Matrix3d((x.colwise() - now) * (X.colwise() - rest).transpose()));
    if (!R.allFinite() || !now.allFinite()) return X;
    return (R * (X.colwise() - rest)).colwise() + now;
}

}  // namespace myo::dynamics
