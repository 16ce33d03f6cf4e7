#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>

#include "bench/beam_run.hpp"
#include "bench/beam_statics.hpp"
#include "bench/bench_cases.hpp"
#include "bench/published_beam.hpp"

namespace myo::bench {
namespace {

/// Vertical displacement of one node in static equilibrium [mm].
Result<double> rest_dz_mm(const model::Model& model, int node) {
    const Result<Eigen::Matrix3Xd> x = beam_equilibrium(model);
    if (!x) return x.error();
    return 1e3 * ((*x)(2, node) - model.body->mesh.nodes(2, node));
}

/// Our run of the published formulation compared with the trace of the published program; if the data are missing, with
/// its static position only.
Result<BenchFigures> beside_trace(const PublishedTrace& published) {
    const std::filesystem::path path = data_folder() / "design/reference" / published.file;
    std::optional<NodeTrace> reference;
    if (std::filesystem::exists(path)) {
        Result<NodeTrace> read = read_node_trace(path);
        if (!read) return read.error();
        reference = std::move(*read);
    }
    const model::Model model = published_beam(published);
    const int node = published_node(model.body->mesh);
    // As many as the trace has.
    const int steps = reference ? static_cast<int>(reference->times_s.size()) - 1 : 160;
    const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::implicit_euler, published.h_s,
                                                              steps, 1e-6);
    const double start = thread_time_s();
    const dynamics::Trace trace = dynamics::simulate(model, options);
    const double end = thread_time_s();
    if (!trace.complete()) return Error{trace.message, published.file};
    BenchFigures figures = figures_of("as published, beside " + published.file, model, trace, options);
    figures.run_s = end - start;
    if (reference)
        figures.quantities.push_back({"largest deviation from the trace, of its deflection",
                                      100.0 * trace_deviation(trace, node, *reference),
                                      "%",
                                      {}});
    else
        figures.note = "without its trace: MYOLOOP_DATA names no folder of the data, and ../shared is none";
    // The published program gives every vertex the mass of a cube, which makes the beam too heavy.
    model::Model light = model;  // equal vertex masses, scaled to the true total mass of the body
    light.density_kg_m3 *= light.density_kg_m3 * light.body->volume_m3 / model::mass_matrix(light).nodal_kg.sum();
    for (const auto& [name, variant, expected] :
         {std::tuple{"node at rest, dz", &model, published.rest_dz_mm},
          {"node at rest, total mass corrected, dz", &light, published.true_mass_dz_mm}}) {
        const Result<double> rest = rest_dz_mm(*variant, node);
        if (!rest) return Error{rest.error().text(), published.file};
        figures.quantities.push_back({name, *rest, "mm", expected});
    }
    return figures;
}

/// Lower edge of the tip under gravity and 0.991 N on its upper edge, estimated from a quadratic element with linear
/// pressures at 91 thousand unknowns (-24.80).
constexpr double converged_loaded_dz_mm = -24.83;

/// The default model of the same beam at its true size, compared with the converged deflection.
Result<BenchFigures> honest(const Eigen::Vector3i& cells) {
    const BenchBeam beam{fem::ElementKind::hex8, cells, "neo_hookean", 0.003};
    Result<BenchFigures> figures = measure_run("default model, TR-BDF2", beam,
                                               bench_options(dynamics::Integrator::tr_bdf2, 0.01, 160, 1e-6));
    if (!figures) return figures;
    const model::Model unloaded = static_beam(beam, 0.499);
    model::Model loaded = unloaded;
    loaded.forces.push_back(force_on_upper_tip_edge(loaded.body->mesh, -0.991));
    for (const auto& [what, model, expected] :
         {std::tuple{"tip at rest, dz", &unloaded, converged_beam.back().dz_mm},
          {"tip at rest with 0.991 N on its upper edge, dz", &loaded, converged_loaded_dz_mm}}) {
        BenchFigures statics;
        const Result<double> dz = measured_tip_dz_mm(*model, statics);
        if (!dz) return dz.error();
        figures->quantities.push_back({what, *dz, "mm", expected});
    }
    return figures;
}

}  // namespace

BenchCase bench_published() {
    BenchCase result{"published",
                     "the formulation as published against traces of the published program, and the default model "
                     "against converged values",
                     {}};
    for (const PublishedTrace& trace : published_traces())
        result.runs.push_back({trace.file, [trace] { return beside_trace(trace); }});
    for (const Eigen::Vector3i& cells : {Eigen::Vector3i(23, 7, 7), Eigen::Vector3i(32, 9, 9)})
        result.runs.push_back(
            {"default model, " + std::to_string(cells(1)) + " layers", [cells] { return honest(cells); }});
    return result;
}

}  // namespace myo::bench
