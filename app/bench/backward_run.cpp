#include "bench/backward_run.hpp"

#include "base/text.hpp"
#include "bench/beam_run.hpp"
#include "mesh/region.hpp"
#include "sensitivity/adjoint_run.hpp"

namespace myo::bench {

Result<BenchFigures> measure_backward(const std::string& name, const model::Model& model, const Box& tip,
                                      const dynamics::SimulationOptions& options,
                                      const std::vector<BenchReference>& references) {
    // The forward run without a tape: what the backward pass is compared with.
    double start = thread_time_s();
    const dynamics::Trace trace = dynamics::simulate(model, options);
    const double forward_ms = 1e3 * (thread_time_s() - start) / static_cast<double>(trace.times_s.size() - 1);
    if (!trace.complete()) return Error{trace.message, name};

    sensitivity::LossOfMotion loss;
    loss.nodes = mesh::nodes_in_box(model.body->mesh, tip);
    // Half the squared distance from the start, summed over steps: every state gets a derivative.
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
    // Since the evaluation of the loss: the backward pass alone.
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

}  // namespace myo::bench
