#include "fem/reference_points.hpp"

#include "fem/quadrature.hpp"
#include "fem/shape_functions.hpp"

namespace myo::fem {
namespace {

/// Shape functions at the points of a rule.
template <class Shape>
std::vector<Eigen::VectorXd> values_of(const std::vector<QuadraturePoint>& rule) {
    std::vector<Eigen::VectorXd> values;
    for (const QuadraturePoint& point : rule) values.emplace_back(Shape::values(point.xi));
    return values;
}

}  // namespace

std::vector<Eigen::VectorXd> shape_values_at_points(ElementKind kind) {
    switch (kind) {
        case ElementKind::hex8_mean_dilatation:
        case ElementKind::hex8_full: return values_of<Hex8>(hex_gauss(2));
        case ElementKind::tet10:
        case ElementKind::tet10_full: return values_of<Tet10>(tet_degree2());
        case ElementKind::tet10_fine: return values_of<Tet10>(tet_degree3());
        case ElementKind::tet4: return values_of<Tet4>(tet_centroid());
        case ElementKind::hex8: break;
    }
    std::vector<Eigen::VectorXd> values;
    for (int q = 0; q < assumed_strain_rule::points; ++q) values.emplace_back(Hex8::values(assumed_strain_point(q)));
    return values;
}

}  // namespace myo::fem
