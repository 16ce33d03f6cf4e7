#pragma once

#include <Eigen/Core>

#include <cassert>
#include <type_traits>

#include "mesh/cells.hpp"
#include "model/model.hpp"

namespace myo::model {

/// Nodal vectors of a cell, one coordinate per column: dot products over the nodes are then contiguous.
template <int N>
using CellVectors = Eigen::Matrix<double, N, 3>;

/// Columns of X (3 x n) at the nodes of a cell.
template <int N>
CellVectors<N> cell_vectors(const Eigen::MatrixXi& cells, int cell, const Eigen::Matrix3Xd& X) {
    CellVectors<N> result;
    for (int a = 0; a < N; ++a) result.row(a) = X.col(cells(a, cell)).transpose();
    return result;
}

/// Shape vector of a fibre point with compile-time size; asserts the size.
template <int N>
Eigen::Map<const Eigen::Matrix<double, N, 1>> shape_of(const fibre::FibrePoint& point) {
    assert(point.shape.size() == N);
    return Eigen::Map<const Eigen::Matrix<double, N, 1>>(point.shape.data());
}

/// Calls visit(nodes per cell, group, first, last) for each run of fibre points of one group in one cell. The number of
/// nodes is passed as std::integral_constant, so that loops over nodes unroll.
template <class Visit>
void for_each_fibre_cell(const Model& model, const Visit& visit) {
    const auto all = [&](auto nodes) {
        for (std::size_t g = 0; g < model.fibres->size(); ++g) {
            const std::vector<fibre::FibrePoint>& points = (*model.fibres)[g].points;
            for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
                while (last < points.size() && points[last].cell == points[first].cell) ++last;
                visit(nodes, g, first, last);
            }
        }
    };
    mesh::with_cell(model.body->mesh.type,
                    [&](auto cell) { all(std::integral_constant<int, decltype(cell)::nodes>{}); });
}

}  // namespace myo::model
