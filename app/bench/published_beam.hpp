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
/// kept.
///
/// The body is the part of the 100 x 30 x 30 mm beam that whole cubes of the edge fill, from the tip at x = 0 to the
/// clamp; gravity acts along -z, the force on the nodes of the tip's upper edge alike. The node lies on the tip, y = 0,
/// one cell below the top.
struct PublishedTrace {
    std::string file;  // in design/reference of the data folder, columns time,x,y,z in s and m
    double edge_m = 0.0;
    double tip_force_N = 0.0;
    double h_s = 0.01;
    double residual = 6e-3;        // at which its steps were accepted, over the weight: its tolerance times |M x| / h^2
    double rest_dz_mm = 0.0;       // its node at rest, by a tightly solved static run of the same program
    double true_mass_dz_mm = 0.0;  // the same with all vertex masses scaled to the body's true mass
};
const std::vector<PublishedTrace>& published_traces();

/// The formulation as published: hex8_full, projective corotational energy, truncated voxels, equal vertex masses
/// unless told.
model::Model published_beam(const PublishedTrace& trace, model::MassModel mass = model::MassModel::equal_vertices);

/// A vertical force on the upper edge of the tip, where x and z are highest, its nodes alike.
model::DeadForce force_on_upper_tip_edge(const mesh::VolumeMesh& mesh, double force_N);

/// On the tip face, y lowest, one cell below the top.
int published_node(const mesh::VolumeMesh& mesh);

struct NodeTrace {
    std::vector<double> times_s;
    Eigen::Matrix3Xd positions;  // 3 x n [m]
};
/// Error: missing or not four numbers a line, with file and line.
Result<NodeTrace> read_node_trace(const std::filesystem::path& path);

/// Where the measured data lie: MYOLOOP_DATA, or ../shared from the folder the program is called in.
std::filesystem::path data_folder();

/// Largest distance between a run's node and the trace at the trace's times, over the largest deflection in the trace.
double trace_deviation(const dynamics::Trace& run, int node, const NodeTrace& trace);

}  // namespace myo::bench
