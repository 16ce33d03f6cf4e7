#include "model/tied_spring.hpp"

#include <algorithm>
#include <cassert>

#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// See tied_spring().
class TiedSpring : public ForceElement {
public:
    TiedSpring(LoadedFace nodes, VectorXd shares, const Vector3d& anchor, double rest_length, double stiffness)
        : at_(std::move(nodes)),
          shares_(std::move(shares)),
          anchor_(anchor),
          rest_length_(rest_length),
          stiffness_(stiffness) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        // Vector from the anchor to the attachment point in the current configuration.
        const Vector3d arm = at.x(Eigen::all, at_.nodes) * shares_ - anchor_;
        const double length = arm.norm(), stretch = length - rest_length_;
        const Vector3d d = arm / length;
        out.energy += 0.5 * stiffness_ * stretch * stretch;
        add_force(stiffness_ * stretch * d, out.gradient);
        if (kind == HessianKind::none) return;
        double across = stretch / length;  // transverse (geometric) stiffness; negative if the spring is compressed
        // Only the transverse stiffness can be negative, so clipping it gives the positive part.
        if (kind != HessianKind::exact) across = std::max(0.0, across);
        const Matrix3d H = stiffness_ * (d * d.transpose() + across * (Matrix3d::Identity() - d * d.transpose()));
        add_face_hessian(body, at_, out.hessian, [&](std::size_t a, std::size_t b) {
            return Matrix3d(shares_(static_cast<Eigen::Index>(a)) * shares_(static_cast<Eigen::Index>(b)) * H);
        });
    }

    std::vector<ForceParameter> parameters() const override {
        return {{"stiffness_N_m", stiffness_, std::max(stiffness_, 1.0)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<TiedSpring>(at_, shares_, anchor_, rest_length_, values(0));
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        const Vector3d arm = at.x(Eigen::all, at_.nodes) * shares_ - anchor_;
        add_force(change(0) * (arm.norm() - rest_length_) * arm.normalized(), gradient);
    }

private:
    /// Adds a force at the point [N] to the nodes that carry it.
    void add_force(const Vector3d& force, Matrix3Xd& gradient) const {
        for (std::size_t a = 0; a < at_.nodes.size(); ++a)
            gradient.col(at_.nodes[a]) += shares_(static_cast<Eigen::Index>(a)) * force;
    }

    LoadedFace at_;
    VectorXd shares_;
    Vector3d anchor_;
    double rest_length_, stiffness_;
};

}  // namespace

ForceElementPointer tied_spring(const Body& body, int cell, const std::vector<int>& nodes, const VectorXd& shares,
                                const Vector3d& anchor_m, double stiffness_N_m) {
    // Stress-free length: distance in the rest configuration.
    const double length = (body.mesh.nodes(Eigen::all, nodes) * shares - anchor_m).norm();
    assert(length > 0.0);
    return std::make_shared<TiedSpring>(loaded_nodes(body, cell, nodes), shares, anchor_m, length, stiffness_N_m);
}

}  // namespace myo::model
