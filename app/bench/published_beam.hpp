#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "dynamics/simulate.hpp"
#include "model/model.hpp"

namespace myo::bench {

/// A run of the published simulator (DiffPD with the set-up of Dubied et al. 2022) of which the trace of one node is
/// stored.
///
/// The body is the part of the 100 x 30 x 30 mm beam that whole cubes fill, from the tip at x = 0 to the clamp. Gravity
/// acts along -z, the force equally on all nodes of the tip's upper edge. The node lies on the tip at y = 0, one cell
/// below the top.
struct PublishedTrace {
    std::string file;          // in design/reference of the data folder; columns time,x,y,z in s and m
    double edge_m = 0.0;       // of the cubes
    double tip_force_N = 0.0;  // along z
    double h_s = 0.01;
    double residual = 6e-3;        // accepted residual over the weight: its tolerance times |M x| / h^2
    double rest_dz_mm = 0.0;       // node at rest, from a tightly converged static run of the same program
    double true_mass_dz_mm = 0.0;  // the same with vertex masses scaled to the true mass of the body
};
/// All stored traces.
const std::vector<PublishedTrace>& published_traces();

/// The published formulation: hex8_full, projective corotational energy, truncated voxels; equal vertex masses by
/// default.
model::Model published_beam(const PublishedTrace& trace, model::MassModel mass = model::MassModel::equal_vertices);

/// Vertical force on the upper edge of the tip (highest x and z), equal on all its nodes.
model::DeadForce force_on_upper_tip_edge(const mesh::VolumeMesh& mesh, double force_N);

/// Index of the traced node: tip face, lowest y, one cell below the top. For a mesh of published_beam().
int published_node(const mesh::VolumeMesh& mesh);

/// Trajectory of one node.
struct NodeTrace {
    std::vector<double> times_s;
    Eigen::Matrix3Xd positions;  // 3 x n [m]
};
/// Reads a CSV file with a heading and the columns time, x, y, z.
///
/// Errors: the file is missing or a line does not hold four numbers, with file and line.
Result<NodeTrace> read_node_trace(const std::filesystem::path& path);

/// Folder of the measured data: MYOLOOP_DATA, or ../shared relative to the working directory.
std::filesystem::path data_folder();

/// Largest distance between a run's node and the trace at the times of the trace, over the largest deflection in the
/// trace.
///
/// @param run   has the times of the trace as its first ones (asserted)
/// @param node  of the run's mesh
/// @return      relative, without unit
double trace_deviation(const dynamics::Trace& run, int node, const NodeTrace& trace);

}  // namespace myo::bench
