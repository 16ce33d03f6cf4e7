#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {
namespace {

/// Release of the beam under gravity, with the times of DiffPD (projective dynamics with L-BFGS, and its Newton solver)
/// for the same steps, as measured with the published program on a machine of the same class.
BenchRun release(const std::string& name, const BenchBeam& beam, dynamics::Integrator integrator, int steps,
                 double tolerance, std::optional<double> goal_ms, const std::vector<BenchReference>& references,
                 dynamics::Strategy strategy = dynamics::Strategy::automatic) {
    return {name, [=]() -> Result<BenchFigures> {
                dynamics::SimulationOptions options = bench_options(integrator, 0.01, steps, tolerance);
                options.solver.strategy = strategy;
                Result<BenchFigures> figures = measure_run(name, beam, options);
                if (figures) {
                    figures->goal_ms = goal_ms;
                    figures->references = references;
                }
                return figures;
            }};
}

/// Residual that DiffPD accepts: 0.6 % of the weight (its tolerance is 1e-4 of |M x| / h^2). Our residuals are relative
/// to weight plus inertia at the start of a step, up to twice as much.
constexpr double diffpd_tolerance = 3e-3;

}  // namespace

BenchCase bench_release() {
    // `published` is the paper's formulation, `honest` our default.
    const BenchBeam published{fem::ElementKind::hex8_full, {23, 7, 7}, "projective_corotational"};
    const BenchBeam honest{fem::ElementKind::hex8, {23, 7, 7}, "neo_hookean", 0.003};
    const BenchReference projective_20{"DiffPD projective", 5090.0}, newton_20{"DiffPD Newton", 1570.0},
        projective_160{"DiffPD projective, mean of 162 steps", 1249.0};
    // Goals are shares of the times of DiffPD, or times per step aimed at.
    constexpr dynamics::Integrator euler = dynamics::Integrator::implicit_euler;
    return {
        "release",
        "the beam let go under gravity, h = 10 ms: the paper's energy with implicit Euler, and the default model",
        {
            release("paper's energy, Euler, 160 steps, residual 1e-6", published, euler, 160, 1e-6, 2.0,
                    {projective_160}),
            release("paper's energy, Euler, 160 steps, DiffPD's residual", published, euler, 160, diffpd_tolerance,
                    1249.0 / 800.0, {projective_160}),
            release("paper's energy, Euler, first 20 steps, DiffPD's residual", published, euler, 20, diffpd_tolerance,
                    5.09, {projective_20, newton_20}),
            release("paper's energy, Euler, first 20 steps, residual 1e-4", published, euler, 20, 1e-4, {},
                    {projective_20, newton_20}),
            release("paper's energy, Euler, first 20 steps, DiffPD's residual, projective dynamics itself", published,
                    euler, 20, diffpd_tolerance, 5090.0 / 16.0, {projective_20}, dynamics::Strategy::projective),
            release("paper's energy, Euler, first 20 steps, DiffPD's residual, Newton", published, euler, 20,
                    diffpd_tolerance, {}, {newton_20}, dynamics::Strategy::newton),
            release("neo-Hookean, damped, TR-BDF2, 160 steps, residual 1e-6", honest, dynamics::Integrator::tr_bdf2,
                    160, 1e-6, 8.0, {}),
        }};
}

}  // namespace myo::bench
