#pragma once

#include <algorithm>

#include "model/packed_cells.hpp"

namespace myo::model {

/// Writes the entries of one cell into a lane.
template <class Packs, class Values>
void set_lane_of(Packs& packs, std::size_t lane, const Values& values) {
    for (Eigen::Index k = 0; k < values.size(); ++k) packs.data()[k][lane] = values.data()[k];
}

/// Writes the geometry of one cell into a lane.
template <int N, int Q>
void set_lane_of(PackGeometry<N, Q>& to, std::size_t lane, const fem::CellGeometry<N, Q>& from) {
    for (std::size_t q = 0; q < Q; ++q) {
        set_lane_of(to.gradient[q], lane, from.gradient[q]);
        to.weight[q][lane] = from.weight[q];
    }
    to.volume[lane] = from.volume;
}

/// Writes the geometry of one cell with assumed strains into a lane.
inline void set_lane_of(PackAssumedStrain& to, std::size_t lane, const fem::AssumedStrainGeometry& from) {
    set_lane_of(to.gradient, lane, from.gradient);
    set_lane_of(to.gamma, lane, from.gamma);
    set_lane_of(to.edges, lane, from.edges);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t m = 0; m < 3; ++m)
            set_lane_of(to.planes[k].in_plane[m], lane, from.planes[k].in_plane.col(static_cast<Eigen::Index>(m)));
        set_lane_of(to.planes[k].trace, lane, from.planes[k].trace);
        set_lane_of(to.planes[k].normal, lane, from.planes[k].normal);
        set_lane_of(to.along[k], lane, from.along[k]);
    }
    to.volume[lane] = from.volume;
}

/// True if two packs have equal geometry up to the rounding of coordinates.
template <class Geometry>
bool same_shape(const Geometry& a, const Geometry& b) {
    // Geometry consists of Packs only and is compared as an array.
    constexpr std::size_t count = sizeof(Geometry) / sizeof(Pack);
    const Pack *x = reinterpret_cast<const Pack*>(&a), *y = reinterpret_cast<const Pack*>(&b);
    // Volumes first: they differ for most pairs of shapes, and give the scale of the comparison.
    const Pack scale = abs(a.volume);
    if (any_of(abs(a.volume - b.volume) > 1e-11 * scale)) return false;
    // Entries have different dimensions. Entries that should vanish are compared with the largest shape gradient.
    Pack largest = 0.0;
    for (std::size_t k = 0; k < count; ++k) largest = max(largest, abs(x[k]));
    for (std::size_t k = 0; k < count; ++k)
        if (any_of(abs(x[k] - y[k]) > 1e-11 * abs(x[k]) + 1e-15 * largest)) return false;
    return true;
}

struct PackedCellsPolicy {
    /// Number of previous shapes a pack is compared with. A grid with non-uniform lines has a few distinct shapes.
    std::size_t max_compared = 16;
};
inline constexpr PackedCellsPolicy packed_cells_policy;

/// The cells of a block in packs. Packs of equal shape share their geometry.
template <class Geometry>
PackedCells<Geometry> pack_cells(const typename Geometry::Block& block) {
    PackedCells<Geometry> packed;
    if constexpr (requires { block.mean_volume; }) packed.mean_volume = block.mean_volume;
    packed.cell_count = block.cell_count();
    const int packs = (block.cell_count() + pack_width - 1) / pack_width;
    packed.lane_nodes.resize(static_cast<std::size_t>(packs));
    for (std::size_t pack = 0; pack < packed.lane_nodes.size(); ++pack) {
        Geometry geometry;
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(pack_width); ++lane) {
            // Lanes past the last cell repeat it, so that they stay finite.
            const int cell = std::min(static_cast<int>(pack) * pack_width + static_cast<int>(lane),
                                      block.cell_count() - 1);
            for (int a = 0; a < Geometry::nodes; ++a)
                packed.lane_nodes[pack][static_cast<std::size_t>(a)][lane] = block.cells(a, cell);
            set_lane_of(geometry, lane, block.geometry[static_cast<std::size_t>(cell)]);
        }
        // Only the most recent shapes are compared, which bounds the cost for unstructured meshes.
        const std::size_t known = packed.shapes.size(), first = known > packed_cells_policy.max_compared
                                                                    ? known - packed_cells_policy.max_compared
                                                                    : 0;
        std::size_t shape = first;
        while (shape < known && !same_shape(packed.shapes[shape], geometry)) ++shape;
        if (shape == known) packed.shapes.push_back(geometry);
        packed.shape_of_pack.push_back(static_cast<int>(shape));
        if constexpr (requires { block.point_bulk_over_mu; })
            if (!block.point_bulk_over_mu.empty())
                packed.point_bulk_over_mu.push_back(pack_of(
                    packed, static_cast<int>(pack), [&](std::size_t c) { return block.point_bulk_over_mu[c]; }));
        if constexpr (requires { block.geometry.front().relaxed; }) {
            packed.surroundings.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
                packed.surroundings.back()[k] = pack_of(packed, static_cast<int>(pack),
                                                        [&](std::size_t c) { return block.geometry[c].relaxed[k]; });
        }
    }
    return packed;
}

}  // namespace myo::model
