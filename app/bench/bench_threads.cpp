#include <algorithm>
#include <limits>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {
namespace {

/// One run on one and on two threads in turn, three times each, so that both see the same load of the machine; the
/// best wall-clock time of each counts.
Result<BenchFigures> two_threads(const Eigen::Vector3i& cells, int steps) {
    const model::Model model = bench_beam({fem::ElementKind::hex8, cells, "neo_hookean", 0.003});
    const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::tr_bdf2, 0.01, steps, 1e-6);
    double best[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    dynamics::Trace traces[2];
    for (int turn = 0; turn < 3; ++turn)
        for (const int threads : {1, 2}) {
            const Stopwatch watch;
            parallel_tasks(1, threads, [&](int) { traces[threads - 1] = dynamics::simulate(model, options); });
            best[threads - 1] = std::min(best[threads - 1], watch.seconds());
        }
    // Traces of the last turn.
    for (const dynamics::Trace& trace : traces)
        if (!trace.complete()) return Error{trace.message, "threads"};
    BenchFigures figures = figures_of("default model, two threads, wall clock", model, traces[1], options);
    figures.run_s = best[1];
    figures.quantities = {{"speed-up over one thread", best[0] / best[1], "times", 1.5},
                          {"largest difference between the two runs",
                           (traces[0].positions.back() - traces[1].positions.back()).cwiseAbs().maxCoeff(),
                           "m",
                           {}}};
    return figures;
}

}  // namespace

BenchCase bench_threads() {
    return {"threads",
            "one run on two threads against one, TR-BDF2, residual 1e-6, wall clock: for an otherwise idle machine",
            {{"4,608 DOF",
              [] {
                  return two_threads({23, 7, 7}, 40);
              }},
             {"9,900 DOF",
              [] {
                  return two_threads({32, 9, 9}, 20);
              }},
             {"32 thousand DOF", [] {
                  return two_threads({46, 14, 14}, 6);
              }}}};
}

}  // namespace myo::bench
