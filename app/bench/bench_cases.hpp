#pragma once

#include "bench/bench_case.hpp"

namespace myo::bench {

// Builders of the benchmarks, one per file bench_<id>.cpp; the summary of each is in the case itself.

// Time per step.
BenchCase bench_release();
BenchCase bench_tip_load();
BenchCase bench_elements();
BenchCase bench_tetrahedra();
BenchCase bench_arm();
BenchCase bench_threads();
// Derivatives.
BenchCase bench_tangents();
BenchCase bench_backward();
BenchCase bench_gradient_memory();
// Cost over size, and accuracy against published traces, converged values and beam theory.
BenchCase bench_scaling();
BenchCase bench_published();
BenchCase bench_locking();
BenchCase bench_converged();
BenchCase bench_accuracy();
BenchCase bench_default_meshes();

}  // namespace myo::bench
