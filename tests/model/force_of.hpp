#pragma once

#include <Eigen/Core>

#include "model/force_element.hpp"

namespace myo::test {

/// Potential, gradient and, if asked for, Hessian of one force element alone.
inline model::InternalEnergy force_of(const model::ForceElement& element, const model::Body& body,
                                      const model::ForceState& at, model::HessianKind kind = model::HessianKind::none) {
    model::InternalEnergy out;
    out.gradient = Eigen::Matrix3Xd::Zero(3, body.node_count());
    if (kind != model::HessianKind::none) out.hessian = body.pattern.zero;
    element.add(body, at, kind, out);
    return out;
}

/// Force on the whole body [N].
inline Eigen::Vector3d resultant(const model::InternalEnergy& out) { return -out.gradient.rowwise().sum(); }

/// Stiffness of a free body against a motion of all its nodes along a direction [N/m].
inline double stiffness_along(const model::InternalEnergy& out, const model::Body& body,
                              const Eigen::Vector3d& direction) {
    const Eigen::VectorXd d = model::gather(body.pattern, direction.replicate(1, body.node_count()));
    return d.dot(Eigen::VectorXd(out.hessian.selfadjointView<Eigen::Lower>() * d));
}

/// All nodes at rest, moved by one vector, 3 x n [m].
inline Eigen::Matrix3Xd moved_by(const model::Body& body, const Eigen::Vector3d& by) {
    return body.mesh.nodes.colwise() + by;
}

}  // namespace myo::test
