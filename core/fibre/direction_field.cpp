#include "fibre/direction_field.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <cassert>

#include "fibre/cell_parts.hpp"
#include "mesh/cell_traits.hpp"

namespace myo::fibre {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using Dyads = Eigen::Matrix<double, Eigen::Dynamic, 6>;  // per row xx, yy, zz, xy, yz, zx

Vector3d centre(const mesh::VolumeMesh& mesh, Index cell) {
    return place_of(mesh, static_cast<int>(cell), whole_cell(mesh.type)).centre_m;
}

/// Dyad d d' as six components.
Eigen::Matrix<double, 1, 6> packed(const Vector3d& d) {
    return {d(0) * d(0), d(1) * d(1), d(2) * d(2), d(0) * d(1), d(1) * d(2), d(2) * d(0)};
}

/// Symmetric matrix from six components.
Matrix3d unpacked(const Eigen::Matrix<double, 1, 6>& v) {
    Matrix3d D;
    D << v(0), v(3), v(5), v(3), v(1), v(4), v(5), v(4), v(2);
    return D;
}

/// Stiffness matrix of the Laplacian: sum over cells of grad N_a . grad N_b dV, n x n.
Eigen::SparseMatrix<double> laplacian(const mesh::VolumeMesh& mesh) {
    FibreGroup points;  // for its gradients and volumes
    std::vector<Eigen::Triplet<double>> entries;
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        points.points.clear();
        points.gradients.clear();
        add_whole_cell(
            mesh, c, 1.0, [](const Vector3d&) -> Vector3d { return Vector3d::UnitX(); }, points);
        for (std::size_t k = 0; k < points.points.size(); ++k) {
            const Eigen::MatrixXd part = points.points[k].volume * points.gradients[k] *
                                         points.gradients[k].transpose();
            for (Index a = 0; a < part.rows(); ++a)
                for (Index b = 0; b < part.cols(); ++b)
                    entries.emplace_back(mesh.cells(a, c), mesh.cells(b, c), part(a, b));
        }
    }
    Eigen::SparseMatrix<double> K(mesh.node_count(), mesh.node_count());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

/// Dirichlet values: the mean dyad of the given cells at each of their nodes; count > 0 marks given nodes.
struct GivenNodes {
    Dyads dyads;
    Eigen::VectorXd count;

    GivenNodes(const mesh::VolumeMesh& mesh, const std::vector<int>& cells, const Matrix3Xd& directions)
        : dyads(Dyads::Zero(mesh.node_count(), 6)), count(Eigen::VectorXd::Zero(mesh.node_count())) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            for (const int n : mesh.cells.col(cells[i])) {
                dyads.row(n) += packed(directions.col(static_cast<Index>(i)));
                count(n) += 1.0;
            }
        for (Index n = 0; n < count.size(); ++n)
            if (count(n) > 0.0) dyads.row(n) /= count(n);
    }
    Eigen::Matrix<double, 1, 6> mean() const { return dyads.colwise().sum() / (count.array() > 0.0).count(); }
};

/// Solves K D = 0 at the free nodes with given values at the others.
Dyads harmonic(Eigen::SparseMatrix<double> K, const GivenNodes& given) {
    Dyads right = Dyads::Zero(given.dyads.rows(), 6);
    const double weak = 1e-12 * K.diagonal().mean();  // regularisation: components without given nodes take the mean
    for (Index column = 0; column < K.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry) {
            const bool row_given = given.count(entry.row()) > 0.0, column_given = given.count(column) > 0.0;
            if (column_given && !row_given) right.row(entry.row()) -= entry.value() * given.dyads.row(column);
            // Rows and columns of given nodes become identity, which keeps the matrix symmetric for the LDL'
            // factorisation.
            if (row_given || column_given)
                entry.valueRef() = entry.row() == column ? 1.0 : 0.0;
            else if (entry.row() == column)
                entry.valueRef() += weak;
        }
    for (Index n = 0; n < right.rows(); ++n) {
        if (given.count(n) > 0.0)
            right.row(n) = given.dyads.row(n);
        else
            right.row(n) += weak * given.mean();
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
    return factor.solve(right);
}

}  // namespace

Matrix3Xd constant_directions(const mesh::VolumeMesh& mesh, const Vector3d& direction) {
    return direction.replicate(1, mesh.cell_count());
}

Matrix3Xd directions_along(const mesh::VolumeMesh& mesh, const Polyline& line) {
    Matrix3Xd directions(3, mesh.cell_count());
    for (Index c = 0; c < mesh.cell_count(); ++c) directions.col(c) = beside_line(line, centre(mesh, c)).tangent;
    return directions;
}

Matrix3Xd directions_along_longest_axis(const mesh::VolumeMesh& mesh, const Eigen::VectorXd& weights) {
    assert(weights.size() == 0 || weights.size() == mesh.cell_count());
    double volume = 0.0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
    const int corners = mesh::cell_traits(mesh.type).corners;
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        const double own = (weights.size() > 0 ? weights(c) : 1.0) * place_of(mesh, c, whole_cell(mesh.type)).volume_m3;
        const Matrix3Xd X = mesh.nodes(Eigen::all, mesh.cells.col(c).head(corners));
        const Vector3d centroid = X.rowwise().mean();
        volume += own;
        first += own * centroid;
        // Exact for tetrahedra and parallelepipeds.
        second += own * (X * X.transpose() + 16.0 * centroid * centroid.transpose()) / (corners + 16);
    }
    if (!(volume > 0.0)) return constant_directions(mesh, Vector3d::UnitX());
    return constant_directions(mesh, mean_line(second - first * first.transpose() / volume));
}

Matrix3Xd smooth_directions(const mesh::VolumeMesh& mesh, const std::vector<int>& cells, const Matrix3Xd& directions) {
    assert(!cells.empty() && directions.cols() == static_cast<Index>(cells.size()));
    const Dyads at_nodes = harmonic(laplacian(mesh), GivenNodes(mesh, cells, directions));
    const int corners = mesh::cell_traits(mesh.type).corners;
    Matrix3Xd field(3, mesh.cell_count());
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        Eigen::Matrix<double, 1, 6> sum = Eigen::Matrix<double, 1, 6>::Zero();
        for (int a = 0; a < corners; ++a) sum += at_nodes.row(mesh.cells(a, c));
        field.col(c) = mean_line(unpacked(sum));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) field.col(cells[i]) = directions.col(static_cast<Index>(i));
    return field;
}

}  // namespace myo::fibre
