#include "model/elastic_bed.hpp"

#include <Eigen/Geometry>

#include <cassert>

#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"
#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Products of shape functions of one face, integrated over its rest area.
struct BedFace : LoadedFace {
    MatrixXd area;  // integral of N_a N_b [m2], nodes x nodes
};

/// See elastic_bed().
class ElasticBed : public ForceElement {
public:
    ElasticBed(std::shared_ptr<const std::vector<BedFace>> faces, double stiffness)
        : faces_(std::move(faces)), stiffness_(stiffness) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        for (const BedFace& face : *faces_) {
            // Displacement from the rest configuration; the force is linear in it.
            const Matrix3Xd u = at.x(Eigen::all, face.nodes) - body.mesh.nodes(Eigen::all, face.nodes);
            const Matrix3Xd force = stiffness_ * u * face.area;
            out.energy += 0.5 * force.cwiseProduct(u).sum();
            for (std::size_t a = 0; a < face.nodes.size(); ++a)
                out.gradient.col(face.nodes[a]) += force.col(static_cast<Eigen::Index>(a));
            if (kind == HessianKind::none) continue;
            add_face_hessian(body, face, out.hessian, [&](std::size_t a, std::size_t b) {
                return Matrix3d(stiffness_ * face.area(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) *
                                Matrix3d::Identity());
            });
        }
    }

    std::vector<ForceParameter> parameters() const override { return {{"stiffness_Pa_per_m", stiffness_, stiffness_}}; }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<ElasticBed>(faces_, values(0));
    }
    void add_tangent(const Body& body, const ForceState& at, const VectorXd& change,
                     Matrix3Xd& gradient) const override {
        for (const BedFace& face : *faces_) {
            // The force is proportional to the stiffness.
            const Matrix3Xd force = change(0) *
                                    (at.x(Eigen::all, face.nodes) - body.mesh.nodes(Eigen::all, face.nodes)) *
                                    face.area;
            for (std::size_t a = 0; a < face.nodes.size(); ++a)
                gradient.col(face.nodes[a]) += force.col(static_cast<Eigen::Index>(a));
        }
    }

private:
    std::shared_ptr<const std::vector<BedFace>> faces_;
    double stiffness_;
};

}  // namespace

ForceElementPointer elastic_bed(const Body& body, const std::vector<int>& faces, double stiffness_Pa_per_m) {
    assert(stiffness_Pa_per_m > 0.0);
    auto bed = std::make_shared<std::vector<BedFace>>();
    for (const LoadedFace& loaded : loaded_faces(body, faces)) {
        BedFace face{loaded, {}};
        const auto count = static_cast<Eigen::Index>(face.nodes.size());
        face.area = MatrixXd::Zero(count, count);
        const Matrix3Xd X = body.mesh.nodes(Eigen::all, face.nodes);
        for (const mesh::FacePoint& point : mesh::face_quadrature(static_cast<int>(count))) {
            // Rest area element |X_u x X_v|.
            const VectorXd N = mesh::face_shape(static_cast<int>(count), point.uv);
            const Eigen::Matrix<double, 3, 2> T = X * mesh::face_shape_gradient(static_cast<int>(count), point.uv);
            face.area += point.weight * T.col(0).cross(T.col(1)).norm() * N * N.transpose();
        }
        bed->push_back(std::move(face));
    }
    return std::make_shared<ElasticBed>(bed, stiffness_Pa_per_m);
}

bool is_elastic_bed(const ForceElement& element) { return dynamic_cast<const ElasticBed*>(&element) != nullptr; }

}  // namespace myo::model
