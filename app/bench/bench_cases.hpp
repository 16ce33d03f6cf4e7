#pragma once

#include "bench/bench_case.hpp"

namespace myo::bench {

// Builders of the benchmarks, one per file bench_<id>.cpp; the summary of each is in the case itself.

/// The beam released under gravity.
BenchCase bench_release();
/// Sudden force on the tip of the beam.
BenchCase bench_tip_load();
/// The default time step with every element.
BenchCase bench_elements();
/// The beam of linear tetrahedra, released under gravity.
BenchCase bench_tetrahedra();
/// An arm under strong actuation.
BenchCase bench_arm();
/// Bodies with chambers and tendons, compared with the plain body.
BenchCase bench_actuators();
/// One run on two threads.
BenchCase bench_threads();
/// Forward sensitivities together with the run.
BenchCase bench_tangents();
/// Adjoint gradient with respect to all moduli and signals.
BenchCase bench_backward();
/// Adjoint gradient of a long run within a memory budget.
BenchCase bench_gradient_memory();
/// Time and memory over the number of degrees of freedom.
BenchCase bench_scaling();
/// The published formulation against traces of the published program.
BenchCase bench_published();
/// Static deflection with every element at several Poisson's ratios.
BenchCase bench_locking();
/// Richardson limits of these deflections.
BenchCase bench_converged();
/// Calibration of many static poses.
BenchCase bench_holds();
/// Playing live while a hand pulls.
BenchCase bench_live();
/// Laws from files, compared with the elements of the core that they repeat.
BenchCase bench_laws();
/// A slender bar against beam theory.
BenchCase bench_accuracy();
/// Default meshes against an independent program.
BenchCase bench_default_meshes();

}  // namespace myo::bench
