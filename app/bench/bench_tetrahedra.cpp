#include <string>
#include <tuple>

#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {

BenchCase bench_tetrahedra() {
    BenchCase result{"tetrahedra",
                     "the beam of tetrahedra let go under gravity: the paper's energy with implicit Euler, h = 10 ms",
                     {}};
    for (const auto& [width, steps, tolerance] : {std::tuple{7, 10, 1e-4}, {7, 160, 1e-6}, {20, 10, 1e-4}}) {
        const BenchBeam beam{fem::ElementKind::tet4, {3 * width, width, width}, "projective_corotational"};
        const std::string name = "paper's energy, Euler, " + std::to_string(steps) + " steps, residual " +
                                 (tolerance < 1e-5 ? "1e-6" : "1e-4");
        result.runs.push_back(
            {std::to_string(width) + " layers, " + std::to_string(steps) + " steps", [=]() -> Result<BenchFigures> {
                 Result<BenchFigures> figures = measure_run(
                     name, beam, bench_options(dynamics::Integrator::implicit_euler, 0.01, steps, tolerance));
                 if (!figures || width > 7) return figures;
                 // The published mesh, from TetGen, has 3,834 DOF; ours consists of Kuhn tetrahedra.
                 if (steps == 10)
                     figures->references = {{"DiffPD projective, first 10 steps, 3,834 DOF", 3800.0},
                                            {"DiffPD Newton", 290.0}};
                 else
                     figures->references = {{"DiffPD projective at 1e-4, mean of 162 steps, 3,834 DOF", 231.0}};
                 return figures;
             }});
    }
    return result;
}

}  // namespace myo::bench
