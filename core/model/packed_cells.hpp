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

/// Nodal vectors of a pack of cells, 3 x N.
template <int N>
using PackNodes = Eigen::Matrix<Pack, 3, N>;

/// Symmetric tensor (xx, yy, zz, xy, yz, zx).
using PackSymmetric = std::array<Pack, 6>;

/// Geometry of a pack of cells whose deformation gradients follow from the shape functions.
template <int N, int Q>
struct PackGeometry {
    static constexpr int nodes = N, points = Q;
    using Block = fem::ElementBlock<N, Q>;

    std::array<Eigen::Matrix<Pack, N, 3>, Q> gradient;  // shape gradients at the points [1/m]
    std::array<Pack, Q> weight;                         // quadrature weights [m3]
    Pack volume;                                        // [m3]
};

/// Geometry of a pack of hex8 cells with assumed strains. Members as in fem::AssumedStrainGeometry.
struct PackAssumedStrain {
    static constexpr int nodes = 8, points = fem::AssumedStrainRule::points;
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

/// Part of AssumedStrainGeometry that cells of equal shape do not share: `relaxed`.
using PackSurroundings = std::array<Pack, 3>;

/// Element block in the layout of the vectorised kernel. Cell c is lane c % pack_width of pack c / pack_width; the last
/// pack is padded with copies of the last cell, whose results are not used. Packs of equal shape share their geometry,
/// which in a grid is almost all.
///
/// Per-cell fields (strains, pressures, forces) are stored pack by pack: entry i of cell c is at (c / pack_width *
/// entries + i) * pack_width + c % pack_width.
template <class Geometry>
struct PackedCells {
    static constexpr int nodes = Geometry::nodes;
    static constexpr int points = Geometry::points;
    using LaneNodes = std::array<std::array<int, pack_width>, Geometry::nodes>;

    bool mean_volume = false;                    // one volume measure per cell instead of one per point
    std::vector<Pack> point_bulk_over_mu;        // per pack, see PointBulkPolicy; empty: 0
    int cell_count = 0;                          // without padding
    std::vector<LaneNodes> lane_nodes;           // per pack: node of each cell node and lane
    std::vector<Geometry> shapes;                // distinct geometries
    std::vector<int> shape_of_pack;              // per pack: index into shapes
    std::vector<PackSurroundings> surroundings;  // per pack of cells with assumed strains; otherwise empty

    int pack_count() const { return static_cast<int>(lane_nodes.size()); }
    /// Lanes of a pack that hold cells; less than pack_width only in the last pack.
    int lanes_used(int pack) const { return std::min(pack_width, cell_count - pack * pack_width); }
    /// Surroundings of a pack; zeros for elements without them.
    const PackSurroundings& surroundings_of(int pack) const {
        static const PackSurroundings none{};
        return surroundings.empty() ? none : surroundings[static_cast<std::size_t>(pack)];
    }
    /// Geometry of a pack, possibly shared with others.
    const Geometry& geometry(int pack) const {
        return shapes[static_cast<std::size_t>(shape_of_pack[static_cast<std::size_t>(pack)])];
    }
    /// Components of the Green strains of all points of a cell.
    static constexpr int strains_per_cell() { return 6 * points; }
    /// Volume measures (pressures) per cell.
    int volumes_per_cell() const { return mean_volume ? 1 : points; }
};

/// Supported element formulations: hex8 with assumed strains, hex8, tet4 and tet10 with 4 or 10 points.
using PackedElements = std::variant<PackedCells<PackAssumedStrain>, PackedCells<PackGeometry<8, 8>>,
                                    PackedCells<PackGeometry<4, 1>>, PackedCells<PackGeometry<10, 4>>,
                                    PackedCells<PackGeometry<10, 10>>>;
/// Packs the elements of a body.
PackedElements pack_elements(const fem::Elements& elements);

/// Positions of the contributions to each node in a field of cell vectors (3 entries per node of a cell, node by node).
/// First components of node i are at offset[start[i]] ... offset[start[i + 1] - 1], the other two each one pack
/// further.
///
/// Summation in this order does not depend on the distribution of cells over threads.
struct NodeIncidence {
    std::vector<int> start;   // n + 1: first offset of each node, and the end
    std::vector<int> offset;  // into the field
};
/// Node incidence of a mesh.
NodeIncidence node_incidence(const mesh::VolumeMesh& mesh);

/// Cell to which offset k belongs.
template <int N>
int incident_cell(const NodeIncidence& incidence, int k) {
    const int offset = incidence.offset[static_cast<std::size_t>(k)];
    return offset / (3 * N * pack_width) * pack_width + offset % pack_width;
}

/// Nodal vectors of the cells of a pack, gathered from X (3 x n).
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
/// Nodal vectors of a pack, gathered from X (3 x n).
template <class Geometry>
PackNodes<Geometry::nodes> nodes_of_pack(const PackedCells<Geometry>& cells, int pack, const Eigen::Matrix3Xd& X) {
    return gather_lanes<Geometry::nodes>(cells.lane_nodes[static_cast<std::size_t>(pack)], X);
}

/// Lanes value(cell) of a pack; lanes past the last cell repeat the last cell.
template <class Geometry, class Value>
Pack pack_of(const PackedCells<Geometry>& cells, int pack, const Value& value) {
    return Pack([&](auto lane) {
        return value(
            static_cast<std::size_t>(std::min(pack * pack_width + static_cast<int>(lane), cells.cell_count - 1)));
    });
}

}  // namespace myo::model
