#include "model/mount_forces.hpp"

#include <cassert>
#include <utility>

#include "base/cross_matrix.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Span of masses at a time; at its end the left limit belongs to it.
const MassMatrix& mass_in(const std::vector<MassSpan>& spans, const ForceState& at) {
    std::size_t k = span_at(spans, at.time_s);
    if (at.before_jump && k > 0 && at.time_s == spans[k - 1].until_s) --k;
    return spans[k].mass;
}

/// See mount_forces().
class MountForces : public ForceElement {
public:
    MountForces(const Model& model, MountMotionPointer motion)
        : motion_(std::move(motion)),
          masses_(mass_spans(model)),
          density_kg_m3_(model.density_kg_m3),
          gravity_m_s2_(model.gravity_m_s2),
          forces_(model.forces) {
        // The density is a parameter, so the part of the body in the mass is kept apart from attached masses.
        Model body = model;
        body.density_kg_m3 = 1.0;
        body.masses.clear();
        body.directional_masses.clear();
        unit_ = mass_matrix(body);
    }

    void add(const Body&, const ForceState& at, HessianKind, InternalEnergy& out) const override {
        const MountPose pose = motion_->at(at.time_s);
        const Matrix3Xd gradient = times_frame(pose, at, mass_in(masses_, at)) - turned_loads(pose, at);
        out.gradient += gradient;
        // The potential of the translation; with a rotation there is none.
        out.energy += gradient.cwiseProduct(at.x).sum();
    }

    // Always true: a state without velocities is one of statics, in which the frame is at rest.
    bool depends_on_velocity() const override { return true; }
    void add_velocity_tangent(const Body&, const ForceState& at, const Matrix3Xd& dv,
                              Matrix3Xd& gradient) const override {
        if (!at.v || !motion_->turns()) return;
        const Matrix3d W = cross_matrix(motion_->at(at.time_s).spin_rad_s);
        gradient += times_mass(2.0 * W * dv, mass_in(masses_, at));
    }
    void add_velocity_pull(const Body& body, const ForceState& at, const Matrix3Xd& p, Matrix3Xd& by_v) const override {
        // Coriolis forces do no work.
        add_velocity_tangent(body, at, -p, by_v);
    }

    bool has_potential() const override { return !motion_->turns(); }
    void add_unsymmetric_tangent(const Body&, const ForceState& at, const Matrix3Xd& dx,
                                 Matrix3Xd& gradient) const override {
        if (at.v && motion_->turns()) gradient += times_mass(by_position(at) * dx, mass_in(masses_, at));
    }
    void add_unsymmetric_pull(const Body&, const ForceState& at, const Matrix3Xd& p, Matrix3Xd& by_x) const override {
        if (at.v && motion_->turns()) by_x += by_position(at).transpose() * times_mass(p, mass_in(masses_, at));
    }

