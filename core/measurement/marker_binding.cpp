#include "measurement/marker_binding.hpp"

#include <Eigen/LU>

#include <algorithm>

#include "fem/reference_coordinates.hpp"
#include "material/polar.hpp"

namespace myo::measurement {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Shape functions and gradients dN/dX at a point of the cell.
template <class Shape>
void set_shape(MarkerBinding& binding, const Eigen::Matrix3Xd& X, const Vector3d& point) {
    const Vector3d xi = fem::reference_coordinates<Shape>(X, point);
    const auto D = Shape::derivatives(xi);
    binding.weights = Shape::values(xi);
    // dN/dX = dN/dxi (dX/dxi)^-1.
    binding.gradient = D * (X * D).inverse();
}

/// An offset below 1e-9 m is rounding of the rest position; the marker then does not need the rotation.
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
    mesh::with_cell(mesh.type, [&]<class Shape>(Shape) { set_shape<Shape>(binding, X, nearest.point); });
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
    // dR = dR/dF : dF, both 3 x 3 matrices stored as vectors of 9.
    const Eigen::Matrix<double, 9, 1> dR = material::polar_rotation_derivative(F, material::polar_rotation(F)) *
                                           Eigen::Map<const Eigen::Matrix<double, 9, 1>>(dF.data());
    return surface + Eigen::Map<const Matrix3d>(dR.data()) * binding.offset;
}

Eigen::Matrix3Xd marker_pull(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Vector3d& pull) {
    const Eigen::Matrix3Xd surface = pull * binding.weights.transpose();
    if (on_surface(binding)) return surface;
    // Adjoint of surface + R(F) offset: the adjoint of R is pull offset', that of F follows with dR/dF transposed, and
    // that of x with the shape gradients.
    const Matrix3d F = x * binding.gradient;
    const Matrix3d on_rotation = pull * binding.offset.transpose();
    const Eigen::Matrix<double, 9, 1> on_F = material::polar_rotation_derivative(F, material::polar_rotation(F))
                                                 .transpose() *
                                             Eigen::Map<const Eigen::Matrix<double, 9, 1>>(on_rotation.data());
    return surface + Eigen::Map<const Matrix3d>(on_F.data()) * binding.gradient.transpose();
}

}  // namespace myo::measurement
