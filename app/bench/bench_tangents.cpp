#include <cmath>
#include <vector>

#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::bench {
namespace {

/// Sensitivities of the default run to `count` moduli, each of every count-th cell.
Result<BenchFigures> tangents(int count) {
    BenchBeam beam;
    beam.damping_s = 0.003;
    const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::tr_bdf2, 0.01, 40, 1e-6);
    Result<BenchFigures> forward = measure_run("forward", beam, options);
    if (!forward) return forward;
    // The parameters share out the cells, so that none is trivial.
    const model::Model model = bench_beam(beam);
    std::vector<sensitivity::ModelTangent> parameters;
    for (int p = 0; p < count; ++p) {
        sensitivity::ModelTangent tangent = sensitivity::youngs_modulus_tangent(model, 263824.0);
        for (int c = 0; c < model.body->cell_count(); ++c)
            if (c % count != p) tangent.moduli[static_cast<std::size_t>(c)] = {0.0, 0.0};
        parameters.push_back(std::move(tangent));
    }
    const double start = thread_time_s();
    const sensitivity::SensitiveTrace trace = sensitivity::simulate_with_tangents(model, options, parameters, {0});
    // Iterations and sizes are those of the forward run, which the tangents do not change.
    BenchFigures figures = *forward;
    figures.run_s = thread_time_s() - start;
    figures.name = "tangents of " + std::to_string(count) + " parameters with the run, 4,608 DOF";
    figures.limit_ms = 0.0;
    figures.note = "forward alone " + std::to_string(std::lround(1e3 * forward->ms_per_step())) + " us/step";
    if (count == 40)
        figures.goal_ms = 6.0 * forward->ms_per_step();  // forward run plus tangents of at most five times its time
    if (!trace.trace.complete()) return Error{trace.trace.message, figures.name};
    return figures;
}

}  // namespace

BenchCase bench_tangents() {
    return {"tangents",
            "exact sensitivities with the default run",
            {{"2", [] { return tangents(2); }}, {"40", [] { return tangents(40); }}}};
}

}  // namespace myo::bench
