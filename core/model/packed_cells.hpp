#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "base/pack.hpp"
#include "fem/element_block.hpp"

namespace myo {

/// Shape gradients and weights of as many cells as a pack has lanes.
template <int N, int Q>
struct PackGeometry {
    std::array<Eigen::Matrix<Pack, N, 3>, Q> gradient;   // [1/m]
    std::array<Pack, Q> weight;                          // [m3]
    Pack volume;
};

/// See HourglassGeometry.
struct PackHourglass {
    Eigen::Matrix<Pack, 8, 4> gamma;
    Eigen::Matrix<Pack, 3, 3> frame;
    std::array<Pack, 3> half_length;
};

/// An element block laid out for the vectorised kernel. Cell c is lane c % pack_width of pack c / pack_width; the last pack is
/// filled up with copies of the last cell, whose results nobody reads.
///
/// Per-cell fields (strains, pressures, forces) are stored pack by pack: entry i of cell c is at
/// (c / pack_width * entries + i) * pack_width + c % pack_width.
template <int N, int Q>
struct PackedCells {
    static constexpr int nodes = N;
    static constexpr int points = Q;
    using LaneNodes = std::array<std::array<int, pack_width>, N>;

    bool mean_volume = false;
    double most_point_bulk_over_mu = 0.0;   // see ElementBlock
    int cell_count = 0;
    std::vector<LaneNodes> lane_nodes;      // per pack
    std::vector<PackGeometry<N, Q>> geometry;
    std::vector<PackHourglass> hourglass;   // empty, or one per pack

    int pack_count() const { return static_cast<int>(lane_nodes.size()); }
    int lanes_used(int pack) const { return std::min(pack_width, cell_count - pack * pack_width); }
    /// Strain measures per cell: six Green strains per point, then twelve hourglass strains.
    int strains_per_cell() const { return 6 * Q + (hourglass.empty() ? 0 : 12); }
    int volumes_per_cell() const { return mean_volume ? 1 : Q; }
};

template <int N, int Q>
PackedCells<N, Q> pack_cells(const ElementBlock<N, Q>& block);

using PackedElements = std::variant<PackedCells<8, 1>, PackedCells<8, 8>, PackedCells<4, 1>, PackedCells<10, 4>>;
PackedElements pack_elements(const Elements& elements);

/// Where each node finds its share of a field of cell vectors (3 entries per node of a cell, node by node): first entries of
/// node i are offset[start[i]] ... offset[start[i + 1] - 1], the other two each one pack further.
/// Sums taken in this order do not depend on how the cells were shared between threads.
struct NodeIncidence {
    std::vector<int> start;
    std::vector<int> offset;
};
NodeIncidence node_incidence(const VolumeMesh& mesh);

/// The cell of an offset.
template <int N>
int incident_cell(const NodeIncidence& incidence, int k) {
    const int offset = incidence.offset[static_cast<std::size_t>(k)];
    return offset / (3 * N * pack_width) * pack_width + offset % pack_width;
}

/// Positions of the cells of a pack, from X (3 x n).
template <int N>
Eigen::Matrix<Pack, 3, N> gather_lanes(const std::array<std::array<int, pack_width>, N>& nodes, const Eigen::Matrix3Xd& X) {
    Eigen::Matrix<Pack, 3, N> result;
    const double* data = X.data();
    for (int a = 0; a < N; ++a) {
        const auto& node = nodes[static_cast<std::size_t>(a)];
        for (int r = 0; r < 3; ++r) result(r, a) = Pack([&](auto lane) { return data[3 * node[lane] + r]; });
    }
    return result;
}

}  // namespace myo
