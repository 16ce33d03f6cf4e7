#include "model/point_stop.hpp"

#include <algorithm>
#include <cassert>

#include "model/loaded_face.hpp"
#include "model/one_sided.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// See point_stop().
class PointStop : public ForceElement {
public:
    PointStop(LoadedFace nodes, VectorXd shares, const Vector3d& normal, double gap, double stiffness, double onset)
        : at_(std::move(nodes)),
          shares_(std::move(shares)),
          normal_(normal),
          gap_(gap),
          stiffness_(stiffness),
          onset_(onset) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const OneSided pushed = compression(body, at);
        out.energy += stiffness_ * pushed.value;
        add_force(-stiffness_ * pushed.slope, out.gradient);
        if (kind == HessianKind::none || pushed.second == 0.0) return;
        const Matrix3d H = stiffness_ * pushed.second * normal_ * normal_.transpose();
        add_face_hessian(body, at_, out.hessian, [&](std::size_t a, std::size_t b) {
            return Matrix3d(shares_(static_cast<Eigen::Index>(a)) * shares_(static_cast<Eigen::Index>(b)) * H);
        });
    }

    std::vector<ForceParameter> parameters() const override {
        return {{"stiffness_N_m", stiffness_, std::max(stiffness_, 1.0)}, {"gap_m", gap_, std::max(gap_, 1e-3)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<PointStop>(at_, shares_, normal_, values(1), values(0), onset_);
    }
    void add_tangent(const Body& body, const ForceState& at, const VectorXd& change,
                     Matrix3Xd& gradient) const override {
        const OneSided pushed = compression(body, at);
        // A wider gap reduces the compression.
        add_force(-change(0) * pushed.slope + stiffness_ * pushed.second * change(1), gradient);
    }

private:
    /// Smoothed compression of the stop.
    OneSided compression(const Body& body, const ForceState& at) const {
        const Vector3d moved = (at.x(Eigen::all, at_.nodes) - body.mesh.nodes(Eigen::all, at_.nodes)) * shares_;
        // Centred on the gap: half of the onset lies before it.
        return one_sided(-normal_.dot(moved) - gap_ + 0.5 * onset_, onset_);
    }
    /// Adds a force along the normal [N] at the point to the nodes that carry it.
    void add_force(double along_normal, Matrix3Xd& gradient) const {
        for (std::size_t a = 0; a < at_.nodes.size(); ++a)
            gradient.col(at_.nodes[a]) += shares_(static_cast<Eigen::Index>(a)) * along_normal * normal_;
    }

    LoadedFace at_;
    VectorXd shares_;
    Vector3d normal_;
    double gap_, stiffness_, onset_;
};

}  // namespace

ForceElementPointer point_stop(const Body& body, int cell, const std::vector<int>& nodes, const VectorXd& shares,
                               const Vector3d& normal, double gap_m, double stiffness_N_m, double onset_m) {
    assert(normal.norm() > 0.0 && onset_m > 0.0);
    return std::make_shared<PointStop>(loaded_nodes(body, cell, nodes), shares, normal.normalized(), gap_m,
                                       stiffness_N_m, onset_m);
}

}  // namespace myo::model
