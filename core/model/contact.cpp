#include "model/contact.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/loaded_face.hpp"
#include "model/one_sided.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Speed of sliding and how friction takes it.
struct Sliding {
    Vector3d velocity = Vector3d::Zero();   // of the point [m/s]
    Vector3d direction = Vector3d::Zero();  // v_t / sqrt(|v_t|^2 + v0^2)
    double speed = 1.0;                     // sqrt(|v_t|^2 + v0^2) [m/s]
    double factor_1_s = 0.0;                // dv/dx
};

/// A point that touches the obstacle.
struct Touch {
    SignedDistance gap;
    OneSided pressed;
    Sliding slide;
};

/// See contact().
class Contact : public ForceElement {
public:
    Contact(std::shared_ptr<const std::vector<SampledFace>> faces, DistanceField obstacle, const ContactLaw& law)
        : faces_(std::move(faces)), obstacle_(std::move(obstacle)), law_(law) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        if (!at.v && law_.static_bed_Pa_m > 0.0) add_bed(body, at, kind, out);
        for_each_touch(body, at, [&](const SampledFace& face, const SampledPoint& point, const Touch& t) {
            const double k = point.area * law_.stiffness_Pa_m, normal_N = k * t.pressed.slope;
            out.energy += k * t.pressed.value;
            add_force(face, point, normal_N * (law_.friction * t.slide.direction - t.gap.normal), out.gradient);
            if (kind == HessianKind::none) return;
            Matrix3d H = k * t.pressed.second * t.gap.normal * t.gap.normal.transpose() +
                         t.slide.factor_1_s * law_.friction * normal_N * by_velocity(t);
            // The curvature of the obstacle softens; it is left out where the Hessian must be positive.
            if (kind == HessianKind::exact) H -= normal_N * t.gap.curvature_1_m;
            add_hessian(body, face, point, H, out);
        });
    }

    // Always: without velocities the element is in statics.
    bool depends_on_velocity() const override { return true; }
    void add_velocity_tangent(const Body& body, const ForceState& at, const Matrix3Xd& dv,
                              Matrix3Xd& gradient) const override {
        if (!at.v || law_.friction == 0.0) return;
        for_each_touch(body, at, [&](const SampledFace& face, const SampledPoint& point, const Touch& t) {
            const Vector3d du = dv(Eigen::all, face.nodes) * point.shape;
            add_force(face, point, friction_N(point, t) * by_velocity(t) * du, gradient);
        });
    }

    bool has_potential() const override { return law_.friction == 0.0; }
    void add_unsymmetric_tangent(const Body& body, const ForceState& at, const Matrix3Xd& dx,
                                 Matrix3Xd& gradient) const override {
        if (law_.friction == 0.0) return;
        for_each_touch(body, at, [&](const SampledFace& face, const SampledPoint& point, const Touch& t) {
            add_force(face, point, by_position(point, t) * (dx(Eigen::all, face.nodes) * point.shape), gradient);
        });
    }
    void add_unsymmetric_pull(const Body& body, const ForceState& at, const Matrix3Xd& p,
                              Matrix3Xd& by_x) const override {
        if (law_.friction == 0.0) return;
        for_each_touch(body, at, [&](const SampledFace& face, const SampledPoint& point, const Touch& t) {
            add_force(face, point, by_position(point, t).transpose() * (p(Eigen::all, face.nodes) * point.shape), by_x);
        });
    }

    std::vector<ForceParameter> parameters() const override {
        if (law_.friction == 0.0) return {};
        return {{"friction", law_.friction, std::max(law_.friction, 0.1)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        ContactLaw law = law_;
        if (values.size() > 0) law.friction = values(0);
        return std::make_shared<Contact>(faces_, obstacle_, law);
    }
    void add_tangent(const Body& body, const ForceState& at, const VectorXd& change,
                     Matrix3Xd& gradient) const override {
        if (change.size() == 0) return;
        for_each_touch(body, at, [&](const SampledFace& face, const SampledPoint& point, const Touch& t) {
            const double normal_N = point.area * law_.stiffness_Pa_m * t.pressed.slope;
            add_force(face, point, change(0) * normal_N * t.slide.direction, gradient);
        });
    }

private:
    /// Largest friction at a point [N]: Coulomb's coefficient times the normal force.
    double friction_N(const SampledPoint& point, const Touch& t) const {
        return law_.friction * point.area * law_.stiffness_Pa_m * t.pressed.slope;
    }
    /// Derivative of the direction of friction by the point's velocity; positive semidefinite.
    static Matrix3d by_velocity(const Touch& t) {
        return (Matrix3d::Identity() - t.gap.normal * t.gap.normal.transpose() -
                t.slide.direction * t.slide.direction.transpose()) /
               t.slide.speed;
    }
    /// Derivative of friction by the point's position at fixed velocity: the normal force and the normal change.
    Matrix3d by_position(const SampledPoint& point, const Touch& t) const {
        const Vector3d &n = t.gap.normal, &v = t.slide.velocity, &w = t.slide.direction;
        const Matrix3d& C = t.gap.curvature_1_m;
        // The normal turns with the position by the curvature, and with it the part of the velocity across.
        const Matrix3d turned = (Matrix3d::Identity() - w * w.transpose()) / t.slide.speed *
                                (n.dot(v) * C + n * (C * v).transpose());
        return -law_.friction * point.area * law_.stiffness_Pa_m *
               (t.pressed.second * w * n.transpose() + t.pressed.slope * turned);
    }

    /// Sliding of a point across the obstacle's normal; of statics the displacement, as velocity of size v0 at the
    /// slip.
    Sliding sliding(const Body& body, const ForceState& at, const SampledFace& face, const SampledPoint& point,
                    const Vector3d& normal) const {
        Sliding slide;
        if (law_.friction == 0.0) return slide;
        // Without velocities the state is one of statics.
        if (at.v) {
            slide.velocity = (*at.v)(Eigen::all, face.nodes) * point.shape;
            slide.factor_1_s = at.velocity_factor_1_s;
        } else {
            slide.factor_1_s = law_.v0_m_s / law_.static_slip_m;
            slide.velocity = slide.factor_1_s * moved(body, at, face, point);
        }
        const Vector3d across = slide.velocity - normal.dot(slide.velocity) * normal;
        slide.speed = std::hypot(across.norm(), law_.v0_m_s);
        slide.direction = across / slide.speed;
        return slide;
    }

    /// Displacement of a point from the rest shape [m].
    static Vector3d moved(const Body& body, const ForceState& at, const SampledFace& face, const SampledPoint& point) {
        return (at.x(Eigen::all, face.nodes) - body.mesh.nodes(Eigen::all, face.nodes)) * point.shape;
    }

    /// Calls visit(face, point, touch) for all quadrature points inside the obstacle.
    template <class Visit>
    void for_each_touch(const Body& body, const ForceState& at, const Visit& visit) const {
        for (const SampledFace& face : *faces_) {
            const Matrix3Xd x = at.x(Eigen::all, face.nodes);
            for (const SampledPoint& point : face.points) {
                Touch touch;
                touch.gap = obstacle_(x * point.shape);
                if (!(touch.gap.distance_m < 0.0)) continue;
                touch.pressed = one_sided(-touch.gap.distance_m, law_.onset_m);
                touch.slide = sliding(body, at, face, point, touch.gap.normal);
                visit(face, point, touch);
            }
        }
    }

    /// Weak springs to the rest shape, so that statics of a body that nothing clamps are determined.
    void add_bed(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const {
        for (const SampledFace& face : *faces_)
            for (const SampledPoint& point : face.points) {
                const double k = law_.static_bed_Pa_m * point.area;
                const Vector3d u = moved(body, at, face, point);
                out.energy += 0.5 * k * u.squaredNorm();
                add_force(face, point, k * u, out.gradient);
                if (kind != HessianKind::none) add_hessian(body, face, point, k * Matrix3d::Identity(), out);
            }
    }

    /// Adds the block H [N/m] of a point to the nodes of its face.
    static void add_hessian(const Body& body, const SampledFace& face, const SampledPoint& point, const Matrix3d& H,
                            InternalEnergy& out) {
        add_face_hessian(body, face, out.hessian, [&](std::size_t a, std::size_t b) {
            return Matrix3d(point.shape(static_cast<Eigen::Index>(a)) * point.shape(static_cast<Eigen::Index>(b)) * H);
        });
    }
    static void add_force(const SampledFace& face, const SampledPoint& point, const Vector3d& force,
                          Matrix3Xd& gradient) {
        for (std::size_t a = 0; a < face.nodes.size(); ++a)
            gradient.col(face.nodes[a]) += point.shape(static_cast<Eigen::Index>(a)) * force;
    }

    std::shared_ptr<const std::vector<SampledFace>> faces_;
    DistanceField obstacle_;
    ContactLaw law_;
};

}  // namespace

ForceElementPointer contact(const Body& body, const std::vector<int>& faces, const DistanceField& obstacle,
                            const ContactLaw& law) {
    assert(law.stiffness_Pa_m > 0.0 && law.onset_m > 0.0 && law.v0_m_s > 0.0 && law.static_slip_m > 0.0);
    return std::make_shared<Contact>(std::make_shared<const std::vector<SampledFace>>(sampled_faces(body, faces)),
                                     obstacle, law);
}

double deepest_penetration(const Body& body, const std::vector<int>& faces, const DistanceField& obstacle,
                           const Matrix3Xd& x) {
    double deepest = 0.0;
    for (const SampledFace& face : sampled_faces(body, faces))
        for (const SampledPoint& point : face.points)
            deepest = std::max(deepest, -obstacle(x(Eigen::all, face.nodes) * point.shape).distance_m);
    return deepest;
}

}  // namespace myo::model
