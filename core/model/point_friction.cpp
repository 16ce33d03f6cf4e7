#include "model/point_friction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// See point_friction().
class PointFriction : public ForceElement {
public:
    PointFriction(LoadedFace nodes, VectorXd shares, const Matrix3d& across, double force_N, double v0_m_s)
        : at_(std::move(nodes)), shares_(std::move(shares)), across_(across), force_N_(force_N), v0_m_s_(v0_m_s) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        if (!acts(at)) return;
        const Vector3d v = sliding_velocity(*at.v);
        const double factor = at.velocity_factor_1_s, speed = regularised(v);
        // The dissipation potential over dv/dx is a potential of the position at the end of the step.
        if (factor > 0.0) out.energy += force_N_ / factor * speed;
        add_force(force_N_ / speed * v, out.gradient);
        if (kind == HessianKind::none || factor == 0.0) return;
        const Matrix3d H = factor * by_velocity(v);
        add_face_hessian(body, at_, out.hessian, [&](std::size_t a, std::size_t b) {
            return Matrix3d(shares_(static_cast<Eigen::Index>(a)) * shares_(static_cast<Eigen::Index>(b)) * H);
        });
    }

    bool depends_on_velocity() const override { return true; }
    void add_velocity_tangent(const Body&, const ForceState& at, const Matrix3Xd& dv,
                              Matrix3Xd& gradient) const override {
        if (acts(at)) add_force(by_velocity(sliding_velocity(*at.v)) * sliding_velocity(dv), gradient);
    }

    std::vector<ForceParameter> parameters() const override {
        return {{"friction_force_N", force_N_, std::max(force_N_, 1e-3)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<PointFriction>(at_, shares_, across_, values(0), v0_m_s_);
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        if (!acts(at)) return;
        const Vector3d v = sliding_velocity(*at.v);
        add_force(change(0) / regularised(v) * v, gradient);
    }

    std::vector<double> jumps() const override { return {0.0}; }
    bool steady(double from_s, double to_s) const override { return (from_s < 0.0) == (to_s < 0.0); }

private:
    /// Friction begins at t = 0, so that the body rests without it before.
    static bool acts(const ForceState& at) {
        return at.v != nullptr && (at.time_s > 0.0 || (at.time_s == 0.0 && !at.before_jump));
    }
    /// Velocity of the point across the normal [m/s]; linear in the nodal velocities, hence also that of a variation.
    Vector3d sliding_velocity(const Matrix3Xd& v) const { return across_ * (v(Eigen::all, at_.nodes) * shares_); }
    /// Speed that does not vanish at rest, sqrt(|v|^2 + v0^2) [m/s].
    double regularised(const Vector3d& v) const { return std::sqrt(v.squaredNorm() + v0_m_s_ * v0_m_s_); }
    /// Derivative of the gradient by the point's velocity; positive semi-definite.
    Matrix3d by_velocity(const Vector3d& v) const {
        const double speed = regularised(v);
        return force_N_ / speed * (across_ - v * v.transpose() / (speed * speed));
    }
    void add_force(const Vector3d& force, Matrix3Xd& gradient) const {
        for (std::size_t a = 0; a < at_.nodes.size(); ++a)
            gradient.col(at_.nodes[a]) += shares_(static_cast<Eigen::Index>(a)) * force;
    }

    LoadedFace at_;
    VectorXd shares_;
    Matrix3d across_;  // projects a velocity on the plane across the normal
    double force_N_, v0_m_s_;
};

}  // namespace

ForceElementPointer point_friction(const Body& body, int cell, const std::vector<int>& nodes, const VectorXd& shares,
                                   const std::optional<Vector3d>& normal, double friction_force_N, double v0_m_s) {
    assert(v0_m_s > 0.0);
    Matrix3d across = Matrix3d::Identity();
    // Projection on the plane across the normal; without one friction acts against the whole velocity.
    if (normal) across -= normal->normalized() * normal->normalized().transpose();
    return std::make_shared<PointFriction>(loaded_nodes(body, cell, nodes), shares, across, friction_force_N, v0_m_s);
}

}  // namespace myo::model
