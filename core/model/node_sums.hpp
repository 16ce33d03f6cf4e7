#pragma once

#include <Eigen/Core>

#include "base/parallel.hpp"
#include "model/packed_cells.hpp"

namespace myo::model {

struct NodeSumsPolicy {
    int nodes_per_thread = 1000;  // smallest range worth a separate thread
};
inline constexpr NodeSumsPolicy node_sums_policy;

/// Sums the nodal vectors of the cells at the nodes, in the order of the incidence: bitwise independent of the number
/// of threads.
/// @param field  vectors per cell and node, see NodeIncidence
/// @param nodal  3 x n, possibly a block of a larger matrix; increased
template <class Rows>
void add_at_nodes(const NodeIncidence& incidence, const double* field, Rows&& nodal) {
    parallel_ranges(static_cast<int>(nodal.cols()), node_sums_policy.nodes_per_thread, [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            double x = 0.0, y = 0.0, z = 0.0;
            for (int k = incidence.start[static_cast<std::size_t>(i)];
                 k < incidence.start[static_cast<std::size_t>(i) + 1]; ++k) {
                const double* at = field + incidence.offset[static_cast<std::size_t>(k)];
                x += at[0];
                y += at[pack_width];
                z += at[2 * pack_width];
            }
            nodal.col(i) += Eigen::Vector3d(x, y, z);
        }
    });
}

}  // namespace myo::model
