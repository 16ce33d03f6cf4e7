#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/simulate.hpp"
#include "measurement/marker_binding.hpp"
#include "measurement/observation_error.hpp"
#include "sensitivity/adjoint_run.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::measurement {

/// Markers bound to a body, with the nodes they depend on.
struct MarkerSet {
    std::vector<MarkerBinding> bindings;
    std::vector<int> nodes;                   // of all bindings, ascending, unique
    std::vector<std::vector<int>> positions;  // per binding: indices of its nodes in `nodes`
};
/// Binds the rest positions [m, mesh frame] of all markers.
MarkerSet marker_set(const mesh::VolumeMesh& mesh, const std::vector<Eigen::Vector3d>& rest_m);

/// The markers where they really sit: those of the error's places are bound there, the others as declared.
MarkerSet seen_markers(const MarkerSet& declared, const ObservationError& error);

/// Marker motion at given times.
struct MarkerTracks {
    std::vector<Eigen::Matrix3Xd> positions;   // per marker, 3 x T [m]
    std::vector<Eigen::Matrix3Xd> velocities;  // time derivative, 3 x T [m/s]
};
/// Marker tracks of a run at the given times.
///
/// Between steps the nodes move on cubic Hermite curves through positions and velocities (error of fourth order in h).
/// Before t = 0 the body rests; after the last step it stays.
MarkerTracks observe(const dynamics::Trace& trace, const MarkerSet& markers, const Eigen::VectorXd& times_s);

/// Marker tracks from the motion of markers.nodes alone.
MarkerTracks observe(const sensitivity::NodeMotion& motion, const MarkerSet& markers, const Eigen::VectorXd& times_s);

/// Transpose of observe(): derivatives of a loss with respect to the motion of the nodes, from those with respect to
/// the marker positions.
///
/// @param pulls  derivative with respect to the marker positions, per marker 3 x T [1/m]
/// @return       d_positions and d_velocities of markers.nodes at the times of the motion; value 0
sensitivity::MotionLoss pull_on_nodes(const sensitivity::NodeMotion& motion, const MarkerSet& markers,
                                      const Eigen::VectorXd& times_s, const std::vector<Eigen::Matrix3Xd>& pulls);

/// Marker tracks with their derivatives.
struct SensitiveTracks {
    MarkerTracks tracks;
    std::vector<std::vector<Eigen::Matrix3Xd>>
        tangents;  // derivatives of the positions, [parameter][marker], 3 x T [m per unit]
};
/// Marker tracks of a run with tangents. The tangents must be those of markers.nodes.
SensitiveTracks observe(const sensitivity::SensitiveTrace& run, const MarkerSet& markers,
                        const Eigen::VectorXd& times_s);

}  // namespace myo::measurement