    std::vector<ForceParameter> parameters() const override {
        return {{"density_kg_m3", density_kg_m3_, density_kg_m3_ > 0.0 ? density_kg_m3_ : 1.0}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        auto copy = std::make_shared<MountForces>(*this);
        // Masses are linear in the density: no span is assembled again.
        for (MassSpan& span : copy->masses_)
            span.mass = mass_matrix(span.mass.isotropic + (values(0) - density_kg_m3_) * unit_.isotropic,
                                    span.mass.directional);
        copy->density_kg_m3_ = values(0);
        return copy;
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        const MountPose pose = motion_->at(at.time_s);
        gradient += change(0) * (times_frame(pose, at, unit_) - turned_weight(pose, unit_));
    }

    bool steady(double, double) const override { return false; }

private:
    /// M times the acceleration of the frame where each node is; zero for a mount at rest.
    static Matrix3Xd times_frame(const MountPose& pose, const ForceState& at, const MassMatrix& mass) {
        if (!at.v) return Matrix3Xd::Zero(3, at.x.cols());
        // Euler and centrifugal acceleration are A (x - pivot), Coriolis acceleration is 2 W v.
        const Matrix3d W = cross_matrix(pose.spin_rad_s), A = cross_matrix(pose.spin_rate_rad_s2) + W * W;
        const Vector3d a = pose.rotation.transpose() * pose.acceleration_m_s2 - A * pose.pivot_m;
        return times_mass((A * at.x + 2.0 * W * *at.v).colwise() + a, mass);
    }
    /// What the turn to the mount's frame adds to the weight, 3 x n [N].
    Matrix3Xd turned_weight(const MountPose& pose, const MassMatrix& mass) const {
        return (pose.rotation.transpose() * gravity_m_s2_ - gravity_m_s2_) * mass.nodal_kg.transpose();
    }
    /// What the turn adds to weight and dead loads, 3 x n [N].
    Matrix3Xd turned_loads(const MountPose& pose, const ForceState& at) const {
        Matrix3Xd sum = turned_weight(pose, mass_in(masses_, at));
        for (const DeadForce& load : forces_)
            if (const double factor = load.factor(at.time_s, at.before_jump); factor != 0.0)
                sum += factor * (pose.rotation.transpose() * load.force_N - load.force_N) * load.share.transpose();
        return sum;
    }
    /// Derivative of the frame's acceleration by the position of its node, with the velocity that the step gives it.
    Matrix3d by_position(const ForceState& at) const {
        const MountPose pose = motion_->at(at.time_s);
        const Matrix3d W = cross_matrix(pose.spin_rad_s);
        return cross_matrix(pose.spin_rate_rad_s2) + W * W + 2.0 * at.velocity_factor_1_s * W;
    }

    MountMotionPointer motion_;
    std::vector<MassSpan> masses_;
    MassMatrix unit_;  // of the body for a density of 1 kg/m3
    double density_kg_m3_;
    Vector3d gravity_m_s2_;
    std::vector<DeadForce> forces_;
};

/// See in_laboratory().
class InLaboratory : public ForceElement {
public:
    InLaboratory(ForceElementPointer element, MountMotionPointer motion)
        : element_(std::move(element)), motion_(std::move(motion)) {
        assert(element_->command() == nullptr);
    }

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const Seen seen = seen_at(at);
        InternalEnergy there;
        there.gradient = Matrix3Xd::Zero(3, at.x.cols());
        if (kind != HessianKind::none) there.hessian = body.pattern.zero;
        element_->add(body, seen.state(at), kind, there);
        out.energy += there.energy;
        const Matrix3d& R = seen.pose.rotation;
        out.gradient += R.transpose() * there.gradient;
        if (kind == HessianKind::none) return;
        // Without a turn the Hessian is the same in both frames.
        if (motion_->turns()) turn_blocks(R, there.hessian);
        out.hessian.coeffs() += there.hessian.coeffs();
    }

    bool depends_on_velocity() const override { return element_->depends_on_velocity(); }
    void add_velocity_tangent(const Body& body, const ForceState& at, const Matrix3Xd& dv,
                              Matrix3Xd& gradient) const override {
        gradient += through_laboratory(at, dv, [&](const Seen& seen, const Matrix3Xd& turned, Matrix3Xd& there) {
            element_->add_velocity_tangent(body, seen.state(at), turned, there);
        });
    }
    void add_velocity_pull(const Body& body, const ForceState& at, const Matrix3Xd& p, Matrix3Xd& by_v) const override {
        by_v += through_laboratory(at, p, [&](const Seen& seen, const Matrix3Xd& turned, Matrix3Xd& there) {
            element_->add_velocity_pull(body, seen.state(at), turned, there);
        });
    }

    bool has_potential() const override {
        return element_->has_potential() && !(motion_->turns() && element_->depends_on_velocity());
    }
    // Beyond what the element has: where a node goes changes its velocity by the spin of the mount.
    void add_unsymmetric_tangent(const Body& body, const ForceState& at, const Matrix3Xd& dx,
                                 Matrix3Xd& gradient) const override {
        gradient += through_laboratory(at, dx, [&](const Seen& seen, const Matrix3Xd& turned, Matrix3Xd& there) {
            element_->add_unsymmetric_tangent(body, seen.state(at), turned, there);
            if (at.v && motion_->turns())
                element_->add_velocity_tangent(body, seen.state(at),
                                               seen.pose.rotation * cross_matrix(seen.pose.spin_rad_s) * dx, there);
        });
    }
    void add_unsymmetric_pull(const Body& body, const ForceState& at, const Matrix3Xd& p,
                              Matrix3Xd& by_x) const override {
        const Seen seen = seen_at(at);
        const Matrix3d& R = seen.pose.rotation;
        Matrix3Xd there = Matrix3Xd::Zero(3, p.cols());
        element_->add_unsymmetric_pull(body, seen.state(at), R * p, there);
        by_x += R.transpose() * there;
        if (!at.v || !motion_->turns()) return;
        Matrix3Xd by_velocity = Matrix3Xd::Zero(3, p.cols());
        element_->add_velocity_pull(body, seen.state(at), R * p, by_velocity);
        by_x += (R * cross_matrix(seen.pose.spin_rad_s)).transpose() * by_velocity;
    }

