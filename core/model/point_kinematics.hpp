#pragma once

#include "model/pack_tensors.hpp"
#include "model/packed_cells.hpp"

namespace myo::model {

/// Index of block (a, b), a >= b, in the packed lower triangle of a cell's matrix, column by column.
template <int N>
constexpr int lower_block(int a, int b) {
    return b * N - b * (b - 1) / 2 + a - b;
}

/// 3 x 3 blocks of the symmetric matrix of a pack of cells, see lower_block().
template <int N>
using PackMatrix = std::array<material::Matrix3<Pack>, static_cast<std::size_t>(N*(N + 1) / 2)>;

// Kinematics of a pack of cells as functions of its nodes. Each element formulation specialises three templates for its
// geometry:
//
//   PointKinematics   gradient(q): F of a point; along(dx): a motion; tangent(q, motion): dF
//   StressSum         add(q, P): P = dW/dF of a point times its weight; add_to(forces): dW/dx
//   StiffnessSum      add(q, A, P): A = d2W/dF2 of a point times its weight, P its stress, for the curvature of F in x;
//                     finish(): d2W/dx2
//
// Energies, forces, works, strains and means are written once in terms of these.

template <class Geometry>
class PointKinematics;
template <class Geometry>
class StressSum;
template <class Geometry>
class StiffnessSum;

// Compatible elements: F is linear in x, so stress and stiffness need no geometric term of their own.

/// Kinematics of compatible elements; refers to geometry and nodes.
template <int N, int Q>
class PointKinematics<PackGeometry<N, Q>> {
public:
    using Motion = const PackNodes<N>*;

    PointKinematics(const PackGeometry<N, Q>& geometry, const PackSurroundings&, const PackNodes<N>& x, const Pack&)
        : geometry_(geometry), x_(x) {}

    /// Deformation gradient at point q.
    material::Matrix3<Pack> gradient(int q) const {
        return nodal_product(x_, geometry_.gradient[static_cast<std::size_t>(q)]);
    }
    /// Quadrature weight of point q [m3].
    Pack weight(int q) const { return geometry_.weight[static_cast<std::size_t>(q)]; }
    /// Shape gradients and weights of the pack.
    const PackGeometry<N, Q>& geometry() const { return geometry_; }

    /// F is linear in x, so a motion is the displacement itself.
    Motion along(const PackNodes<N>& dx) const { return &dx; }
    /// dF at point q.
    material::Matrix3<Pack> tangent(int q, Motion dx) const {
        return nodal_product(*dx, geometry_.gradient[static_cast<std::size_t>(q)]);
    }

private:
    const PackGeometry<N, Q>& geometry_;
    const PackNodes<N>& x_;
};

/// Nodal forces of compatible elements: each point adds P G'.
template <int N, int Q>
class StressSum<PackGeometry<N, Q>> {
public:
    explicit StressSum(const PointKinematics<PackGeometry<N, Q>>& points)
        : geometry_(points.geometry()), forces_(PackNodes<N>::Constant(Pack(0.0))) {}

    void add(int q, const material::Matrix3<Pack>& P) {
        add_nodal(P, geometry_.gradient[static_cast<std::size_t>(q)], forces_);
    }
    void add_to(PackNodes<N>& forces) const { forces += forces_; }

private:
    const PackGeometry<N, Q>& geometry_;
    PackNodes<N> forces_;
};

/// K_ab += weight G_a A G_b for a >= b: pull-back of a symmetric 9 x 9 tangent to the nodes.
template <int N>
void add_pulled_back(const material::Matrix9<Pack>& A, const Eigen::Matrix<Pack, N, 3>& G, const Pack& weight,
                     PackMatrix<N>& matrix) {
    for (int b = 0; b < N; ++b) {
        const Pack g0 = weight * G(b, 0), g1 = weight * G(b, 1), g2 = weight * G(b, 2);
        Eigen::Matrix<Pack, 9, 3> AG;
        for (int k = 0; k < 3; ++k)
            for (int row = 0; row < 9; ++row) AG(row, k) = A(row, k) * g0 + A(row, k + 3) * g1 + A(row, k + 6) * g2;
        for (int a = b; a < N; ++a) {
            material::Matrix3<Pack>& block = matrix[static_cast<std::size_t>(lower_block<N>(a, b))];
            for (int k = 0; k < 3; ++k)
                for (int i = 0; i < 3; ++i)
                    block(i, k) += G(a, 0) * AG(i, k) + G(a, 1) * AG(i + 3, k) + G(a, 2) * AG(i + 6, k);
        }
    }
}

/// Stiffness of compatible elements: each point adds G' A G.
template <int N, int Q>
class StiffnessSum<PackGeometry<N, Q>> {
public:
    /// Blocks are added to `matrix` immediately; finish() does nothing.
    StiffnessSum(const PointKinematics<PackGeometry<N, Q>>& points, PackMatrix<N>& matrix)
        : geometry_(points.geometry()), matrix_(matrix) {}

    void add(int q, const material::Matrix9<Pack>& A, const material::Matrix3<Pack>&) {
        add_pulled_back<N>(A, geometry_.gradient[static_cast<std::size_t>(q)], Pack(1.0), matrix_);
    }
    void finish() {}

private:
    const PackGeometry<N, Q>& geometry_;
    PackMatrix<N>& matrix_;
};

}  // namespace myo::model
