#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>

#include "bench/bench_case.hpp"
#include "dynamics/simulate.hpp"
#include "fem/element_block.hpp"
#include "model/model.hpp"

namespace myo::bench {

/// The paper's beam: 100 x 30 x 30 mm, clamped at x = 0, 264 kPa, nu = 0.499, 1070 kg/m3, under gravity.
/// Source: Dubied et al. 2022, sec. IV.
struct BenchBeam {
    fem::ElementKind element = fem::ElementKind::hex8;
    Eigen::Vector3i cells{23, 7, 7};  // numbers along x, y, z
    std::string material = "neo_hookean";
    double damping_s = 0.0;    // damping time of the material
    double tip_force_N = 0.0;  // upwards over the end face, from the start
};
/// Model of this beam, free end at x = 0.1 m.
model::Model bench_beam(const BenchBeam& beam);

/// Size and iteration counts of a complete run; the caller adds times and limit.
BenchFigures figures_of(const std::string& name, const model::Model& model, const dynamics::Trace& trace,
                        const dynamics::SimulationOptions& options);

/// Builds a model and measures one run of it, in processor time of this thread.
///
/// @param name  of the row; size and element are put before it
/// @param make  builds the model; its time is reported as setup
/// @return      iterations count linear solves; peak memory is the caller's
/// Errors: the run did not complete.
Result<BenchFigures> measure_model(const std::string& name, const std::function<model::Model()>& make,
                                   const dynamics::SimulationOptions& options);
/// measure_model() of a bench_beam().
Result<BenchFigures> measure_run(const std::string& name, const BenchBeam& beam,
                                 const dynamics::SimulationOptions& options);

/// Processor time of the calling thread [s].
double thread_time_s();

/// Bytes per second that one thread reads from an array of this size; the best of several passes.
double read_bandwidth(double bytes);

/// Options for a run of `steps` steps.
///
/// @param h_s        time step [s]
/// @param tolerance  relative residual of the nonlinear solver
dynamics::SimulationOptions bench_options(dynamics::Integrator integrator, double h_s, int steps, double tolerance);

}  // namespace myo::bench
