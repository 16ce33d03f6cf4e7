#include <string>

#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {

BenchCase bench_tetrahedra() {
    BenchCase result{"tetrahedra",
                     "the beam of tetrahedra let go under gravity: the paper's energy with implicit Euler, h = 10 ms",
                     {}};
    struct Row {
        int width, steps;  // layers across, time steps
        double tolerance;  // relative residual
    };
    for (const Row& row : {Row{7, 10, 1e-4}, Row{7, 160, 1e-6}, Row{20, 10, 1e-4}}) {
        // Cubes of six tetrahedra each.
        const BenchBeam beam{fem::ElementKind::tet4, {3 * row.width, row.width, row.width}, "projective_corotational"};
        const std::string name = "paper's energy, Euler, " + std::to_string(row.steps) + " steps, residual " +
                                 (row.tolerance < 1e-5 ? "1e-6" : "1e-4");
        result.runs.push_back(
            {std::to_string(row.width) + " layers, " + std::to_string(row.steps) + " steps",
             [=]() -> Result<BenchFigures> {
                 Result<BenchFigures> figures = measure_run(
                     name, beam, bench_options(dynamics::Integrator::implicit_euler, 0.01, row.steps, row.tolerance));
                 if (!figures || row.width > 7) return figures;
                 // The published mesh, from TetGen, has 3,834 DOF; ours consists of Kuhn tetrahedra.
                 if (row.steps == 10)
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
