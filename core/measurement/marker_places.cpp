#include "measurement/marker_places.hpp"

#include <cassert>
#include <utility>

#include "fem/material_point.hpp"

namespace myo::measurement {

using Eigen::Index;
using Eigen::Vector3d;

MarkerBinding moved_binding(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& boundary,
                            const MarkerBinding& binding, const Vector3d& shift_m) {
    const Vector3d foot = mesh.nodes(Eigen::all, binding.nodes) * binding.weights;
    fem::MaterialPoint point = fem::material_point(mesh, boundary, foot + shift_m);
    return {std::move(point.nodes), std::move(point.weights), std::move(point.gradient), binding.offset};
}

MarkerSet placed_markers(const mesh::VolumeMesh& mesh, const MarkerSet& markers,
                         const std::vector<Vector3d>& places_m) {
    if (places_m.empty()) return markers;
    assert(places_m.size() == markers.bindings.size());
    const mesh::BoundaryLocator boundary(mesh);
    ObservationError error;
    for (std::size_t m = 0; m < places_m.size(); ++m)
        error.places.push_back({m, places_m[m], moved_binding(mesh, boundary, markers.bindings[m], places_m[m])});
    return seen_markers(markers, error);
}

MarkerSet place_derivatives(const MarkerSet& markers) {
    MarkerSet columns;
    columns.nodes = markers.nodes;
    for (std::size_t m = 0; m < markers.bindings.size(); ++m)
        for (Index axis = 0; axis < 3; ++axis) {
            const MarkerBinding& binding = markers.bindings[m];
            columns.bindings.push_back({binding.nodes, binding.gradient.col(axis),
                                        Eigen::MatrixXd::Zero(binding.gradient.rows(), 3), Vector3d::Zero()});
            columns.positions.push_back(markers.positions[m]);
        }
    return columns;
}

}  // namespace myo::measurement
