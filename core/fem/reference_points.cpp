#include "fem/reference_points.hpp"

#include "mesh/cells.hpp"

namespace myo::fem {
namespace {

/// Shape functions at the points of a rule.
template <class Shape>
std::vector<Eigen::VectorXd> values_of(const std::vector<mesh::QuadraturePoint>& rule) {
    std::vector<Eigen::VectorXd> values;
    for (const mesh::QuadraturePoint& point : rule) values.emplace_back(Shape::values(point.xi));
    return values;
}

}  // namespace

std::vector<Eigen::VectorXd> shape_values_at_points(ElementKind kind) {
    switch (kind) {
        case ElementKind::hex8_mean_dilatation:
        case ElementKind::hex8_full: return values_of<mesh::Hex8>(mesh::hex_gauss(2));
        case ElementKind::tet10:
        case ElementKind::tet10_full: return values_of<mesh::Tet10>(mesh::tet_degree2());
        case ElementKind::tet10_fine: return values_of<mesh::Tet10>(mesh::tet_degree3());
        case ElementKind::tet4: return values_of<mesh::Tet4>(mesh::tet_centroid());
        case ElementKind::hex8: break;
    }
    std::vector<Eigen::VectorXd> values;
    for (int q = 0; q < AssumedStrainRule::points; ++q)
        values.emplace_back(mesh::Hex8::values(assumed_strain_point(q)));
    return values;
}

}  // namespace myo::fem