    std::vector<ForceParameter> parameters() const override { return element_->parameters(); }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<InLaboratory>(element_->changed(values), motion_);
    }
    void add_tangent(const Body& body, const ForceState& at, const VectorXd& change,
                     Matrix3Xd& gradient) const override {
        const Seen seen = seen_at(at);
        Matrix3Xd there = Matrix3Xd::Zero(3, gradient.cols());
        element_->add_tangent(body, seen.state(at), change, there);
        gradient += seen.pose.rotation.transpose() * there;
    }

    bool steady(double, double) const override { return false; }
    std::vector<double> jumps() const override { return element_->jumps(); }

private:
    /// The state as it is in the laboratory.
    struct Seen {
        MountPose pose;
        Matrix3Xd x, v;

        ForceState state(const ForceState& at) const {
            return {x, at.v ? &v : nullptr, at.velocity_factor_1_s, at.time_s, at.before_jump};
        }
    };
    /// What an operation of the element makes of directions, which it is given and gives back in the laboratory.
    template <class Operation>
    Matrix3Xd through_laboratory(const ForceState& at, const Matrix3Xd& directions, const Operation& operation) const {
        const Seen seen = seen_at(at);
        Matrix3Xd there = Matrix3Xd::Zero(3, directions.cols());
        operation(seen, seen.pose.rotation * directions, there);
        return seen.pose.rotation.transpose() * there;
    }
    /// Positions and velocities in the laboratory, with the pose that turns results back.
    Seen seen_at(const ForceState& at) const {
        Seen seen{motion_->at(at.time_s), {}, {}};
        seen.x = seen.pose.in_laboratory(at.x);
        if (at.v) seen.v = seen.pose.velocities_in_laboratory(at.x, *at.v);
        return seen;
    }
    /// H -> R' H R in every 3 x 3 block of the lower triangle.
    static void turn_blocks(const Matrix3d& R, solver::SymmetricSparse& H) {
        for (Eigen::Index column = 0; column + 2 < H.outerSize(); column += 3) {
            double* starts[3];
            for (int s = 0; s < 3; ++s) starts[s] = H.valuePtr() + H.outerIndexPtr()[column + s];
            const Eigen::Index blocks = (H.outerIndexPtr()[column + 1] - H.outerIndexPtr()[column]) / 3;
            for (Eigen::Index k = 0; k < blocks; ++k) {
                Matrix3d B;
                for (int s = 0; s < 3; ++s)
                    for (int r = 0; r < 3; ++r)
                        // The diagonal block is stored from its diagonal on.
                        B(r, s) = k > 0 ? starts[s][3 * k - s + r] : r >= s ? starts[s][r - s] : starts[r][s - r];
                const Matrix3d turned = R.transpose() * B * R;
                for (int s = 0; s < 3; ++s)
                    for (int r = k > 0 ? 0 : s; r < 3; ++r)
                        (k > 0 ? starts[s][3 * k - s + r] : starts[s][r - s]) = turned(r, s);
            }
        }
    }

    ForceElementPointer element_;
    MountMotionPointer motion_;
};

}  // namespace

ForceElementPointer mount_forces(const Model& model, MountMotionPointer motion) {
    assert(motion);
    return std::make_shared<MountForces>(model, std::move(motion));
}

ForceElementPointer in_laboratory(ForceElementPointer element, MountMotionPointer motion) {
    assert(element && motion);
    return std::make_shared<InLaboratory>(std::move(element), std::move(motion));
}

}  // namespace myo::model
