#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "bench/backward_run.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "bench/kept_cells.hpp"
#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/closest_point.hpp"
#include "mesh/region.hpp"
#include "model/cavity_pressure.hpp"
#include "model/tendon.hpp"

namespace myo::bench {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double share_of_plain = 1.3;  // time of an actuated body over that of the plain one, at most

/// What drives a body.
enum class Drive { chamber, tendons };

/// A bar with an actuator, or the same bar without it.
struct ActuatedBar {
    Drive drive = Drive::chamber;
    Vector3i cells;
    bool actuated = true;
};

/// From 0 up to `highest` and back within 0.4 s, again and again.
fibre::Signal breathing(double highest) {
    fibre::Signal signal{{}, {}};
    for (int k = 0; k <= 200; ++k) {
        signal.times_s.push_back(0.02 * k);
        signal.values.push_back(0.5 * highest * (1.0 - std::cos(2.0 * std::numbers::pi * 0.05 * k)));
    }
    return signal;
}

/// Silicone of 240 kPa on a mesh that is held in a box.
model::Model silicone(mesh::VolumeMesh mesh, const Box& held, std::vector<std::vector<int>> couplings) {
    const std::vector<int> clamped = mesh::nodes_in_box(mesh, held);
    model::Model model;
    model.body = model::make_body(std::move(mesh), fem::ElementKind::hex8, clamped, std::move(couplings));
    model.material = material::find_material("neo_hookean");
    model.moduli = model::uniform_moduli(model.body->cell_count(), 2.4e5, 0.49);
    model.density_kg_m3 = 1070.0;
    model.damping_s = 0.003;
    model.gravity_m_s2 = Vector3d(0.0, 0.0, -9.81);
    return model;
}

/// Finger of 75 x 20 x 20 mm, clamped at x = 0, with a chamber in its upper half under up to 20 kPa.
model::Model finger(const ActuatedBar& bar) {
    const Vector3d size(0.075, 0.02, 0.02);
    const mesh::VolumeMesh whole = mesh::box_hex_mesh({Vector3d::Zero(), size}, bar.cells);
    const Vector3d lowest(0.0075, 0.005, 0.010), highest(0.0675, 0.015, 0.015);
    mesh::VolumeMesh hollow = kept_cells(whole, [&](const Vector3d& middle) {
        return (middle.array() < lowest.array()).any() || (middle.array() > highest.array()).any();
    });
    model::Model model = silicone(std::move(hollow), {{-1e-6, -1.0, -1.0}, {1e-6, 1.0, 1.0}}, {});
    // The only cavity is the chamber.
    if (bar.actuated)
        model.force_elements.push_back(
            model::cavity_pressure(*model.body, model::closed_cavities(*model.body).front(), breathing(2e4)));
    return model;
}

/// Arm of 160 x 16 x 16 mm across gravity, clamped at z = 0, with two tendons through nine guides each, 5 mm off the
/// axis, of which one pulls with up to 1 N.
model::Model arm_with_tendons(const ActuatedBar& bar) {
    mesh::VolumeMesh mesh = mesh::box_hex_mesh({{-0.008, -0.008, -0.16}, {0.008, 0.008, 0.0}}, bar.cells);
    const Box held{{-1.0, -1.0, -1e-6}, {1.0, 1.0, 1e-6}};
    const auto across_gravity = [](model::Model model) {
        model.gravity_m_s2 = Vector3d(-9.81, 0.0, 0.0);
        return model;
    };
    if (!bar.actuated) return across_gravity(silicone(std::move(mesh), held, {}));
    const mesh::BoundaryLocator boundary(mesh);
    std::vector<model::TendonRoute> routes;
    std::vector<std::vector<int>> couplings;
    for (const double side : {-0.005, 0.005}) {
        model::TendonRoute& route = routes.emplace_back();
        route.first_coupling = couplings.size();
        for (int k = 0; k < 9; ++k) {
            const Vector3d guide(side, 0.0, -0.019 * k);
            route.guides.push_back({std::nullopt, guide});
            // The first guide stands still: the motor's end.
            if (k > 0) route.guides.back().on_body = fem::material_point(mesh, boundary, guide);
        }
        for (std::vector<int>& group : model::tendon_couplings(route.guides, false))
            couplings.push_back(std::move(group));
    }
    // Couplings before the body is made: its sparsity pattern contains them.
    model::Model model = across_gravity(silicone(std::move(mesh), held, std::move(couplings)));
    for (const model::TendonRoute& route : routes)
        model.force_elements.push_back(
            model::tendon_of_tension(route, breathing(model.force_elements.empty() ? 1.0 : 0.0)));
    return model;
}

model::Model actuated_bar(const ActuatedBar& bar) {
    return bar.drive == Drive::chamber ? finger(bar) : arm_with_tendons(bar);
}

/// Name of a row.
std::string words(const ActuatedBar& bar) {
    return std::string(bar.drive == Drive::chamber ? "finger with a chamber, " : "arm with two tendons, ") +
           std::to_string(bar.cells.prod()) + " cells of the whole";
}

/// Box around the free end [m].
Box tip(const ActuatedBar& bar) {
    return bar.drive == Drive::chamber ? Box{{0.075 - 1e-6, -1.0, -1.0}, {1.0, 1.0, 1.0}}
                                       : Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, -0.16 + 1e-6}};
}

/// One period of breathing(), with the default integrator.
dynamics::SimulationOptions options() { return bench_options(dynamics::Integrator::tr_bdf2, 0.01, 40, 1e-6); }

/// Figures of the actuated body, with the time of the plain one, which is run before it, as goal and note.
template <class Measure>
Result<BenchFigures> beside_plain(ActuatedBar bar, const Measure& measure) {
    bar.actuated = false;
    const Result<BenchFigures> plain = measure(bar);
    if (!plain) return plain;
    bar.actuated = true;
    Result<BenchFigures> figures = measure(bar);
    if (!figures) return figures;
    figures->goal_ms = share_of_plain * plain->ms_per_step();
    figures->note = "plain body " + format_number(plain->ms_per_step(), 3) + " ms" +
                    (plain->iterations_per_step > 0.0
                         ? " and " + format_number(plain->iterations_per_step, 3) + " iterations"
                         : std::string()) +
                    " a step; actuated over plain " + format_number(figures->ms_per_step() / plain->ms_per_step(), 3);
    return figures;
}

/// Rows of a body: the run, and the backward pass.
BenchRun forward(const ActuatedBar& bar) {
    return {words(bar) + ", forward", [bar] {
                return beside_plain(bar, [](const ActuatedBar& one) {
                    return measure_model(
                        words(one) + ", forward", [&] { return actuated_bar(one); }, options());
                });
            }};
}

BenchRun backward(const ActuatedBar& bar) {
    return {words(bar) + ", backward", [bar] {
                return beside_plain(bar, [](const ActuatedBar& one) {
                    return measure_backward(words(one), actuated_bar(one), tip(one), options(), {});
                });
            }};
}

}  // namespace

BenchCase bench_actuators() {
    BenchCase made{"actuators", "bodies with chambers and tendons beside the plain body, h = 10 ms, 40 steps", {}};
    for (const ActuatedBar& bar : {ActuatedBar{Drive::chamber, {30, 8, 8}}, ActuatedBar{Drive::chamber, {50, 12, 12}},
                                   ActuatedBar{Drive::tendons, {48, 5, 5}}, ActuatedBar{Drive::tendons, {80, 8, 8}}}) {
        made.runs.push_back(forward(bar));
        made.runs.push_back(backward(bar));
    }
    return made;
}

}  // namespace myo::bench
