#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {

BenchCase bench_scaling() {
    BenchCase result{"scaling",
                     "the paper's energy, implicit Euler, h = 10 ms, residual 1e-4, from 1 thousand to 200 thousand "
                     "degrees of freedom",
                     {}};
    // Near-cubic cells, so that the proportions of the mesh stay.
    for (const auto& [length, width] : {std::pair{13, 4}, {23, 7}, {32, 9}, {40, 12}, {60, 18}, {90, 27}}) {
        const Eigen::Vector3i cells(length, width, width);
        const int steps = width < 18 ? 20 : 5;  // few steps of the largest meshes, to limit the run time
        result.runs.push_back(
            {std::to_string(length) + " x " + std::to_string(width) + " x " + std::to_string(width), [cells, steps] {
                 const BenchBeam beam{fem::ElementKind::hex8_full, cells, "projective_corotational"};
                 Result<BenchFigures> figures = measure_run(
                     "Euler, residual 1e-4", beam,
                     bench_options(dynamics::Integrator::implicit_euler, 0.01, steps, 1e-4));
                 if (figures && figures->dofs > 60000) figures->goal_ms = figures->dofs < 100000 ? 350.0 : 2000.0;
                 return figures;
             }});
    }
    result.over_size = true;
    return result;
}

}  // namespace myo::bench
