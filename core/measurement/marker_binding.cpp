#include "measurement/marker_binding.hpp"

#include <Eigen/LU>

#include <algorithm>

#include "fem/reference_coordinates.hpp"
#include "fem/shape_functions.hpp"
#include "material/polar.hpp"

namespace myo::measurement {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

template <class Shape>
void set_shape(MarkerBinding& binding, const Eigen::Matrix3Xd& X, const Vector3d& point, const Vector3d& middle) {
    const Vector3d xi = fem::reference_coordinates<Shape>(X, point, middle);
    const auto D = Shape::derivatives(xi);
    binding.weights = Shape::values(xi);
    binding.gradient = D * (X * D).inverse();
}

/// Below a billionth of a metre an offset is rounding of the rest position.
bool on_surface(const MarkerBinding& binding) { return binding.standoff_m() < 1e-9; }

}  // namespace

MarkerBinding bind_marker(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& locator, const Vector3d& rest_m) {
    const mesh::BoundaryPoint nearest = mesh::closest_boundary_point(locator, rest_m);
    MarkerBinding binding;
    Eigen::Matrix3Xd X(3, mesh.cells.rows());
    for (Eigen::Index a = 0; a < mesh.cells.rows(); ++a) {
        binding.nodes.push_back(mesh.cells(a, nearest.cell));
        X.col(a) = mesh.nodes.col(mesh.cells(a, nearest.cell));
    }
    switch (mesh.type) {
        case mesh::CellType::hex8: set_shape<fem::Hex8>(binding, X, nearest.point, Vector3d::Zero()); break;
        case mesh::CellType::tet4: set_shape<fem::Tet4>(binding, X, nearest.point, Vector3d::Constant(0.25)); break;
        case mesh::CellType::tet10: set_shape<fem::Tet10>(binding, X, nearest.point, Vector3d::Constant(0.25)); break;
    }
    binding.offset = rest_m - nearest.point;
    return binding;
}

Vector3d marker_position(const MarkerBinding& binding, const Eigen::Matrix3Xd& x) {
    const Vector3d surface = x * binding.weights;
    if (on_surface(binding)) return surface + binding.offset;
    return surface + material::polar_rotation(Eigen::Matrix3d(x * binding.gradient)) * binding.offset;
}

Vector3d marker_tangent(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& dx) {
    const Vector3d surface = dx * binding.weights;
    if (on_surface(binding)) return surface;
    const Matrix3d F = x * binding.gradient;
    const Matrix3d dF = dx * binding.gradient;
    const Eigen::Matrix<double, 9, 1> dR = material::polar_rotation_derivative(F, material::polar_rotation(F)) *
                                           Eigen::Map<const Eigen::Matrix<double, 9, 1>>(dF.data());
    return surface + Eigen::Map<const Matrix3d>(dR.data()) * binding.offset;
}

Eigen::Matrix3Xd marker_pull(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Vector3d& pull) {
    const Eigen::Matrix3Xd surface = pull * binding.weights.transpose();
    if (on_surface(binding)) return surface;
    const Matrix3d F = x * binding.gradient;
    const Matrix3d on_rotation = pull * binding.offset.transpose();
    const Eigen::Matrix<double, 9, 1> on_F = material::polar_rotation_derivative(F, material::polar_rotation(F))
                                                 .transpose() *
                                             Eigen::Map<const Eigen::Matrix<double, 9, 1>>(on_rotation.data());
    return surface + Eigen::Map<const Matrix3d>(on_F.data()) * binding.gradient.transpose();
}

}  // namespace myo::measurement
