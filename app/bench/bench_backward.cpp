#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "bench/arm_model.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "mesh/region.hpp"
#include "sensitivity/adjoint_run.hpp"

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

/// Time of the backward pass for the gradient with respect to all moduli and signals, compared with the forward run.
/// The loss is a function of the nodes of the tip.
Result<BenchFigures> backward(const std::string& name, const model::Model& model, const Box& tip,
                              const dynamics::SimulationOptions& options,
                              const std::vector<BenchReference>& references) {
    double start = thread_time_s();
    const dynamics::Trace trace = dynamics::simulate(model, options);
    const double forward_ms = 1e3 * (thread_time_s() - start) / static_cast<double>(trace.times_s.size() - 1);
    if (!trace.complete()) return Error{trace.message, name};

    sensitivity::LossOfMotion loss;
    loss.nodes = mesh::nodes_in_box(model.body->mesh, tip);
    loss.evaluate = [&](const sensitivity::NodeMotion& motion) {
        sensitivity::MotionLoss result;
        for (const Eigen::Matrix3Xd& x : motion.positions) {
            const Eigen::Matrix3Xd distance = x - motion.positions.front();
            result.value += 0.5 * distance.squaredNorm();
            result.d_positions.push_back(distance);
        }
        // The loss is evaluated between the passes, so the clock restarts here.
        start = thread_time_s();
        return result;
    };
    const sensitivity::GradientRun run = sensitivity::simulate_with_gradient(model, options, loss);
    BenchFigures figures;
    figures.run_s = thread_time_s() - start;
    if (!run.complete()) return Error{run.message, name};
    figures.name = std::to_string(model.body->dofs()) + " DOF, " + to_string(model.body->kind) + ", backward, " + name;
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    figures.steps = run.steps;
    figures.h_s = options.h_s;
    figures.goal_ms = 0.8 * forward_ms;  // the backward pass should take less time than the forward run
    figures.references = references;
    figures.note = "forward alone " + format_number(forward_ms, 3) + " ms/step, backward over forward " +
                   format_number(figures.ms_per_step() / forward_ms, 3) + ", kept of the run " +
                   format_number(run.tape_bytes / 1e6, 3) + " MB";
    return figures;
}

}  // namespace

BenchCase bench_backward() {
    const auto beam = [](const std::string& name, const BenchBeam& which, dynamics::Integrator integrator,
                         const std::vector<BenchReference>& references) {
        const auto run = [=] {
            const dynamics::SimulationOptions options = bench_options(integrator, 0.01, 160, 1e-6);
            return backward(name, muscled_beam(which, options), Box{{0.1 - 1e-6, -1.0, -1.0}, {1.0, 1.0, 1.0}}, options,
                            references);
        };
        return BenchRun{name, run};
    };
    const auto arm = [] {
        const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::implicit_euler, 0.01, 160,
                                                                  1e-6);
        model::Model model = arm_model();
        model.activation = {wave(0.2, options), wave(-0.1, options)};
        return backward(
            "arm, muscles' waves, Euler, residual 1e-6", model, Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1e-6}}, options,
            {{"DiffPD projective, backward, at strong actuation", 1740.0}, {"DiffPD Newton, backward", 2330.0}});
    };
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
