#include <cmath>
#include <numbers>

#include "bench/arm_model.hpp"
#include "bench/backward_run.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"

namespace myo::bench {
namespace {

/// Sine about 1 with a period of one second and one knot per step.
fibre::Signal wave(double amplitude, const dynamics::SimulationOptions& options) {
    fibre::Signal signal{{}, {}};
    for (double t = 0.0; t < options.end_s + 0.5 * options.h_s; t += options.h_s) {
        signal.times_s.push_back(t);
        signal.values.push_back(1.0 + amplitude * std::sin(2.0 * std::numbers::pi * t));
    }
    return signal;
}

/// The beam with two antagonist muscles in its outer layers.
model::Model muscled_beam(const BenchBeam& beam, const dynamics::SimulationOptions& options) {
    model::Model model = bench_beam(beam);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const double low : {0.0, 0.0225}) {
        const Box layer{{0.0, 0.0, low}, {0.1, 0.03, low + 0.0075}};
        fibres->push_back(fibre::fibres_in_box(model.body->mesh, layer, Eigen::Vector3d::UnitX(), 2e4,
                                               low > 0.0 ? "upper" : "lower"));
        model.activation.push_back(wave(low > 0.0 ? 0.02 : -0.02, options));
    }
    model.fibres = fibres;
    return model;
}

}  // namespace

BenchCase bench_backward() {
    const auto beam = [](const std::string& name, const BenchBeam& which, dynamics::Integrator integrator,
                         const std::vector<BenchReference>& references) {
        const auto run = [=] {
            const dynamics::SimulationOptions options = bench_options(integrator, 0.01, 160, 1e-6);
            return measure_backward(name, muscled_beam(which, options), Box{{0.1 - 1e-6, -1.0, -1.0}, {1.0, 1.0, 1.0}},
                                    options, references);
        };
        return BenchRun{name, run};
    };
    const auto arm = [] {
        const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::implicit_euler, 0.01, 160,
                                                                  1e-6);
        model::Model model = arm_model();
        model.activation = {wave(0.2, options), wave(-0.1, options)};
        return measure_backward(
            "arm, muscles' waves, Euler, residual 1e-6", model, Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1e-6}}, options,
            {{"DiffPD projective, backward, at strong actuation", 1740.0}, {"DiffPD Newton, backward", 2330.0}});
    };
    // Published formulation, and our default.
    const BenchBeam published{fem::ElementKind::hex8_full, {23, 7, 7}, "projective_corotational"};
    const BenchBeam honest{fem::ElementKind::hex8, {23, 7, 7}, "neo_hookean", 0.003};
    return {"backward",
            "gradient with respect to all moduli and a muscle signal per step, h = 10 ms, 160 steps",
            {
                beam("paper's energy, Euler, residual 1e-6", published, dynamics::Integrator::implicit_euler,
                     {{"DiffPD projective, backward", 1110.0}, {"DiffPD Newton, backward", 750.0}}),
                beam("neo-Hookean, damped, TR-BDF2, residual 1e-6", honest, dynamics::Integrator::tr_bdf2, {}),
                {"arm, muscles' waves, Euler, residual 1e-6", arm},
            }};
}

}  // namespace myo::bench
