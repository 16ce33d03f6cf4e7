#pragma once

#include <Eigen/Core>

#include <string>

#include "bench/beam_theory.hpp"
#include "fem/element_block.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::bench {

/// How the cells of a bar are skewed.
enum class Skew {
    none,
    plan,   // sections lean by half along y, seen from above
    side,   // by half along z, seen from the side; both stand upright at the ends
    nodes,  // nodes moved at random by up to a fifth of a cell, along axes on whose sides they do not lie
};

/// The bar filled by bricks, or by six tetrahedra for each. Edges stay straight.
mesh::VolumeMesh bar_mesh(const BarShape& bar, fem::ElementKind element, const Eigen::Vector3i& bricks,
                          Skew skew = Skew::none);

/// Bricks so many times as long as they are high, with so many layers across the height and the width.
Eigen::Vector3i bar_bricks(const BarShape& bar, int layers, double aspect);

/// "sheared in plan" and so on; empty for none.
std::string name_of(Skew skew);

}  // namespace myo::bench
