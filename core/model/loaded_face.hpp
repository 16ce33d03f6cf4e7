#pragma once

#include <cstddef>
#include <vector>

#include "model/body.hpp"

namespace myo::model {

/// Boundary face with the indices needed to assemble into the body's matrix.
struct LoadedFace {
    std::vector<int> nodes;      // nodes of the face
    int cell = 0;                // cell behind the face
    std::vector<int> cell_node;  // per node of the face: its index in the cell
};

/// Loaded faces for given faces of the boundary.
///
/// @param faces  columns of Body::boundary
std::vector<LoadedFace> loaded_faces(const Body& body, const std::vector<int>& faces);

/// Quadrature point of a face.
struct SampledPoint {
    Eigen::VectorXd shape;  // shape functions of the face nodes
    double area = 0.0;      // [m2] rest area times weight
};
/// Loaded face with its quadrature points.
struct SampledFace : LoadedFace {
    std::vector<SampledPoint> points;
};
/// loaded_faces() with their quadrature points.
std::vector<SampledFace> sampled_faces(const Body& body, const std::vector<int>& faces);

/// Nodes of one cell, on its surface or not, as the carriers of a force at a point.
LoadedFace loaded_nodes(const Body& body, int cell, const std::vector<int>& nodes);

/// Boundary faces whose nodes are all in the list.
std::vector<int> faces_of_nodes(const Body& body, const std::vector<int>& nodes);

/// Boundary faces with at least one free node.
std::vector<int> free_faces(const Body& body);

/// Adds block(a, b), 3 x 3 [N/m], for all stored pairs of nodes of a face.
template <class Block>
void add_face_hessian(const Body& body, const LoadedFace& face, solver::SymmetricSparse& matrix, const Block& block) {
    const int per_cell = static_cast<int>(body.mesh.cells.rows());
    for (std::size_t b = 0; b < face.nodes.size(); ++b)
        for (std::size_t a = 0; a < face.nodes.size(); ++a)
            if (body.pattern.stores(per_cell, face.cell, face.cell_node[a], face.cell_node[b]))
                body.pattern.add(matrix, body.mesh.cells, face.cell, face.cell_node[a], face.cell_node[b], block(a, b));
}

}  // namespace myo::model
