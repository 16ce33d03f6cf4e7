#include "model/loaded_face.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"

namespace myo::model {

LoadedFace loaded_nodes(const Body& body, int cell, const std::vector<int>& nodes) {
    LoadedFace face{nodes, cell, {}};
    const auto column = body.mesh.cells.col(cell);
    for (const int node : nodes)
        face.cell_node.push_back(static_cast<int>(std::find(column.begin(), column.end(), node) - column.begin()));
    return face;
}

std::vector<LoadedFace> loaded_faces(const Body& body, const std::vector<int>& faces) {
    std::vector<LoadedFace> loaded;
    for (const int f : faces) {
        const auto nodes = body.boundary.nodes.col(f);
        loaded.push_back(loaded_nodes(body, body.boundary.cell(f), {nodes.begin(), nodes.end()}));
    }
    return loaded;
}

std::vector<SampledFace> sampled_faces(const Body& body, const std::vector<int>& faces) {
    std::vector<SampledFace> sampled;
    for (const LoadedFace& loaded : loaded_faces(body, faces)) {
        SampledFace face{loaded, {}};
        const auto count = static_cast<int>(face.nodes.size());
        const Eigen::Matrix3Xd X = body.mesh.nodes(Eigen::all, face.nodes);
        for (const mesh::FacePoint& point : mesh::face_quadrature(count)) {
            const Eigen::Matrix<double, 3, 2> T = X * mesh::face_shape_gradient(count, point.uv);
            // Rest area element |X_u x X_v| times the weight of the rule.
            face.points.push_back({mesh::face_shape(count, point.uv), point.weight * T.col(0).cross(T.col(1)).norm()});
        }
        sampled.push_back(std::move(face));
    }
    return sampled;
}

std::vector<int> faces_of_nodes(const Body& body, const std::vector<int>& nodes) {
    std::vector<bool> among(static_cast<std::size_t>(body.node_count()), false);
    for (const int node : nodes) among[static_cast<std::size_t>(node)] = true;
    std::vector<int> faces;
    for (int f = 0; f < static_cast<int>(body.boundary.count()); ++f) {
        const auto corners = body.boundary.nodes.col(f);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](int node) { return among[static_cast<std::size_t>(node)]; }))
            faces.push_back(f);
    }
    return faces;
}

std::vector<int> free_faces(const Body& body) {
    std::vector<int> faces;
    for (int f = 0; f < static_cast<int>(body.boundary.count()); ++f) {
        const auto nodes = body.boundary.nodes.col(f);
        // Forces on clamped nodes do no work; a face of such nodes alone carries none.
        if (!std::all_of(nodes.begin(), nodes.end(),
                         [&](int node) { return body.clamped[static_cast<std::size_t>(node)]; }))
            faces.push_back(f);
    }
    return faces;
}

}  // namespace myo::model
