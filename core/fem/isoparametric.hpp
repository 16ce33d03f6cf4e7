#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <cassert>
#include <vector>

#include "fem/element_block.hpp"
#include "mesh/cells.hpp"

namespace myo::fem {

/// Isoparametric elements with the Q points of a rule.
/// @param mean_volume  the volume measure is averaged over each cell
template <class Cell, int Q>
ElementBlock<Cell::nodes, Q> gauss_block(const mesh::VolumeMesh& mesh, const std::vector<mesh::QuadraturePoint>& rule,
                                         bool mean_volume) {
    constexpr int N = Cell::nodes;
    assert(rule.size() == Q);
    ElementBlock<N, Q> block;
    block.mean_volume = mean_volume;
    block.cells = mesh.cells;
    block.geometry.resize(static_cast<std::size_t>(mesh.cell_count()));
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto X = mesh::cell_nodes<Cell>(mesh, c);
        auto& geometry = block.geometry[static_cast<std::size_t>(c)];
        for (std::size_t q = 0; q < Q; ++q) {
            const Eigen::Matrix<double, N, 3> D = Cell::derivatives(rule[q].xi);
            const Eigen::Matrix3d jacobian = X * D;  // dX/dxi
            geometry.gradient[q] = D * jacobian.inverse();
            geometry.weight[q] = rule[q].weight * jacobian.determinant();
            geometry.volume += geometry.weight[q];
        }
    }
    return block;
}

/// Consistent mass of all cells by Cell::mass_rule(), see consistent_mass().
template <class Cell>
std::vector<MassEntry> consistent_mass_of(const mesh::VolumeMesh& mesh) {
    constexpr int N = Cell::nodes;
    const std::vector<mesh::QuadraturePoint> rule = Cell::mass_rule();
    std::vector<MassEntry> entries;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto X = mesh::cell_nodes<Cell>(mesh, c);
        Eigen::Matrix<double, N, N> M = Eigen::Matrix<double, N, N>::Zero();
        for (const mesh::QuadraturePoint& point : rule) {
            const Eigen::Matrix<double, N, 1> values = Cell::values(point.xi);
            const Eigen::Matrix3d jacobian = X * Cell::derivatives(point.xi);
            M += point.weight * jacobian.determinant() * values * values.transpose();
        }
        for (int b = 0; b < N; ++b)
            for (int a = 0; a < N; ++a)
                entries.push_back({mesh.cells(a, c), mesh.cells(b, c), M(a, b), static_cast<int>(c)});
    }
    return entries;
}

}  // namespace myo::fem
