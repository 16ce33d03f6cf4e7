#include "model/nodal_rotations.hpp"

#include "material/polar.hpp"
#include "model/cell_kernel.hpp"

namespace myo {
namespace {

using Rotations = Eigen::Matrix<double, 9, Eigen::Dynamic>;

template <int N, int Q>
Rotations mean_gradients(const PackedCells<N, Q>& cells, const Body& body, const Eigen::Matrix3Xd& x) {
    Rotations sum = Rotations::Zero(9, body.node_count());
    for (int pack = 0; pack < cells.pack_count(); ++pack) {
        const auto& nodes = cells.lane_nodes[static_cast<std::size_t>(pack)];
        const PackGeometry<N, Q>& geometry = cells.geometry[static_cast<std::size_t>(pack)];
        const auto xe = gather_lanes<N>(nodes, x);
        Matrix3<Pack> mean = Matrix3<Pack>::Constant(Pack(0.0));
        for (std::size_t q = 0; q < Q; ++q) mean += deformation_gradient<N>(xe, geometry.gradient[q]) * geometry.weight[q];
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(cells.lanes_used(pack)); ++lane)
            for (const auto& node : nodes)
                for (int k = 0; k < 9; ++k) sum(k, node[lane]) += mean(k % 3, k / 3)[lane];
    }
    return sum;
}

}  // namespace

Rotations nodal_rotations(const Body& body, const Eigen::Matrix3Xd& x) {
    Rotations field = std::visit([&](const auto& cells) { return mean_gradients(cells, body, x); }, body.cells);
    const Eigen::Index count = field.cols();
    for (Eigen::Index first = 0; first < count; first += pack_width) {
        const auto column = [&](auto lane) { return std::min(first + static_cast<Eigen::Index>(lane), count - 1); };
        Matrix3<Pack> F;
        Pack size = 0.0;
        for (int k = 0; k < 9; ++k) {
            F(k % 3, k / 3) = Pack([&](auto lane) { return field(k, column(lane)); });
            size += F(k % 3, k / 3) * F(k % 3, k / 3);
        }
        F *= 1.0 / sqrt((1.0 / 3.0) * size);
        const PackMask degenerate = !(size > 1e-300) || !(size < 1e300);   // nothing to turn, or not a number
        for (int k = 0; k < 9; ++k) std::experimental::where(degenerate, F(k % 3, k / 3)) = k % 4 == 0 ? 1.0 : 0.0;
        const Matrix3<Pack> R = polar_rotation(F);
        for (Eigen::Index i = first; i < std::min(first + pack_width, count); ++i)
            for (int k = 0; k < 9; ++k) field(k, i) = R(k % 3, k / 3)[static_cast<std::size_t>(i - first)];
    }
    return field;
}

}  // namespace myo
