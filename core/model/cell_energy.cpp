#include "model/cell_energy.hpp"

#include <algorithm>
#include <cassert>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"

namespace myo {
namespace {

template <int N, int Q>
Eigen::VectorXd densities_of(const PackedCells<N, Q>& cells, const Model& model, const Eigen::Matrix3Xd& x) {
    Eigen::VectorXd result(cells.cell_count);
    parallel_ranges(cells.pack_count(), 24, [&](int first, int end) {
        PackOutput<N> out;
        for (int pack = first; pack < end; ++pack) {
            PackInput in;   // without a bulk modulus: the energy is linear in both
            in.material = model.material.get();
            in.elastic = true;
            in.mu = Pack([&](auto lane) {
                return model.moduli[static_cast<std::size_t>(std::min(pack * pack_width + static_cast<int>(lane), cells.cell_count - 1))].mu;
            });
            evaluate_pack<false>(cells, pack, gather_lanes<N>(cells.lane_nodes[static_cast<std::size_t>(pack)], x), in, out);
            const Pack density = out.energy / cells.geometry[static_cast<std::size_t>(pack)].volume;
            for (int lane = 0; lane < cells.lanes_used(pack); ++lane) result(pack * pack_width + lane) = density[static_cast<std::size_t>(lane)];
        }
    });
    return result;
}

}  // namespace

Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x) {
    assert(x.cols() == model.body->node_count());
    return std::visit([&](const auto& cells) { return densities_of(cells, model, x); }, model.body->cells);
}

}  // namespace myo
