#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {

BenchCase bench_tip_load() {
    return {"tip_load",
            "a sudden force of 1 N on the tip of the finer beam, implicit Euler, h = 10 ms, first 20 steps",
            {{"sudden 1 N, Euler, residual 1e-4", [] {
                  const BenchBeam beam{fem::ElementKind::hex8_full, {32, 9, 9}, "projective_corotational", 0.0, -1.0};
                  Result<BenchFigures> figures = measure_run(
                      "paper's energy, sudden 1 N", beam,
                      bench_options(dynamics::Integrator::implicit_euler, 0.01, 20, 1e-4));
                  if (figures) {
                      figures->goal_ms = 40.0;
                      figures->references = {{"DiffPD projective, first 3 steps", 20500.0},
                                             {"DiffPD Newton, first 3 steps", 13000.0}};
                  }
                  return figures;
              }}}};
}

}  // namespace myo::bench
