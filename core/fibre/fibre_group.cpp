#include "fibre/fibre_group.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>

#include "fem/reference_coordinates.hpp"
#include "fibre/cell_parts.hpp"
#include "mesh/cell_hex8.hpp"
#include "mesh/region.hpp"

namespace myo::fibre {
namespace {

/// True if the cell is an axis-aligned brick; returns it.
bool axis_aligned(const mesh::VolumeMesh& mesh, int cell, Box& box) {
    box = {mesh.nodes.col(mesh.cells(0, cell)), mesh.nodes.col(mesh.cells(6, cell))};
    const Eigen::Vector3d size = box.size();
    for (int a = 0; a < 8; ++a) {
        const Eigen::Vector3d xi = 0.5 * (mesh::Hex8::corners().row(a).transpose() + Eigen::Vector3d::Ones());
        const Eigen::Vector3d expected = box.lowest + xi.cwiseProduct(size);
        if ((mesh.nodes.col(mesh.cells(a, cell)) - expected).norm() > 1e-9 * size.norm()) return false;
    }
    return size.minCoeff() > 0.0;
}

/// Intersection of an axis-aligned cell with the box: a brick in reference coordinates, integrated by its own 2 x 2 x 2
/// Gauss points.
void add_box_cell(const mesh::VolumeMesh& mesh, int cell, const Box& cell_box, const Box& box,
                  const Eigen::Vector3d& direction, FibreGroup& group) {
    const Eigen::Vector3d size = cell_box.size();
    const Eigen::Vector3d low = ((box.lowest.cwiseMax(cell_box.lowest) - cell_box.lowest).array() / size.array())
                                    .matrix();
    const Eigen::Vector3d high = ((box.highest.cwiseMin(cell_box.highest) - cell_box.lowest).array() / size.array())
                                     .matrix();
    const Eigen::Vector3d part = high - low;
    if (part.minCoeff() <= 1e-9) return;
    for (mesh::QuadraturePoint point : mesh::hex_gauss(2)) {
        const Eigen::Vector3d unit = 0.5 * (point.xi + Eigen::Vector3d::Ones());
        point.xi = 2.0 * (low + part.cwiseProduct(unit)) - Eigen::Vector3d::Ones();
        add_fibre_point(mesh, cell, point.xi, 0.125 * point.weight * (part.cwiseProduct(size)).prod(), direction,
                        group);
    }
}

/// Four points of equal weight with the centre and second moments of a volume: integrates quadratic functions of
/// position exactly. For a complete tetrahedron these are the points of the standard rule.
Eigen::Matrix<double, 3, 4> points_of(const mesh::ClippedVolume& part) {
    const Eigen::Vector3d centre = part.centre_m();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(part.second_moment_m5 / part.volume_m3 -
                                                              centre * centre.transpose());
    Eigen::Matrix<double, 3, 4> corners;
    corners << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
    return (axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() * corners).colwise() +
           centre;
}

/// Part of a cell inside a box. A group that ends inside cells keeps its lever arm and bending stiffness.
void add_cut_cell(const mesh::VolumeMesh& mesh, int cell, const Box& box, const Eigen::Vector3d& direction,
                  FibreGroup& group) {
    const mesh::ClippedVolume part = mesh::cell_in_box(mesh, cell, box, mesh::region_tolerance(mesh));
    if (!(part.volume_m3 > 0.0)) return;
    const auto add = [&](const Eigen::Vector3d& x, double volume_m3) {
        add_fibre_point(mesh, cell, fem::reference_coordinates(mesh, cell, x), volume_m3, direction, group);
    };
    if (mesh.type == mesh::CellType::tet4) return add(part.centre_m(), part.volume_m3);  // constant strain in the cell
    const Eigen::Matrix<double, 3, 4> points = points_of(part);
    for (int k = 0; k < 4; ++k) add(points.col(k), 0.25 * part.volume_m3);
}

struct FibreGroupPolicy {
    /// Above this fraction a cell counts as whole and uses its own quadrature points.
    double uncut = 1.0 - 1e-6;
};
constexpr FibreGroupPolicy fibre_group_policy;

}  // namespace

double FibreGroup::volume() const {
    double sum = 0.0;
    for (const FibrePoint& point : points) sum += point.volume;
    return sum;
}

Eigen::Vector3d direction_of(const FibreGroup& group, std::size_t point) {
    assert(group.gradients.size() == group.points.size());
    const auto& gradient = group.gradients[point];
    return (gradient.transpose() * gradient).ldlt().solve(gradient.transpose() * group.points[point].shape);
}

FibreGroup fibres_in_box(const mesh::VolumeMesh& mesh, const Box& box, const Eigen::Vector3d& direction,
                         double stiffness_Pa, std::string name) {
    FibreGroup group{std::move(name), stiffness_Pa, {}, {}};
    const Eigen::VectorXd fraction = mesh::volume_fractions(mesh, box);
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        if (fraction(c) <= 0.0) continue;
        Box cell_box;
        if (mesh.type == mesh::CellType::hex8 && axis_aligned(mesh, c, cell_box))
            add_box_cell(mesh, c, cell_box, box, direction, group);
        else if (fraction(c) < fibre_group_policy.uncut)
            add_cut_cell(mesh, c, box, direction, group);
        else
            add_whole_cell(
                mesh, c, fraction(c), [&](const Eigen::Vector3d&) { return direction; }, group);
    }
    return group;
}

FibreResponse fibre_response(const Eigen::Vector3d& s, double activation, double stiffness_Pa) {
    const double length = s.norm();
    const Eigen::Vector3d unit = s / length;
    const double ratio = activation / length;
    FibreResponse response;
    response.energy = 0.5 * stiffness_Pa * (length - activation) * (length - activation);
    response.gradient = stiffness_Pa * (length - activation) * unit;
    response.hessian = stiffness_Pa * ((1.0 - ratio) * Eigen::Matrix3d::Identity() + ratio * unit * unit.transpose());
    response.gradient_activation = -stiffness_Pa * unit;
    return response;
}

}  // namespace myo::fibre
