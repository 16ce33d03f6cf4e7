#pragma once

#include <Eigen/Core>

#include <string>

#include "bench/beam_theory.hpp"
#include "fem/element_block.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::bench {

/// Distortion of the cells of a bar.
enum class Skew {
    none,
    plan,   // cross sections sheared by 0.5 along y
    side,   // sheared by 0.5 along z; both kinds stay upright at the ends
    nodes,  // inner coordinates moved at random by up to a fifth of a cell; nodes stay on their faces
};

/// Mesh of a bar from bricks, each split into six tetrahedra for tetrahedral elements. Edges stay straight.
///
/// @param bricks  numbers along x, y, z, each >= 1
/// @return        nodes [m], clamped end at x = 0
mesh::VolumeMesh bar_mesh(const BarShape& bar, fem::ElementKind element, const Eigen::Vector3i& bricks,
                          Skew skew = Skew::none);

/// Numbers of bricks with `layers` across height and width, each about `aspect` times as long as high.
Eigen::Vector3i bar_bricks(const BarShape& bar, int layers, double aspect);

/// Readable name, "sheared in plan"; empty for none.
std::string name_of(Skew skew);

}  // namespace myo::bench
