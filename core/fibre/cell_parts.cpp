#include "fibre/cell_parts.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/cells.hpp"

namespace myo::fibre {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct CellPartsPolicy {
    /// Depth at which samples are merged: a quarter of an edge.
    int block_depth = 2;
};
constexpr CellPartsPolicy cell_parts_policy;

/// Volume of a part in reference coordinates.
double reference_volume(const CellPart& part) {
    Matrix3d edges;
    if (part.corners.cols() == 8) return (part.corners.col(6) - part.corners.col(0)).prod();
    for (int i = 0; i < 3; ++i) edges.col(i) = part.corners.col(i + 1) - part.corners.col(0);
    return std::abs(edges.determinant()) / 6.0;
}

}  // namespace

CellPart whole_cell(mesh::CellType type) {
    CellPart part;
    part.corners = mesh::with_cell(type, [](auto shape) { return decltype(shape)::reference_corners(); });
    return part;
}

std::vector<CellPart> cut_in_eight(const CellPart& part) {
    std::vector<CellPart> children;
    const auto add = [&](const auto& corners) {
        const int block = part.depth < cell_parts_policy.block_depth
                              ? 8 * part.block + static_cast<int>(children.size())
                              : part.block;
        children.push_back({corners, part.depth + 1, block});
    };
    // Eight bricks, or four corner tetrahedra, scaled by 1/2 towards each corner.
    for (Eigen::Index i = 0; i < part.corners.cols(); ++i)
        add((0.5 * (part.corners.colwise() + part.corners.col(i))).eval());
    if (part.corners.cols() == 8) return children;
    // The remaining octahedron is divided along one of its diagonals.
    constexpr std::array<std::array<std::size_t, 4>, 4> inner{{{0, 2, 3, 4}, {0, 1, 2, 4}, {2, 1, 5, 4}, {2, 3, 4, 5}}};
    for (const auto& edges : inner) {
        Eigen::Matrix<double, 3, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [a, b] = mesh::tetrahedron_edges[edges[k]];
            corners.col(static_cast<Eigen::Index>(k)) = 0.5 * (part.corners.col(a) + part.corners.col(b));
        }
        add(corners);
    }
    return children;
}

PartPlace place_of(const mesh::VolumeMesh& mesh, int cell, const CellPart& part) {
    return mesh::with_cell(mesh.type, [&](auto shape) {
        using Shape = decltype(shape);
        const auto X = mesh::cell_nodes<Shape>(mesh, cell);
        const Vector3d xi = part.centre();
        PartPlace place;
        place.centre_m = X * Shape::values(xi);
        for (const Vector3d corner : part.corners.colwise()) {
            const Vector3d from_centre = X * Shape::values(corner) - place.centre_m;
            place.radius_m = std::max(place.radius_m, from_centre.norm());
            // Second moment from the corners, sum x x' / (n + 16): exact for tetrahedra (n + 16 = 20) and for
            // parallelepipeds (24).
            place.second_moment_m2 += from_centre * from_centre.transpose() /
                                      static_cast<double>(part.corners.cols() + 16);
        }
        place.volume_m3 = (X * Shape::derivatives(xi)).determinant() * reference_volume(part);
        return place;
    });
}

void add_fibre_point(const mesh::VolumeMesh& mesh, int cell, const Vector3d& xi, double volume_m3,
                     const Vector3d& direction, FibreGroup& group) {
    mesh::with_cell(mesh.type, [&](auto shape) {
        using Shape = decltype(shape);
        const Eigen::Matrix<double, Shape::nodes, 3> D = Shape::derivatives(xi);
        const Matrix3d jacobian = mesh::cell_nodes<Shape>(mesh, cell) * D;
        const Eigen::Matrix<double, Shape::nodes, 3> gradient = D * jacobian.inverse();
        group.points.push_back({cell, gradient * direction, volume_m3});
        group.gradients.emplace_back(gradient);
    });
}

void add_whole_cell(const mesh::VolumeMesh& mesh, int cell, double share,
                    const std::function<Vector3d(const Vector3d&)>& direction, FibreGroup& group) {
    mesh::with_cell(mesh.type, [&](auto shape) {
        using Shape = decltype(shape);
        const auto X = mesh::cell_nodes<Shape>(mesh, cell);
        for (const mesh::QuadraturePoint& point : Shape::strain_rule()) {
            const double volume = point.weight * (X * Shape::derivatives(point.xi)).determinant();
            add_fibre_point(mesh, cell, point.xi, share * volume, direction(X * Shape::values(point.xi)), group);
        }
    });
}

void add_samples(const mesh::VolumeMesh& mesh, int cell, const std::vector<FibreSample>& samples, FibreGroup& group) {
    struct Block {
        double volume = 0.0;
        Vector3d moment = Vector3d::Zero();
        Matrix3d dyads = Matrix3d::Zero();
    };
    std::array<Block, 64> blocks{};
    for (const FibreSample& sample : samples) {
        // A linear tetrahedron has constant strain: one point is exact.
        Block& block = blocks[mesh.type == mesh::CellType::tet4 ? 0u : static_cast<std::size_t>(sample.part.block)];
        block.volume += sample.volume_m3;
        block.moment += sample.volume_m3 * sample.part.centre();
        block.dyads += sample.volume_m3 * sample.direction * sample.direction.transpose();
    }
    for (const Block& block : blocks)
        if (block.volume > 0.0)
            add_fibre_point(mesh, cell, block.moment / block.volume, block.volume, mean_line(block.dyads), group);
}

Vector3d mean_line(const Matrix3d& sum_of_dyads) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(sum_of_dyads);
    Vector3d line = eigen.eigenvectors().col(2);
    // The sign of a line is arbitrary. One rule for all makes neighbouring cells comparable for the reader.
    Eigen::Index largest = 0;
    line.cwiseAbs().maxCoeff(&largest);
    return line(largest) < 0.0 ? Vector3d(-line) : line;
}

}  // namespace myo::fibre
