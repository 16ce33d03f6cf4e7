#pragma once

#include <Eigen/Core>

#include <vector>

#include "support/beam.hpp"

namespace myo::test {

/// The cells whose middle is not in the box. Nodes that no cell has any more are left out.
mesh::VolumeMesh without(const mesh::VolumeMesh& mesh, const Box& box);

inline constexpr double hollow_volume_m3 = 3e-6;

/// A block of 60 x 30 x 30 mm with a chamber of 30 x 10 x 10 mm, clamped at x = 0.
model::Model hollow_block(fem::ElementKind kind);

/// A sphere of outer radius b with a spherical hole of radius a in its middle, held nowhere: a cube of `cells`, whose
/// shells go to spheres. The hole is a third of the cube.
model::Model hollow_sphere(double a, double b, int cells);

}  // namespace myo::test
