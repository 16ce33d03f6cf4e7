#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "model/elastic_bed.hpp"
#include "model/law_force.hpp"
#include "model/loaded_face.hpp"
#include "model/surface_drag.hpp"

namespace myo::bench {
namespace {

constexpr double most_over_built_in = 1.5;  // time of a step with a law over that with the element that it repeats
// Quadratic drag of the surface, and stiffness of an elastic bed.
constexpr double drag_kg_m3 = 3000.0, bed_Pa_m = 1e5;

/// The default beam with one force on its free surface.
model::Model beam_with(
    const std::function<model::ForceElementPointer(const model::Body&, const std::vector<int>&)>& make) {
    model::Model model = bench_beam({fem::ElementKind::hex8, {23, 7, 7}, "neo_hookean", 0.003});
    model.force_elements.push_back(make(*model.body, model::free_faces(*model.body)));
    return model;
}

/// A law on the free surface with one number.
///
/// @param traction  expression of the traction on the surface [Pa], in u [m], v [m/s] and `parameter`
model::ForceElementPointer law_of(const model::Body& body, const std::vector<int>& faces, const std::string& parameter,
                                  const std::string& traction, double number) {
    law::LawText text;
    text.parameters = {{parameter, law::Shape::number, {}}};
    text.key = law::result_keys(law::Place::surface).front();
    text.result = traction;
    const Eigen::VectorXd numbers = Eigen::VectorXd::Constant(1, number);
    auto programs = model::law_programs(std::get<law::Law>(law::make_law(text)), numbers);
    auto points = std::make_shared<const std::vector<model::LawCarrier>>(model::law_points_of_faces(body, faces));
    return model::law_force(programs, points, {}, numbers, numbers);
}

/// Runs with the element of the core, and with the law that repeats it, in one row: the shortest of several runs each.
BenchRun compared(const std::string& name, const std::function<model::Model()>& built_in,
                  const std::function<model::Model()>& of_law) {
    return {name, [=]() -> Result<BenchFigures> {
                const dynamics::SimulationOptions options = bench_options(dynamics::Integrator::tr_bdf2, 0.01, 80,
                                                                          1e-6);
                std::optional<BenchFigures> best_law, best_built_in;
                const auto keep = [](std::optional<BenchFigures>& best, BenchFigures figures) {
                    if (!best || figures.run_s < best->run_s) best = std::move(figures);
                };
                // In turn, so that both see the same load of the machine.
                for (int repeat = 0; repeat < 3; ++repeat) {
                    Result<BenchFigures> own = measure_model(name, of_law, options),
                                         other = measure_model(name, built_in, options);
                    if (!own) return own.error();
                    if (!other) return other.error();
                    keep(best_law, std::move(*own));
                    keep(best_built_in, std::move(*other));
                }
                best_law->references = {{"built in", best_built_in->ms_per_step()}};
                best_law->goal_ms = most_over_built_in * best_built_in->ms_per_step();
                return *best_law;
            }};
}

}  // namespace

BenchCase bench_laws() {
    return {"laws",
            "a step with a law from a file, beside one with the element of the core that it repeats",
            {compared(
                 "drag on the surface",
                 [] {
                     return beam_with([](const model::Body& body, const std::vector<int>& faces) {
                         return model::surface_drag(body, faces, 0.0, drag_kg_m3);
                     });
                 },
                 [] {
                     return beam_with([](const model::Body& body, const std::vector<int>& faces) {
                         return law_of(body, faces, "c_kg_m3", "-c_kg_m3 * norm(v) * v", drag_kg_m3);
                     });
                 }),
             compared(
                 "springs on the surface",
                 [] {
                     return beam_with([](const model::Body& body, const std::vector<int>& faces) {
                         return model::elastic_bed(body, faces, bed_Pa_m);
                     });
                 },
                 [] {
                     return beam_with([](const model::Body& body, const std::vector<int>& faces) {
                         return law_of(body, faces, "k_Pa_per_m", "-k_Pa_per_m * u", bed_Pa_m);
                     });
                 })}};
}

}  // namespace myo::bench
