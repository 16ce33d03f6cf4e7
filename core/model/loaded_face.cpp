#include "model/loaded_face.hpp"

#include <algorithm>

namespace myo::model {

std::vector<LoadedFace> loaded_faces(const Body& body, const std::vector<int>& faces) {
    std::vector<LoadedFace> loaded;
    for (const int f : faces) {
        LoadedFace face;
        face.cell = body.boundary.cell(f);
        // Local numbers in the cell address the face's blocks in the pattern of the body.
        const auto cell = body.mesh.cells.col(face.cell);
        for (const int node : body.boundary.nodes.col(f)) {
            face.nodes.push_back(node);
            face.cell_node.push_back(static_cast<int>(std::find(cell.begin(), cell.end(), node) - cell.begin()));
        }
        loaded.push_back(std::move(face));
    }
    return loaded;
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
        if (!std::all_of(nodes.begin(), nodes.end(),
                         [&](int node) { return body.clamped[static_cast<std::size_t>(node)]; }))
            faces.push_back(f);
    }
    return faces;
}

}  // namespace myo::model
