#pragma once

#include "bench/bench_case.hpp"

namespace myo::bench {

BenchCase bench_release();
BenchCase bench_tip_load();
BenchCase bench_elements();
BenchCase bench_tetrahedra();
BenchCase bench_arm();
BenchCase bench_threads();
BenchCase bench_tangents();
BenchCase bench_backward();
BenchCase bench_gradient_memory();
BenchCase bench_scaling();
BenchCase bench_published();
BenchCase bench_locking();
BenchCase bench_converged();
BenchCase bench_accuracy();
BenchCase bench_default_meshes();

}  // namespace myo::bench
