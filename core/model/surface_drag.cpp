#include "model/surface_drag.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// See surface_drag().
class SurfaceDrag : public ForceElement {
public:
    SurfaceDrag(std::shared_ptr<const std::vector<SampledFace>> faces, double linear, double quadratic)
        : faces_(std::move(faces)), linear_(linear), quadratic_(quadratic) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        if (!at.v) return;
        const double factor = at.velocity_factor_1_s;
        for (const SampledFace& face : *faces_) {
            const Matrix3Xd v = (*at.v)(Eigen::all, face.nodes);
            for (const SampledPoint& point : face.points) {
                const Vector3d u = v * point.shape;
                const double speed = u.norm();
                // The potential exists only for a given velocity_factor; at 0 (statics) the force has no Hessian in x.
                if (factor > 0.0)
                    out.energy += point.area / factor * speed * speed * (0.5 * linear_ + quadratic_ * speed / 3.0);
                add_force(face, point, point.area * (linear_ + quadratic_ * speed) * u, out.gradient);
                if (kind == HessianKind::none || factor == 0.0) continue;
                // dv/dx = factor turns the derivative by velocity into one by position.
                const Matrix3d H = factor * point.area * by_velocity(u);
                add_face_hessian(body, face, out.hessian, [&](std::size_t a, std::size_t b) {
                    return Matrix3d(point.shape(static_cast<Eigen::Index>(a)) *
                                    point.shape(static_cast<Eigen::Index>(b)) * H);
                });
            }
        }
    }

    bool depends_on_velocity() const override { return true; }
    void add_velocity_tangent(const Body&, const ForceState& at, const Matrix3Xd& dv,
                              Matrix3Xd& gradient) const override {
        for_each_point(at, [&](const SampledFace& face, const SampledPoint& point, const Vector3d& u) {
            const Vector3d du = dv(Eigen::all, face.nodes) * point.shape;
            add_force(face, point, point.area * by_velocity(u) * du, gradient);
        });
    }

    std::vector<ForceParameter> parameters() const override {
        return {{"linear_Pa_s_m", linear_, std::max(linear_, 1.0)},
                {"quadratic_kg_m3", quadratic_, std::max(quadratic_, 100.0)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<SurfaceDrag>(faces_, values(0), values(1));
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        for_each_point(at, [&](const SampledFace& face, const SampledPoint& point, const Vector3d& u) {
            add_force(face, point, point.area * (change(0) + change(1) * u.norm()) * u, gradient);
        });
    }

private:
    /// Derivative of the traction with respect to the velocity [Pa s/m].
    Matrix3d by_velocity(const Vector3d& u) const {
        const double speed = u.norm();
        const Matrix3d I = Matrix3d::Identity();
        // The quadratic part is differentiable at rest, with derivative zero.
        if (speed == 0.0) return linear_ * I;
        return (linear_ + quadratic_ * speed) * I + quadratic_ / speed * u * u.transpose();
    }

    // Distributes a force at a quadrature point to the nodes of its face.
    static void add_force(const SampledFace& face, const SampledPoint& point, const Vector3d& force,
                          Matrix3Xd& gradient) {
        for (std::size_t a = 0; a < face.nodes.size(); ++a)
            gradient.col(face.nodes[a]) += point.shape(static_cast<Eigen::Index>(a)) * force;
    }

    /// Calls visit(face, point, velocity) for all quadrature points; does nothing at rest.
    template <class Visit>
    void for_each_point(const ForceState& at, const Visit& visit) const {
        if (!at.v) return;
        for (const SampledFace& face : *faces_) {
            const Matrix3Xd v = (*at.v)(Eigen::all, face.nodes);
            for (const SampledPoint& point : face.points) visit(face, point, Vector3d(v * point.shape));
        }
    }

    std::shared_ptr<const std::vector<SampledFace>> faces_;
    double linear_, quadratic_;
};

}  // namespace

ForceElementPointer surface_drag(const Body& body, const std::vector<int>& faces, double linear_Pa_s_m,
                                 double quadratic_kg_m3) {
    auto wetted = std::make_shared<const std::vector<SampledFace>>(sampled_faces(body, faces));
    return std::make_shared<SurfaceDrag>(wetted, linear_Pa_s_m, quadratic_kg_m3);
}

}  // namespace myo::model
