#include "bench/arm_model.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {

BenchCase bench_arm() {
    return {"arm",
            "an arm with antagonist muscles under the strongest actuation, implicit Euler, h = 10 ms, 25 steps",
            {{"AC2, Euler, residual 1e-4", [] {
                  Result<BenchFigures> figures = measure_model(
                      "paper's energy, AC2", arm_model,
                      bench_options(dynamics::Integrator::implicit_euler, 0.01, 25, 1e-4));
                  if (figures) {
                      figures->goal_ms = 40.0;
                      figures->references = {{"DiffPD projective at strong actuation", 83000.0},
                                             {"DiffPD Newton", 15500.0}};
                  }
                  return figures;
              }}}};
}

}  // namespace myo::bench
