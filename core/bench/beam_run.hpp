#pragma once

#include <Eigen/Core>

#include <string>

#include "bench/bench_case.hpp"
#include "dynamics/simulate.hpp"
#include "fem/element_block.hpp"
#include "model/model.hpp"

namespace myo {

/// The paper's beam (100 x 30 x 30 mm, clamped at x = 0, 264 kPa, nu = 0.499, 1070 kg/m3) under gravity.
/// Source: Dubied et al. 2022, sec. IV.
struct BenchBeam {
    ElementKind element = ElementKind::hex8;
    Eigen::Vector3i cells{23, 7, 7};
    std::string material = "neo_hookean";
    double damping_s = 0.0;
    double tip_force_N = 0.0;      // upwards over the end face, from the start
};
Model bench_beam(const BenchBeam& beam);

/// What a complete run tells of itself; times and limit are the caller's.
BenchFigures figures_of(const std::string& name, const Model& model, const Trace& trace, const SimulationOptions& options);

/// Measures a run with these options. Iterations count solves; memory is the caller's.
Result<BenchFigures> measure_run(const std::string& name, const BenchBeam& beam, const SimulationOptions& options);

/// Processor time of the calling thread [s].
double thread_time_s();

/// Bytes per second that one thread reads from an array of this size, the best of several passes.
double read_bandwidth(double bytes);

/// Options of a run of `steps` steps.
SimulationOptions bench_options(Integrator integrator, double h_s, int steps, double tolerance);

}  // namespace myo
