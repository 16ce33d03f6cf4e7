#include "model/fibre_forces.hpp"

#include <array>

#include "model/fibre_cells.hpp"
#include "model/positive_part.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

template <int N>
void add_at_nodes(const Eigen::MatrixXi& cells, int cell, const CellVectors<N>& forces, Matrix3Xd& nodal) {
    for (int a = 0; a < N; ++a) nodal.col(cells(a, cell)) += forces.row(a).transpose();
}

/// The matrix of one cell, N x N per pair of coordinates (rr, rs with r < s).
template <int N>
struct CellMatrix {
    std::array<Eigen::Matrix<double, N, N>, 6> part;
    static constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

    void clear() {
        for (auto& p : part) p.setZero();
    }

    template <class Shape>
    void add(const Shape& shape, const Eigen::Matrix3d& H) {
        const Eigen::Matrix<double, N, N> products = shape * shape.transpose();
        for (std::size_t k = 0; k < 6; ++k) part[k] += H(pairs[k][0], pairs[k][1]) * products;
    }

    void assemble(const Body& body, int cell, SymmetricSparse& matrix) const {
        for (int b = 0; b < N; ++b)
            for (int a = b; a < N; ++a) {
                Eigen::Matrix3d block;
                for (std::size_t k = 0; k < 6; ++k) block(pairs[k][0], pairs[k][1]) = block(pairs[k][1], pairs[k][0]) = part[k](a, b);
                const bool stored = body.pattern.stores(N, cell, a, b);
                body.pattern.add(matrix, body.mesh.cells, cell, stored ? a : b, stored ? b : a, block);
            }
    }
};

}  // namespace

void add_fibres(const Model& model, const Matrix3Xd& x, const std::vector<double>& activation, HessianKind kind, InternalEnergy& out) {
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_cell(model, [&](auto nodes, std::size_t g, std::size_t first, std::size_t last) {
        constexpr int N = decltype(nodes)::value;
        const FibreGroup& group = (*model.fibres)[g];
        const int cell = group.points[first].cell;
        const CellVectors<N> xe = cell_vectors<N>(cells, cell, x);
        CellVectors<N> forces = CellVectors<N>::Zero();
        CellMatrix<N> matrix;
        if (kind != HessianKind::none) matrix.clear();
        for (std::size_t k = first; k < last; ++k) {
            const auto shape = shape_of<N>(group.points[k]);
            const Vector3d s = xe.transpose() * shape;
            const double volume = group.points[k].volume, length = s.norm(), stretch = length - activation[g];
            const double stiffness = volume * group.stiffness_Pa;
            out.energy += 0.5 * stiffness * stretch * stretch;
            forces += shape * (stiffness * stretch / length * s).transpose();
            if (kind == HessianKind::none) continue;
            Eigen::Matrix3d hessian = volume * fibre_response(s, activation[g], group.stiffness_Pa).hessian;
            if (kind != HessianKind::exact) project_positive(hessian);
            matrix.add(shape, hessian);
        }
        add_at_nodes<N>(cells, cell, forces, out.gradient);
        if (kind != HessianKind::none) matrix.assemble(*model.body, cell, out.hessian);
    });
}

Matrix3Xd activation_gradient(const Model& model, const Matrix3Xd& x, const std::vector<double>& activation,
                              const std::vector<double>& d_activation) {
    Matrix3Xd gradient = Matrix3Xd::Zero(3, x.cols());
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_cell(model, [&](auto nodes, std::size_t g, std::size_t first, std::size_t last) {
        constexpr int N = decltype(nodes)::value;
        const FibreGroup& group = (*model.fibres)[g];
        const int cell = group.points[first].cell;
        const CellVectors<N> xe = cell_vectors<N>(cells, cell, x);
        CellVectors<N> forces = CellVectors<N>::Zero();
        for (std::size_t k = first; k < last; ++k) {
            const auto shape = shape_of<N>(group.points[k]);
            const FibreResponse response = fibre_response(xe.transpose() * shape, activation[g], group.stiffness_Pa);
            forces += shape * (d_activation[g] * group.points[k].volume * response.gradient_activation).transpose();
        }
        add_at_nodes<N>(cells, cell, forces, gradient);
    });
    return gradient;
}

}  // namespace myo
