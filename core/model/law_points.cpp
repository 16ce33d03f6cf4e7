#include "model/law_points.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mesh/cells.hpp"
#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"

namespace myo::model {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

std::vector<LawCarrier> law_points_of_faces(const Body& body, const std::vector<int>& faces) {
    std::vector<LawCarrier> carriers;
    for (const LoadedFace& loaded : loaded_faces(body, faces)) {
        LawCarrier carrier{loaded, {}};
        const auto count = static_cast<int>(carrier.nodes.size());
        const Matrix3Xd X = body.mesh.nodes(Eigen::all, carrier.nodes);
        for (const mesh::FacePoint& at : mesh::face_quadrature(count)) {
            LawPoint point{mesh::face_shape(count, at.uv), mesh::face_shape_gradient(count, at.uv)};
            const Eigen::Matrix<double, 3, 2> T = X * point.gradient;
            const Vector3d N = T.col(0).cross(T.col(1));
            point.rest_measure = N.norm();
            point.weight = at.weight * point.rest_measure;
            point.rest_m = X * point.shape;
            point.normal = N / point.rest_measure;
            carrier.points.push_back(std::move(point));
        }
        carriers.push_back(std::move(carrier));
    }
    return carriers;
}

std::vector<LawCarrier> law_points_of_cells(const Body& body) {
    return mesh::with_cell(body.mesh.type, [&](auto of_type) {
        using Cell = decltype(of_type);
        std::vector<LawCarrier> carriers;
        for (int c = 0; c < body.cell_count(); ++c) {
            const auto cell = body.mesh.cells.col(c);
            LawCarrier carrier{loaded_nodes(body, c, {cell.begin(), cell.end()}), {}};
            const auto X = mesh::cell_nodes<Cell>(body.mesh, c);
            for (const mesh::QuadraturePoint& at : Cell::volume_rule()) {
                const Eigen::Matrix3d jacobian = X * Cell::derivatives(at.xi);
                // No face, hence no normal: laws in a volume do not use one.
                LawPoint point{Cell::values(at.xi), {}, at.weight * jacobian.determinant()};
                point.rest_m = X * point.shape;
                carrier.points.push_back(std::move(point));
            }
            carriers.push_back(std::move(carrier));
        }
        return carriers;
    });
}

std::vector<LawCarrier> law_point(const Body& body, int cell, const std::vector<int>& nodes,
                                  const Eigen::VectorXd& shares, const Vector3d& normal) {
    LawCarrier carrier{loaded_nodes(body, cell, nodes), {}};
    LawPoint point{shares, {}};
    point.rest_m = body.mesh.nodes(Eigen::all, nodes) * shares;
    point.normal = normal;
    carrier.points.push_back(std::move(point));
    return {carrier};
}

}  // namespace myo::model
