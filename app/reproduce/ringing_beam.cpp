#include "reproduce/ringing_beam.hpp"

#include "base/text.hpp"
#include "bench/beam_statics.hpp"
#include "dynamics/simulate.hpp"

namespace myo::reproduce {

Result<RingingBeam> ringing_beam(const PaperBeam& beam) {
    RingingBeam result{beam, make_paper_beam(beam), {}, {}};
    const Result<Eigen::Matrix3Xd> rest = bench::beam_equilibrium(result.model);
    if (!rest) return rest.error();
    result.equilibrium = *rest;
    dynamics::StageSolver solver(result.model);
    // A square section has two equal bending modes; the one along z is excited.
    const dynamics::NaturalModes modes = dynamics::natural_modes(solver, result.equilibrium, 2);
    if (!modes.ok()) return Error{"the beam's first vibration was not found", ""};
    // Share of the z components in the length of the shape.
    const auto vertical = [](const dynamics::NaturalMode& mode) {
        return mode.shape.row(2).norm() / mode.shape.norm();
    };
    result.mode = vertical(modes.modes[0]) > vertical(modes.modes[1]) ? modes.modes[0] : modes.modes[1];
    return result;
}

Result<RungBeam> ring(const RingingBeam& beam, const RingingRun& run, const Progress& progress) {
    model::Model model = beam.model;
    model.velocity_force_1_s = run.velocity_force_1_s;
    model.damping_s = run.damping_s;
    dynamics::SimulationOptions options;
    options.integrator = run.scheme;
    options.h_s = run.h_s;
    // The run starts at rest in the straight shape, as the defaults of the options say.
    options.end_s = run.end_s;
    const dynamics::Trace trace = dynamics::simulate(model, options, progress.with_sink({}));
    if (!trace.complete()) return Error{trace.message, "release at h = " + format_number(1e3 * run.h_s, 3) + " ms"};
    const Eigen::Matrix3Xd weight = model::times_mass(beam.mode.shape, model::mass_matrix(model));
    const auto count = static_cast<Eigen::Index>(trace.times_s.size());
    RungBeam result{{}, Eigen::Map<const Eigen::VectorXd>(trace.times_s.data(), count), Eigen::VectorXd(count)};
    const std::array<mesh::BoundaryPoint, 3> points = bind_beam_points(model);
    Eigen::VectorXd q(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Matrix3Xd& x = trace.positions[static_cast<std::size_t>(k)];
        // Modal coordinate by mass-weighted projection: the decay of a single mode, without the others.
        q(k) = weight.cwiseProduct(x - beam.equilibrium).sum();
        result.left_dz_m(k) = beam_point_displacements(points, x - model.body->mesh.nodes)(2, left_marker);
    }
    result.vibration = inverse::fit_damped_cosine(result.times_s, q);
    if (!result.vibration.ok)
        return Error{"nothing swings", "release at h = " + format_number(1e3 * run.h_s, 3) + " ms"};
    return result;
}

}  // namespace myo::reproduce
