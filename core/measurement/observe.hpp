#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/simulate.hpp"
#include "measurement/marker_binding.hpp"
#include "sensitivity/adjoint_run.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::measurement {

/// Markers bound to a body, with the nodes that they need.
struct MarkerSet {
    std::vector<MarkerBinding> bindings;
    std::vector<int> nodes;                   // ascending, each once
    std::vector<std::vector<int>> positions;  // per binding: where its nodes stand in `nodes`
};
MarkerSet marker_set(const mesh::VolumeMesh& mesh, const std::vector<Eigen::Vector3d>& rest_m);

/// Markers at given times. Between steps the nodes move on cubic Hermite curves through positions and velocities (error
/// of fourth order in h); before 0 they rest, after the last step they stay.
struct MarkerTracks {
    std::vector<Eigen::Matrix3Xd> positions;   // per marker 3 x T [m]
    std::vector<Eigen::Matrix3Xd> velocities;  // d position / d t [m/s]
};
MarkerTracks observe(const dynamics::Trace& trace, const MarkerSet& markers, const Eigen::VectorXd& times_s);

/// The same of a motion of markers.nodes alone.
MarkerTracks observe(const sensitivity::NodeMotion& motion, const MarkerSet& markers, const Eigen::VectorXd& times_s);

/// The way back: derivatives of a loss with respect to the nodes' motion from those with respect to the marker
/// positions.
///
/// @param pulls  per marker 3 x T [1/m]
/// @return       d_positions and d_velocities of markers.nodes at the motion's times; value 0
sensitivity::MotionLoss pull_on_nodes(const sensitivity::NodeMotion& motion, const MarkerSet& markers,
                                      const Eigen::VectorXd& times_s, const std::vector<Eigen::Matrix3Xd>& pulls);

/// The same with the derivative of the positions with respect to each parameter: [parameter][marker] 3 x T.
struct SensitiveTracks {
    MarkerTracks tracks;
    std::vector<std::vector<Eigen::Matrix3Xd>> tangents;
};
SensitiveTracks observe(const sensitivity::SensitiveTrace& run, const MarkerSet& markers,
                        const Eigen::VectorXd& times_s);

}  // namespace myo::measurement
