#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/observe.hpp"

namespace myo::measurement {

/// Markers that sit a little off their places on the body.
///
/// A shift p of the place at rest moves the marker by F p, with the deformation gradient F of the cell behind it: to
/// first order in p what binding it there gives. A stalk keeps its length and the rotation of the declared place.
/// @param places_m  per marker, shift at rest, mesh frame [m]; empty: none
MarkerSet placed_markers(MarkerSet markers, const std::vector<Eigen::Vector3d>& places_m);

/// Set whose observe() gives the columns of F instead of positions: entry 3 m + axis is the derivative of marker m by
/// the shift of its place along the axis, see placed_markers().
MarkerSet place_derivatives(const MarkerSet& markers);

}  // namespace myo::measurement
