#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/observe.hpp"

namespace myo::measurement {

/// The binding with its surface point moved at rest, so that the marker moves with the material there. A stalk keeps
/// its length and turns with the material of the new place.
///
/// @param shift_m  mesh frame [m]; off the mesh the material goes on linearly, see fem::material_point()
MarkerBinding moved_binding(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& boundary,
                            const MarkerBinding& binding, const Eigen::Vector3d& shift_m);

/// Markers that sit a little off their places on the body.
///
/// @param places_m  per marker, shift at rest, mesh frame [m]; empty: none
MarkerSet placed_markers(const mesh::VolumeMesh& mesh, const MarkerSet& markers,
                         const std::vector<Eigen::Vector3d>& places_m);

/// Set whose observe() gives the columns of the deformation gradient instead of positions: entry 3 m + axis is the
/// derivative of marker m by the shift of its place along the axis. The rotation of a stalk is taken as constant.
MarkerSet place_derivatives(const MarkerSet& markers);

}  // namespace myo::measurement
