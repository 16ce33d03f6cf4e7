#include "base/text.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "mesh/region.hpp"
#include "sensitivity/adjoint_run.hpp"

namespace myo::bench {
namespace {

/// Forward and backward pass with a limited memory for stored states. The loss is half the squared displacement of the
/// tip at the end.
Result<BenchFigures> gradient_within(double budget_bytes, const BenchBeam& beam, int steps) {
    // Set-up and run are timed apart.
    const double made = thread_time_s();
    const model::Model model = bench_beam(beam);
    const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::tr_bdf2, 0.01, steps, 1e-6);
    sensitivity::LossOfMotion loss;
    loss.nodes = mesh::nodes_in_box(model.body->mesh, Box{{0.1 - 1e-6, -1.0, -1.0}, {1.0, 1.0, 1.0}});
    loss.evaluate = [](const sensitivity::NodeMotion& motion) {
        sensitivity::MotionLoss result;
        result.d_positions.resize(motion.positions.size());
        const Eigen::Matrix3Xd moved = motion.positions.back() - motion.positions.front();
        result.value = 0.5 * moved.squaredNorm();
        result.d_positions.back() = moved;
        return result;
    };
    sensitivity::AdjointOptions adjoint;
    adjoint.memory_bytes = budget_bytes;
    const double start = thread_time_s();
    const sensitivity::GradientRun run = sensitivity::simulate_with_gradient(model, options, loss, adjoint);
    BenchFigures figures;
    figures.setup_s = start - made;
    figures.run_s = thread_time_s() - start;
    figures.name = std::to_string(model.body->dofs()) + " DOF, gradient of " + std::to_string(steps) +
                   " steps, budget " + format_number(budget_bytes / 1e6, 3) + " MB";
    if (!run.complete()) return Error{run.message, figures.name};
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    figures.steps = run.steps;
    figures.h_s = options.h_s;
    // dloss/dE times E is printed so that two versions of the program can be compared.
    figures.quantities = {
        {"kept of the run at once", run.tape_bytes / 1e6, "MB", {}},
        {"parts it was cut into", static_cast<double>(run.parts), "", {}},
        {"dloss/dE times E", sensitivity::young_gradient(model, run.gradient).youngs_modulus_Pa * 263824.0, "m2", {}}};
    return figures;
}

}  // namespace

BenchCase bench_gradient_memory() {
    const BenchBeam honest{fem::ElementKind::hex8, {69, 21, 21}, "neo_hookean", 0.003};
    const double budget_bytes = sensitivity::AdjointOptions{}.memory_bytes;
    return {
        "gradient-memory",
        "gradient of 160 steps of 100 thousand degrees of freedom, forwards and backwards, within the budget for what "
        "is kept of the run",
        {{format_number(budget_bytes / 1e6, 3) + " MB", [=] { return gradient_within(budget_bytes, honest, 160); }}}};
}

}  // namespace myo::bench
