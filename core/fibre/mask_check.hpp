#pragma once

#include <string>
#include <vector>

#include "fibre/painted_mask.hpp"

namespace myo::fibre {

/// When a mask contradicts itself or the body.
struct MaskRule {
    /// The cell size over the distance to the nearest other place, median over the mask: 1 for cubes, 1.7 for boxes of
    /// 1 : 2 : 2, 2.5 to 4 for tetrahedra. Below, paint does not fill the room between the places; far above, it
    /// spreads beyond them.
    double least_size = 0.85, most_size = 6.0;
    /// Fewer places do not tell how far apart they are.
    Eigen::Index least_places = 4;
    /// Places nearer than this part of the spacing are one.
    double same_place = 1e-6;
};

/// Sentences on what a mask says of itself that cannot be so: a cell size that is not the spacing of its places, places
/// listed twice with other weights or fibres.
std::vector<std::string> contradictions(const PaintedMask& mask, const MaskRule& rule = {});

/// Painted elements that lie outside the mesh by more than half their spacing and half a cell of it, which a coarser
/// mesh may miss.
Eigen::Index elements_off_mesh(const mesh::VolumeMesh& mesh, const PaintedMask& mask);

}  // namespace myo::fibre
