#pragma once

#include <string>
#include <vector>

#include "fibre/painted_mask.hpp"

namespace myo::fibre {

/// Limits for a consistent mask.
struct MaskRule {
    /// Cell size over the distance to the nearest other element, median over the mask: 1 for cubes, 1.7 for boxes of 1
    /// : 2 : 2, 2.5 to 4 for tetrahedra. Below min_size the paint leaves gaps between elements; far above, it extends
    /// outside.
    double min_size = 0.85, max_size = 6.0;
    /// Smallest number of elements for an estimate of the spacing.
    Eigen::Index min_places = 4;
    /// Elements closer than this fraction of the spacing count as identical.
    double same_place = 1e-6;
};

/// Inconsistencies of a mask as sentences for the user: a cell size that does not match the spacing, elements listed
/// twice with different weights or fibres.
std::vector<std::string> contradictions(const PaintedMask& mask, const MaskRule& rule = {});

/// Number of painted elements outside of the mesh. Tolerance: half their spacing plus half a cell of the mesh, since a
/// coarser mesh may not reach them.
Eigen::Index elements_off_mesh(const mesh::VolumeMesh& mesh, const PaintedMask& mask);

}  // namespace myo::fibre
