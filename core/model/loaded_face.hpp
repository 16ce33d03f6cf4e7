#pragma once

#include <cstddef>
#include <vector>

#include "model/body.hpp"

namespace myo::model {

/// A face of the body's boundary with what its place in the body's matrix takes.
struct LoadedFace {
    std::vector<int> nodes;
    int cell = 0;                // behind it
    std::vector<int> cell_node;  // of each node, its number in the cell
};

/// Those of the body's boundary faces.
std::vector<LoadedFace> loaded_faces(const Body& body, const std::vector<int>& faces);

/// Nodes of one cell, on its surface or not, as the carriers of a force at a point.
LoadedFace loaded_nodes(const Body& body, int cell, const std::vector<int>& nodes);

/// Faces of the body's boundary all of whose nodes are among these.
std::vector<int> faces_of_nodes(const Body& body, const std::vector<int>& nodes);

/// Faces of the boundary with a node that is not clamped.
std::vector<int> free_faces(const Body& body);

/// Adds block(a, b), 3 x 3, to the matrix for the pairs of a face's nodes that it stores.
template <class Block>
void add_face_hessian(const Body& body, const LoadedFace& face, solver::SymmetricSparse& matrix, const Block& block) {
    const int per_cell = static_cast<int>(body.mesh.cells.rows());
    for (std::size_t b = 0; b < face.nodes.size(); ++b)
        for (std::size_t a = 0; a < face.nodes.size(); ++a)
            if (body.pattern.stores(per_cell, face.cell, face.cell_node[a], face.cell_node[b]))
                body.pattern.add(matrix, body.mesh.cells, face.cell, face.cell_node[a], face.cell_node[b], block(a, b));
}

}  // namespace myo::model
