#include "support/meshes.hpp"

namespace myo::test {

VolumeMesh box_mesh(ElementKind kind, const Box& box, const Eigen::Vector3i& cells) {
    return cell_type(kind) == CellType::hex8 ? box_hex_mesh(box, cells) : tet_box_mesh(box, cells, cell_type(kind));
}

Box unit_box() { return {Eigen::Vector3d::Zero(), Eigen::Vector3d(1.0, 0.8, 0.6)}; }

VolumeMesh distorted_mesh(CellType type, const Eigen::Vector3i& cells, double strength, unsigned seed) {
    VolumeMesh mesh = type == CellType::hex8 ? box_hex_mesh(unit_box(), cells) : tet_box_mesh(unit_box(), cells, CellType::tet4);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-strength, strength);
    const Eigen::Vector3d size = unit_box().size().cwiseQuotient(cells.cast<double>());
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        for (int r = 0; r < 3; ++r) mesh.nodes(r, i) += shift(random) * size(r);
    return type == CellType::tet10 ? to_tet10(mesh) : mesh;
}

ElementKind element(const std::string& id) {
    ElementKind kind{};
    parse_element(id, kind);
    return kind;
}

Eigen::Matrix3Xd mapped(const VolumeMesh& mesh, const Eigen::Matrix3d& A, const Eigen::Vector3d& t) {
    return (A * mesh.nodes).colwise() + t;
}

Eigen::Matrix3Xd rough_field(Eigen::Index nodes, double phase) {
    Eigen::Matrix3Xd field(3, nodes);
    for (Eigen::Index i = 0; i < field.size(); ++i) field(i) = std::sin(phase + 1.7 * static_cast<double>(i));
    return field;
}

}  // namespace myo::test
