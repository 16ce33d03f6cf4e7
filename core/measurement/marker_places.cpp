#include "measurement/marker_places.hpp"

#include <cassert>
#include <utility>

namespace myo::measurement {

using Eigen::Index;

// Shape functions are linearised about the declared place: N(X + p) = N(X) + dN/dX p.
MarkerSet placed_markers(MarkerSet markers, const std::vector<Eigen::Vector3d>& places_m) {
    assert(places_m.empty() || places_m.size() == markers.bindings.size());
    for (std::size_t m = 0; m < places_m.size(); ++m)
        markers.bindings[m].weights += markers.bindings[m].gradient * places_m[m];
    return markers;
}

MarkerSet place_derivatives(const MarkerSet& markers) {
    MarkerSet columns;
    columns.nodes = markers.nodes;
    for (std::size_t m = 0; m < markers.bindings.size(); ++m)
        for (Index axis = 0; axis < 3; ++axis) {
            const MarkerBinding& binding = markers.bindings[m];
            columns.bindings.push_back({binding.nodes, binding.gradient.col(axis),
                                        Eigen::MatrixXd::Zero(binding.gradient.rows(), 3), Eigen::Vector3d::Zero()});
            columns.positions.push_back(markers.positions[m]);
        }
    return columns;
}

}  // namespace myo::measurement
