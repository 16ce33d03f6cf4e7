#include "model/point_pull.hpp"

#include <algorithm>
#include <utility>

#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// See point_pull().
class PointPull : public ForceElement {
public:
    PointPull(LoadedFace nodes, VectorXd shares, const Vector3d& place, double stiffness)
        : at_(std::move(nodes)), shares_(std::move(shares)), place_(place), stiffness_(stiffness) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const Vector3d arm = arm_at(at);
        out.energy += 0.5 * stiffness_ * arm.squaredNorm();
        add_force(stiffness_ * arm, out.gradient);
        if (kind == HessianKind::none) return;
        add_face_hessian(body, at_, out.hessian, [&](std::size_t a, std::size_t b) {
            return Matrix3d(stiffness_ * shares_(static_cast<Eigen::Index>(a)) * shares_(static_cast<Eigen::Index>(b)) *
                            Matrix3d::Identity());
        });
    }

    std::vector<ForceParameter> parameters() const override {
        return {{"stiffness_N_m", stiffness_, std::max(stiffness_, 1.0)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<PointPull>(at_, shares_, place_, values(0));
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        add_force(change(0) * arm_at(at), gradient);
    }

private:
    /// From the place to the point, in the current configuration.
    Vector3d arm_at(const ForceState& at) const { return at.x(Eigen::all, at_.nodes) * shares_ - place_; }
    void add_force(const Vector3d& force, Matrix3Xd& gradient) const {
        for (std::size_t a = 0; a < at_.nodes.size(); ++a)
            gradient.col(at_.nodes[a]) += shares_(static_cast<Eigen::Index>(a)) * force;
    }

    LoadedFace at_;
    VectorXd shares_;
    Vector3d place_;
    double stiffness_;
};

}  // namespace

ForceElementPointer point_pull(const Body& body, int cell, const std::vector<int>& nodes, const VectorXd& shares,
                               const Vector3d& place_m, double stiffness_N_m) {
    return std::make_shared<PointPull>(loaded_nodes(body, cell, nodes), shares, place_m, stiffness_N_m);
}

}  // namespace myo::model
