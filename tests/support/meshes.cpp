#include "support/meshes.hpp"

namespace myo::test {

mesh::VolumeMesh box_mesh(fem::ElementKind kind, const Box& box, const Eigen::Vector3i& cells) {
    return fem::cell_type(kind) == mesh::CellType::hex8 ? mesh::box_hex_mesh(box, cells)
                                                        : mesh::tet_box_mesh(box, cells, fem::cell_type(kind));
}

Box unit_box() { return {Eigen::Vector3d::Zero(), Eigen::Vector3d(1.0, 0.8, 0.6)}; }

/// Distorted cells show errors that regular ones hide, such as a wrong Jacobian.
mesh::VolumeMesh distorted_mesh(mesh::CellType type, const Eigen::Vector3i& cells, double strength, unsigned seed) {
    mesh::VolumeMesh mesh = type == mesh::CellType::hex8 ? mesh::box_hex_mesh(unit_box(), cells)
                                                         : mesh::tet_box_mesh(unit_box(), cells, mesh::CellType::tet4);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-strength, strength);
    // Strength is relative to the cell, so that cells of any size stay valid.
    const Eigen::Vector3d size = unit_box().size().cwiseQuotient(cells.cast<double>());
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        for (int r = 0; r < 3; ++r) mesh.nodes(r, i) += shift(random) * size(r);
    // Nodes were moved before, so the nodes in the middle of edges lie on straight edges.
    return type == mesh::CellType::tet10 ? mesh::to_tet10(mesh) : mesh;
}

fem::ElementKind element(const std::string& id) {
    fem::ElementKind kind{};
    fem::parse_element(id, kind);
    return kind;
}

Eigen::Matrix3Xd mapped(const mesh::VolumeMesh& mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& t) {
    return (A * mesh.nodes).colwise() + t;
}

Eigen::Matrix3Xd rough_field(Eigen::Index nodes, double phase) {
    Eigen::Matrix3Xd field(3, nodes);
    // 1.7 rad per entry: neighbouring values are nearly independent.
    for (Eigen::Index i = 0; i < field.size(); ++i) field(i) = std::sin(phase + 1.7 * static_cast<double>(i));
    return field;
}

}  // namespace myo::test
