#pragma once

#include <Eigen/Core>

#include <vector>

#include "support/beam.hpp"

namespace myo::test {

/// Returns the mesh without the cells whose centre lies in the box, and without nodes that no cell refers to.
mesh::VolumeMesh without(const mesh::VolumeMesh& mesh, const Box& box);

/// Volume of the chamber in hollow_block().
inline constexpr double hollow_volume_m3 = 3e-6;

/// A block of 60 x 30 x 30 mm with a closed chamber of 30 x 10 x 10 mm, clamped at x = 0.
model::Model hollow_block(fem::ElementKind kind);

/// A free sphere of outer radius b with a concentric hole of radius a [m], made from a cube of `cells` elements per
/// side: its cubic shells are mapped to spheres. The hole takes a third of the cube's side, so `cells` should be a
/// multiple of three.
model::Model hollow_sphere(double a, double b, int cells);

/// A free tube of outer radius b along z with a closed hole of radius a and length 2 `half_m` about the origin [m]; its
/// ends are as thick as its wall. Made from a square prism like hollow_sphere(), with `along` cells per hole.
model::Model hollow_tube(double a, double b, double half_m, int cells, int along);

}  // namespace myo::test
