#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "base/pack.hpp"
#include "fem/element_block.hpp"
#include "material/material.hpp"

namespace myo::model {

/// Vectors at the nodes of as many cells as a pack has lanes.
template <int N>
using PackNodes = Eigen::Matrix<Pack, 3, N>;

/// Symmetric tensors (xx, yy, zz, xy, yz, zx).
using PackSymmetric = std::array<Pack, 6>;

/// Cells whose deformation gradient at their points is that of their shape functions.
template <int N, int Q>
struct PackGeometry {
    static constexpr int nodes = N, points = Q;
    using Block = fem::ElementBlock<N, Q>;

    std::array<Eigen::Matrix<Pack, N, 3>, Q> gradient;  // [1/m]
    std::array<Pack, Q> weight;                         // [m3]
    Pack volume;
};

/// See AssumedStrainGeometry.
struct PackAssumedStrain {
    static constexpr int nodes = 8, points = fem::assumed_strain_rule::points;
    using Block = fem::AssumedStrainBlock;
    struct Plane {
        std::array<PackSymmetric, 3> in_plane;
        std::array<Pack, 3> trace;
        PackSymmetric normal;
    };

    Eigen::Matrix<Pack, 8, 3> gradient;
    Eigen::Matrix<Pack, 8, 4> gamma;
    material::Matrix3<Pack> edges;
    std::array<Plane, 3> planes;
    std::array<PackSymmetric, 3> along;
    Pack volume;
};

/// What of a pack's cells is not shared with others of the same shape: AssumedStrainGeometry::relaxed.
using PackSurroundings = std::array<Pack, 3>;

/// An element block laid out for the vectorised kernel. Cell c is lane c % pack_width of pack c / pack_width; the last
/// pack is filled up with copies of the last cell, whose results nobody reads. Packs of the same shape, as most of a
/// grid, share it.
///
/// Per-cell fields (strains, pressures, forces) are stored pack by pack: entry i of cell c is at
/// (c / pack_width * entries + i) * pack_width + c % pack_width.
template <class Geometry>
struct PackedCells {
    static constexpr int nodes = Geometry::nodes;
    static constexpr int points = Geometry::points;
    using LaneNodes = std::array<std::array<int, pack_width>, Geometry::nodes>;

    bool mean_volume = false;
    std::vector<Pack> point_bulk_over_mu;  // per pack, see PointBulkPolicy; empty: 0
    int cell_count = 0;
    std::vector<LaneNodes> lane_nodes;  // per pack
    std::vector<Geometry> shapes;
    std::vector<int> shape_of_pack;
    std::vector<PackSurroundings> surroundings;  // per pack of cells of assumed strain; else empty

    int pack_count() const { return static_cast<int>(lane_nodes.size()); }
    int lanes_used(int pack) const { return std::min(pack_width, cell_count - pack * pack_width); }
    const PackSurroundings& surroundings_of(int pack) const {
        static const PackSurroundings none{};
        return surroundings.empty() ? none : surroundings[static_cast<std::size_t>(pack)];
    }
    const Geometry& geometry(int pack) const {
        return shapes[static_cast<std::size_t>(shape_of_pack[static_cast<std::size_t>(pack)])];
    }
    /// Green strains of every point.
    static constexpr int strains_per_cell() { return 6 * points; }
    int volumes_per_cell() const { return mean_volume ? 1 : points; }
};

using PackedElements = std::variant<PackedCells<PackAssumedStrain>, PackedCells<PackGeometry<8, 8>>,
                                    PackedCells<PackGeometry<4, 1>>, PackedCells<PackGeometry<10, 4>>,
                                    PackedCells<PackGeometry<10, 10>>>;
PackedElements pack_elements(const fem::Elements& elements);

/// Where each node finds its share of a field of cell vectors (3 entries per node of a cell, node by node): first
/// entries of node i are offset[start[i]] ... offset[start[i + 1] - 1], the other two each one pack further. Sums taken
/// in this order do not depend on how the cells were shared between threads.
struct NodeIncidence {
    std::vector<int> start;
    std::vector<int> offset;
};
NodeIncidence node_incidence(const mesh::VolumeMesh& mesh);

/// The cell of an offset.
template <int N>
int incident_cell(const NodeIncidence& incidence, int k) {
    const int offset = incidence.offset[static_cast<std::size_t>(k)];
    return offset / (3 * N * pack_width) * pack_width + offset % pack_width;
}

/// Positions of the cells of a pack, from X (3 x n).
template <int N>
PackNodes<N> gather_lanes(const std::array<std::array<int, pack_width>, N>& nodes, const Eigen::Matrix3Xd& X) {
    PackNodes<N> result;
    const double* data = X.data();
    for (int a = 0; a < N; ++a) {
        const auto& node = nodes[static_cast<std::size_t>(a)];
        for (int r = 0; r < 3; ++r) result(r, a) = Pack([&](auto lane) { return data[3 * node[lane] + r]; });
    }
    return result;
}
template <class Geometry>
PackNodes<Geometry::nodes> nodes_of_pack(const PackedCells<Geometry>& cells, int pack, const Eigen::Matrix3Xd& X) {
    return gather_lanes<Geometry::nodes>(cells.lane_nodes[static_cast<std::size_t>(pack)], X);
}

/// value(cell) in the lanes of a pack; past the last cell that of the last.
template <class Geometry, class Value>
Pack pack_of(const PackedCells<Geometry>& cells, int pack, const Value& value) {
    return Pack([&](auto lane) {
        return value(
            static_cast<std::size_t>(std::min(pack * pack_width + static_cast<int>(lane), cells.cell_count - 1)));
    });
}

}  // namespace myo::model
