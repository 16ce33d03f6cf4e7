#include "model/fibre_forces.hpp"

#include <algorithm>
#include <array>

#include "base/pack.hpp"
#include "model/cell_blocks.hpp"
#include "model/fibre_cells.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;

/// Adds the nodal forces of a cell to those of the body.
template <int N>
void add_at_nodes(const Eigen::MatrixXi& cells, int cell, const CellVectors<N>& forces, Matrix3Xd& nodal) {
    for (int a = 0; a < N; ++a) nodal.col(cells(a, cell)) += forces.row(a).transpose();
}

/// Consecutive fibre points of one cell, one per lane.
template <int N>
struct FibreLanes {
    int first = 0, count = 0;  // lanes from count on repeat the last point with zero volume
    std::array<Pack, 3> s;     // F m, current fibre vector
    Pack length, stiffness;    // |s|; volume times w
};

/// Calls visit(lanes) for the points first ... last - 1, pack_width at a time.
template <int N, class Visit>
void for_each_fibre_lanes(const fibre::FibreGroup& group, std::size_t first, std::size_t last, const CellVectors<N>& xe,
                          const Visit& visit) {
    for (std::size_t k = first; k < last; k += static_cast<std::size_t>(pack_width)) {
        FibreLanes<N> lanes;
        lanes.first = static_cast<int>(k);
        lanes.count = static_cast<int>(std::min(last - k, static_cast<std::size_t>(pack_width)));
        // The last point is repeated in unused lanes, which keeps them finite.
        const auto point = [&](auto lane) -> const fibre::FibrePoint& {
            return group.points[std::min(k + lane, last - 1)];
        };
        for (int r = 0; r < 3; ++r)
            lanes.s[static_cast<std::size_t>(r)] = Pack(
                [&](auto lane) { return shape_of<N>(point(lane)).dot(xe.col(r)); });
        lanes.length = sqrt(lanes.s[0] * lanes.s[0] + lanes.s[1] * lanes.s[1] + lanes.s[2] * lanes.s[2]);
        lanes.stiffness = Pack([&](auto lane) {
            return static_cast<int>(lane) < lanes.count ? group.stiffness_Pa * point(lane).volume : 0.0;
        });
        visit(lanes);
    }
}

/// forces += shape * scale * s' for each point.
template <int N>
void add_along_fibres(const fibre::FibreGroup& group, const FibreLanes<N>& lanes, const Pack& scale,
                      CellVectors<N>& forces) {
    for (int r = 0; r < 3; ++r) {
        const Pack along = scale * lanes.s[static_cast<std::size_t>(r)];
        for (int k = 0; k < lanes.count; ++k)
            forces.col(r) += static_cast<double>(along[static_cast<std::size_t>(k)]) *
                             shape_of<N>(group.points[static_cast<std::size_t>(lanes.first + k)]);
    }
}

/// Stiffness of one cell by pairs of coordinates (rr, then rs with r < s), N x N each.
template <int N>
struct CellMatrix {
    std::array<Eigen::Matrix<double, N, N>, 6> part;
    static constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

    void clear() {
        for (auto& p : part) p.setZero();
    }

    /// Adds the second derivatives of the points: stiffness (across (I - n n') + n n') with n = s / |s|.
    void add(const fibre::FibreGroup& group, const FibreLanes<N>& lanes, const Pack& across) {
        std::array<Pack, 6> H;
        // n n' = s s' / |s|^2: the projector is formed without normalising s.
        const Pack along = lanes.stiffness * (1.0 - across) / (lanes.length * lanes.length);
        for (std::size_t k = 0; k < 6; ++k) {
            const auto [r, s] = pairs[k];
            H[k] = along * lanes.s[static_cast<std::size_t>(r)] * lanes.s[static_cast<std::size_t>(s)];
            if (r == s) H[k] += lanes.stiffness * across;
        }
        for (std::size_t k = 0; k < 6; ++k)  // one part at a time: it stays in registers
            for (int point = 0; point < lanes.count; ++point) {
                const auto shape = shape_of<N>(group.points[static_cast<std::size_t>(lanes.first + point)]);
                part[k] += shape * (static_cast<double>(H[k][static_cast<std::size_t>(point)]) * shape).transpose();
            }
    }

    /// Adds the matrix to that of the body. Fibres are assembled one after the other, so this call owns all columns.
    void assemble(const Body& body, int cell, solver::SymmetricSparse& matrix) const {
        const CellBlocks<N> blocks(body.pattern, body.mesh.cells, cell, {0, body.pattern.free_count}, matrix);
        // Index of the pair (r, s) in the packed symmetric storage.
        constexpr std::size_t of[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
        for (int b = 0; b < N; ++b)
            for (int a = b; a < N; ++a) blocks.add(a, b, [&](int r, int s) { return part[of[r][s]](a, b); });
    }
};

}  // namespace

void add_fibres(const Model& model, const Matrix3Xd& x, const std::vector<double>& activation, HessianKind kind,
                InternalEnergy& out) {
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_cell(model, [&](auto nodes, std::size_t g, std::size_t first, std::size_t last) {
        constexpr int N = decltype(nodes)::value;
        const fibre::FibreGroup& group = (*model.fibres)[g];
        const int cell = group.points[first].cell;
        const CellVectors<N> xe = cell_vectors<N>(cells, cell, x);
        CellVectors<N> forces = CellVectors<N>::Zero();
        CellMatrix<N> matrix;
        if (kind != HessianKind::none) matrix.clear();
        for_each_fibre_lanes<N>(group, first, last, xe, [&](const FibreLanes<N>& lanes) {
            // Energy w/2 (|s| - a)^2: the force along the fibre is w (|s| - a), and (|s| - a) / |s| of w acts across
            // it.
            const Pack stretch = lanes.length - activation[g], relative = stretch / lanes.length;
            out.energy += reduce(0.5 * lanes.stiffness * stretch * stretch);
            add_along_fibres<N>(group, lanes, lanes.stiffness * relative, forces);
            // A fibre shorter than its active length a is in compression and would buckle. Only the transverse
            // curvature can be negative, so clipping it gives the positive part.
            if (kind == HessianKind::exact)
                matrix.add(group, lanes, relative);
            else if (kind != HessianKind::none)
                matrix.add(group, lanes, max(relative, Pack(0.0)));
        });
        add_at_nodes<N>(cells, cell, forces, out.gradient);
        if (kind != HessianKind::none) matrix.assemble(*model.body, cell, out.hessian);
    });
}

Matrix3Xd activation_gradient(const Model& model, const Matrix3Xd& x, const std::vector<double>& d_activation) {
    Matrix3Xd gradient = Matrix3Xd::Zero(3, x.cols());
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_cell(model, [&](auto nodes, std::size_t g, std::size_t first, std::size_t last) {
        constexpr int N = decltype(nodes)::value;
        const fibre::FibreGroup& group = (*model.fibres)[g];
        const int cell = group.points[first].cell;
        const CellVectors<N> xe = cell_vectors<N>(cells, cell, x);
        CellVectors<N> forces = CellVectors<N>::Zero();
        // d psi/da = -w (|s| - a), so its gradient along s is -w s / |s| per unit of activation.
        for_each_fibre_lanes<N>(group, first, last, xe, [&](const FibreLanes<N>& lanes) {
            add_along_fibres<N>(group, lanes, -d_activation[g] * lanes.stiffness / lanes.length, forces);
        });
        add_at_nodes<N>(cells, cell, forces, gradient);
    });
    return gradient;
}

}  // namespace myo::model
