#include "bench/beam_run.hpp"

#include <ctime>

#include <algorithm>
#include <numeric>
#include <vector>

#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"

namespace myo::bench {
namespace {

/// Regular mesh of the beam, nodes [m].
mesh::VolumeMesh beam_mesh(const BenchBeam& beam, const Box& box) {
    return fem::cell_type(beam.element) == mesh::CellType::hex8
               ? mesh::box_hex_mesh(box, beam.cells)
               : mesh::tet_box_mesh(box, beam.cells, fem::cell_type(beam.element));
}

/// Lower bound of the time per step [ms] from memory traffic: per iteration, the elements are read once and the factor
/// twice (forward and backward substitution).
double limit_ms(const dynamics::Trace& trace, const model::Model& model) {
    if (trace.stages == 0 || trace.factor_bytes <= 0.0) return 0.0;
    const double element_bytes = std::visit(
        [](const auto& cells) {
            return static_cast<double>(cells.shapes.size() * sizeof(cells.shapes[0]) +
                                       cells.lane_nodes.size() * sizeof(cells.lane_nodes[0]));
        },
        model.body->cells);
    // Bandwidths are measured at the sizes of factor and elements: small arrays stay in a cache.
    const double per_iteration = 2.0 * trace.factor_bytes / read_bandwidth(trace.factor_bytes) +
                                 element_bytes / read_bandwidth(element_bytes);
    const auto steps = static_cast<double>(trace.times_s.size() - 1);
    return 1e3 * per_iteration * trace.newton_iterations / steps;
}

}  // namespace

double thread_time_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double read_bandwidth(double bytes) {
    // A sum reads the array once and writes nothing; the best of several passes excludes interruptions.
    const std::vector<float> data(std::max<std::size_t>(1024, static_cast<std::size_t>(bytes / sizeof(float))), 1.0f);
    const Eigen::Map<const Eigen::VectorXf> values(data.data(), static_cast<Eigen::Index>(data.size()));
    double best = 0.0;
    volatile float sink = 0.0f;  // keeps the sum from being optimised away
    const int passes = std::clamp(static_cast<int>(2e8 / (4.0 * static_cast<double>(data.size()))), 3, 200);
    for (int pass = 0; pass < passes; ++pass) {
        const double start = thread_time_s();
        sink = sink + values.sum();
        best = std::max(best, 4.0 * static_cast<double>(data.size()) / std::max(1e-9, thread_time_s() - start));
    }
    return best;
}

model::Model bench_beam(const BenchBeam& beam) {
    const Box box{Eigen::Vector3d::Zero(), Eigen::Vector3d(0.1, 0.03, 0.03)};
    mesh::VolumeMesh mesh = beam_mesh(beam, box);
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1e-6);
    const std::vector<int> clamped = mesh::nodes_in_box(mesh, {-margin, Eigen::Vector3d(0.0, 0.03, 0.03) + margin});
    model::Model model;
    model.body = model::make_body(std::move(mesh), beam.element, clamped);
    model.material = material::find_material(beam.material);
    model.moduli = model::uniform_moduli(model.body->cell_count(), 263824.0, 0.499);
    model.density_kg_m3 = 1070.0;
    model.damping_s = beam.damping_s;
    model.gravity_m_s2 = Eigen::Vector3d(0.0, 0.0, -9.81);
    if (beam.tip_force_N != 0.0) {
        const mesh::SurfaceIntegral tip = mesh::surface_weights(model.body->mesh, model.body->boundary,
                                                                {Eigen::Vector3d(0.1, 0.0, 0.0), box.highest + margin});
        // Spread over the end face by area.
        model::DeadForce force;
        force.share = tip.weight / tip.weight.sum();
        force.force_N = Eigen::Vector3d(0.0, 0.0, beam.tip_force_N);
        model.forces.push_back(std::move(force));
    }
    return model;
}

dynamics::SimulationOptions bench_options(dynamics::Integrator integrator, double h_s, int steps, double tolerance) {
    dynamics::SimulationOptions options;
    options.integrator = integrator;
    options.h_s = h_s;
    options.end_s = steps * h_s;
    options.solver.tolerance = tolerance;
    return options;
}

BenchFigures figures_of(const std::string& name, const model::Model& model, const dynamics::Trace& trace,
                        const dynamics::SimulationOptions& options) {
    BenchFigures figures;
    figures.name = std::to_string(model.body->dofs()) + " DOF, " + to_string(model.body->kind) + ", " + name;
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    figures.steps = static_cast<int>(trace.times_s.size()) - 1;
    figures.h_s = options.h_s;
    figures.iterations_per_step = static_cast<double>(trace.newton_iterations) / figures.steps;
    figures.factorisations_per_step = static_cast<double>(trace.factorisations) / figures.steps;
    return figures;
}

Result<BenchFigures> measure_run(const std::string& name, const BenchBeam& beam,
                                 const dynamics::SimulationOptions& options) {
    return measure_model(
        name, [&] { return bench_beam(beam); }, options);
}

Result<BenchFigures> measure_model(const std::string& name, const std::function<model::Model()>& make,
                                   const dynamics::SimulationOptions& options) {
    const double start = thread_time_s();
    const model::Model model = make();
    const double run_start = thread_time_s();
    const dynamics::Trace trace = dynamics::simulate(model, options);
    const double end = thread_time_s();
    if (!trace.complete()) return Error{trace.message, name};
    BenchFigures figures = figures_of(name, model, trace, options);
    figures.setup_s = run_start - start;
    figures.run_s = end - run_start;
    figures.limit_ms = limit_ms(trace, model);
    figures.factor_bytes = trace.factor_bytes;
    figures.times = trace.times;
    return figures;
}

}  // namespace myo::bench
