#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo {
namespace {

/// A run of the beam let go under gravity, with the figures of DiffPD (projective dynamics with L-BFGS, and its Newton) for the same
/// steps: our measurements of the published program on a machine of the same class.
BenchRun release(const std::string& name, const BenchBeam& beam, Integrator integrator, int steps, double tolerance, std::optional<double> goal_ms,
                 const std::vector<BenchReference>& references) {
    return {name, [=]() -> Result<BenchFigures> {
                Result<BenchFigures> figures = measure_run(name, beam, bench_options(integrator, 0.01, steps, tolerance));
                if (figures) {
                    figures->goal_ms = goal_ms;
                    figures->references = references;
                }
                return figures;
            }};
}

}  // namespace

BenchCase bench_release() {
    const BenchBeam published{ElementKind::hex8_full, {23, 7, 7}, "projective_corotational"};
    const BenchBeam honest{ElementKind::hex8, {23, 7, 7}, "neo_hookean", 0.003};
    return {"release",
            "the beam let go under gravity, h = 10 ms: the paper's energy with implicit Euler, and the default model",
            {
                release("paper's energy, Euler, 160 steps, residual 1e-6", published, Integrator::implicit_euler, 160, 1e-6, 2.0, {{"DiffPD projective at 1e-4", 1249.0}}),
                release("paper's energy, Euler, first 20 steps, residual 1e-4", published, Integrator::implicit_euler, 20, 1e-4, 5.0,
                        {{"DiffPD projective", 5090.0}, {"DiffPD Newton", 1570.0}}),
                release("neo-Hookean, damped, TR-BDF2, 160 steps, residual 1e-6", honest, Integrator::tr_bdf2, 160, 1e-6, 8.0, {}),
            }};
}

}  // namespace myo
