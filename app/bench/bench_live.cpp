#include <cmath>

#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "dynamics/live_run.hpp"

namespace myo::bench {
namespace {

constexpr double live_tolerance = 1e-4;  // residual of the stages in the window

/// A hand that holds the end face, `stiffness` [N/m].
dynamics::Grip hand_at_tip(const model::Body& body, double stiffness) {
    dynamics::Grip grip;
    const double end_m = body.mesh.nodes.row(0).maxCoeff() - 1e-9;
    for (int node = 0; node < body.node_count(); ++node)
        if (body.mesh.nodes(0, node) > end_m) grip.nodes.push_back(node);
    const auto count = static_cast<Eigen::Index>(grip.nodes.size());
    grip.shares = Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
    grip.places_m = body.mesh.nodes(Eigen::all, grip.nodes);
    grip.stiffness_N_m = stiffness;
    return grip;
}

/// The beam played live while a hand leads its end around a circle of 60 mm in two seconds.
Result<BenchFigures> pulled(const BenchBeam& beam, double h_s, int steps, double least_rate) {
    const double begin = thread_time_s();
    const model::Model model = bench_beam(beam);
    dynamics::SimulationOptions options = bench_options(dynamics::Integrator::tr_bdf2, h_s, steps, live_tolerance);
    dynamics::LiveControls controls = dynamics::controls_of(model, 0.0);
    controls.h_s = h_s;
    controls.grip = hand_at_tip(*model.body, 60.0);
    // The hand moves as a rigid whole: all held nodes by the same way.
    const Eigen::Matrix3Xd held = controls.grip->places_m;
    const Result<std::unique_ptr<dynamics::LiveRun>> run = dynamics::LiveRun::begin(model, options, controls, {});
    if (!run) return run.error();
    const double start = thread_time_s();
    for (int k = 0; k < steps; ++k) {
        // Half a turn per second.
        const double angle = M_PI * k * h_s;
        controls.grip->places_m = held.colwise() + 0.03 * Eigen::Vector3d(0.0, std::sin(angle), 1.0 - std::cos(angle));
        if (const Result<void> stepped = (*run)->advance(controls, {}); !stepped) return stepped.error();
    }
    BenchFigures figures;
    figures.name = "pulled by a hand, TR-BDF2, residual 1e-4";
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    figures.steps = steps;
    figures.h_s = h_s;
    figures.setup_s = start - begin;
    figures.run_s = thread_time_s() - start;
    figures.goal_ms = 1e3 * h_s / least_rate;
    return figures;
}

/// A row for a mesh and a step.
///
/// @param least_rate  simulated time over processor time that is aimed at
BenchRun row(const Eigen::Vector3i& cells, double h_s, int steps, double least_rate) {
    const BenchBeam beam{fem::ElementKind::hex8, cells, "neo_hookean", 0.003};
    return {std::to_string(cells(0)) + " x " + std::to_string(cells(1)) + " x " + std::to_string(cells(2)) +
                ", h = " + std::to_string(std::lround(1e3 * h_s)) + " ms",
            [=] { return pulled(beam, h_s, steps, least_rate); }};
}

}  // namespace

// Goals: real time at 4,608 degrees of freedom; at 20 thousand half of it, with AVX-512.
BenchCase bench_live() {
    return {"live",
            "playing live while a hand pulls: simulated time over processor time of one thread",
            {row({23, 7, 7}, 0.01, 200, 1.0), row({23, 7, 7}, 0.02, 100, 1.0), row({40, 12, 12}, 0.02, 50, 0.5)}};
}

}  // namespace myo::bench
