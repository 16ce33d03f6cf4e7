#include "validation/converged_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "mesh/box_mesh.hpp"
#include "prediction/predict_trials.hpp"
#include "setup/body_mesh.hpp"
#include "setup/first_vibration.hpp"
#include "validation/truth_model.hpp"

namespace myo::validation {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Positions per trial and marker, 3 x samples [m], mesh frame.
using Motions = std::vector<std::vector<Matrix3Xd>>;

/// Structured mesh with this number of layers through the thickness: tet10 in boxes, hex8 following the taper.
setup::BodyMesh layered_mesh(const SyntheticBody& body, int layers) {
    const ConvergencePolicy& p = convergence_policy;
    const Vector3d size = body.bounds.size();
    // Height of a layer; the other edges follow from the aspects of the policy.
    const double across = body.thickness_m / layers;
    const auto cells = [&](int axis, double aspect) {
        return std::max(layers, static_cast<int>(std::ceil(size(axis) / (aspect * across))));
    };
    const int wide = cells(1, p.width_aspect);
    // Even numbers of mirrored cells keep the symmetry of the body.
    const Eigen::Vector3i counts(cells(0, p.length_aspect), wide + wide % 2, layers);
    setup::BodyMesh mesh;
    mesh.resolution_m = across;
    if (body.is_declared_box()) {
        mesh.element = fem::ElementKind::tet10;
        mesh.mesh = mesh::tet_box_mesh(body.bounds, counts, mesh::CellType::tet10, mesh::Diagonals::mirrored);
        return mesh;
    }
    mesh.element = fem::ElementKind::hex8;
    mesh.mesh = mesh::box_hex_mesh(body.bounds, counts);
    // Nodes of the box move with the taper, so that the cells follow it.
    for (auto node : mesh.mesh.nodes.colwise()) node = body.tapered(node);
    return mesh;
}

/// Longest integer fraction of a sampling interval not longer than `longest_s` [s]: steps then meet all samples.
double step_within(const setup::PreparedTrial& trial, double longest_s) {
    const double interval_s = setup::sampling_interval_s(trial);
    return interval_s / std::max(1.0, std::ceil(interval_s / longest_s - 1e-9));
}

/// Marker motions of all trials, with the steps of the setup times `part_of_step`; the setup is as before on return.
///
/// Errors: a trial that does not run; cancelled.
Result<Motions> motions(setup::Setup& setup, const prediction::ParameterValues& values, double part_of_step,
                        const Progress& progress) {
    Motions all;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const double whole_s = setup.trials[t].options.h_s;
        setup::set_step(setup.trials[t], part_of_step * whole_s);
        const prediction::TrialPrediction prediction = prediction::predict_trial(setup, t, values, {}, progress);
        setup::set_step(setup.trials[t], whole_s);
        if (progress.cancelled()) return Error{"cancelled", ""};
        if (!prediction.ok())
            return Error{"the truth of trial " + setup.trials[t].name + " does not run: " + prediction.message, ""};
        all.push_back(prediction.positions_m);
    }
    return all;
}

/// Correction by extrapolated(), rms over the rms of the motion about its mean [-]; 0 if nothing moves.
double path_change(const Motions& fine, const Motions& coarse) {
    double changed = 0.0, moved = 0.0;
    for (std::size_t t = 0; t < fine.size(); ++t)
        for (std::size_t m = 0; m < fine[t].size(); ++m) {
            changed += (fine[t][m] - coarse[t][m]).squaredNorm();
            moved += (fine[t][m].colwise() - fine[t][m].rowwise().mean()).squaredNorm();
        }
    // The correction is a third of the difference.
    return moved > 0.0 ? std::sqrt(changed / moved) / 3.0 : 0.0;
}

/// Richardson extrapolation over the time step, second order (Roache 1997): fine + (fine - coarse) / 3.
Motions extrapolated(Motions fine, const Motions& coarse) {
    for (std::size_t t = 0; t < fine.size(); ++t)
        for (std::size_t m = 0; m < fine[t].size(); ++m) fine[t][m] += (fine[t][m] - coarse[t][m]) / 3.0;
    return fine;
}

/// Largest relative change of a frequency; infinite without earlier ones.
double change_of(const std::vector<double>& now, const std::vector<double>& before) {
    double change = before.empty() ? std::numeric_limits<double>::infinity() : 0.0;
    for (std::size_t i = 0; i < std::min(now.size(), before.size()); ++i)
        change = std::max(change, std::abs(now[i] / before[i] - 1.0));
    return change;
}

/// The lowest frequencies; for nearly incompressible plates only the first, as the second is not found.
std::vector<double> frequencies_rad_s(const model::Model& model) {
    std::vector<double> found;
    for (int count = convergence_policy.frequencies; count > 0 && found.empty(); --count)
        found = setup::slowest_vibrations_rad_s(model, count);
    return found;
}

/// Factor on the modulus with which a mesh has the frequency of an infinitely fine one (Richardson extrapolation over
/// the layers; frequency is proportional to the root of the modulus).
double modulus_factor(double own, double fine, double coarse, int fine_layers, int coarse_layers) {
    const double ratio = std::pow(static_cast<double>(fine_layers) / coarse_layers, convergence_policy.mesh_order);
    const double exact = fine + (fine - coarse) / (ratio - 1.0);
    return std::pow(exact / own, 2);
}

/// Increment of layers; even, see layered_mesh().
constexpr int layers_more = 2;

/// The coarser or the finer of the first two meshes between which the first frequencies have converged. Fills in the
/// frequency, its change and the factor on the modulus.
///
/// Errors: no vibration is found; no convergence within max_layers; cancelled.
Result<setup::Setup> settled_mesh(const SyntheticCase& c, const setup::Setup& prepared, ConvergedTruth& truth,
                                  const Progress& progress) {
    const ConvergencePolicy& p = convergence_policy;
    std::optional<setup::Setup> coarser;
    std::vector<double> before;
    const int first = c.body.is_declared_box() ? p.first_layers_of_tets : p.first_layers_of_hexes;
    for (int layers = first; layers <= p.max_layers; layers += layers_more) {
        if (progress.cancelled()) return Error{"cancelled", ""};
        Result<setup::Setup> setup = on_mesh(prepared, layered_mesh(c.body, layers));
        if (!setup) return setup;
        const std::vector<double> now = frequencies_rad_s(prediction::trial_model(*setup, 0, true_values(c, *setup)));
        if (now.empty()) return Error{"the truth has no first vibration", c.name()};
        truth.frequency_Hz = now.front() / (2.0 * std::numbers::pi);
        // Converged if refinement by two layers changes no frequency by more than the policy allows.
        truth.frequency_change = change_of(now, before);
        if (truth.frequency_change < p.max_change) {
            // If the change is tiny the coarser mesh suffices, with the modulus that corrects its frequency.
            const bool coarse = truth.frequency_change < p.coarse_enough;
            truth.modulus_factor = modulus_factor(coarse ? before.front() : now.front(), now.front(), before.front(),
                                                  layers, layers - layers_more);
            return coarse ? std::move(*coarser) : std::move(setup);
        }
        coarser = std::move(*setup);
        before = now;
    }
    return Error{"the truth's frequencies do not settle with " + std::to_string(p.max_layers) + " layers", c.name()};
}

}  // namespace

Result<ConvergedTruth> converged_truth(const SyntheticCase& c, const experiment::Experiment& experiment,
                                       const Progress& progress) {
    const ConvergencePolicy& p = convergence_policy;
    const Progress silent = progress.with_sink({});
    Result<setup::Setup> prepared = setup::prepare_setup(experiment, {}, silent);
    if (!prepared) return prepared.error();
    ConvergedTruth truth;
    Result<setup::Setup> setup = settled_mesh(c, *prepared, truth, silent);
    if (!setup) return setup.error();
    truth.dofs = setup->body->dofs();
    prediction::ParameterValues values = true_values(c, *setup);
    // Corrects the frequency of the chosen mesh to that of an infinitely fine one.
    values.youngs_modulus_Pa *= truth.modulus_factor;
    for (setup::PreparedTrial& trial : setup->trials)
        setup::set_step(trial, step_within(trial, 1.0 / (p.steps_per_period * truth.frequency_Hz)));
    // The step is halved until the extrapolation changes the path by less than the policy allows.
    Result<Motions> coarse = motions(*setup, values, 1.0, silent);
    if (!coarse) return coarse.error();
    double part = 1.0;
    for (int halving = 0; halving < p.max_halvings; ++halving) {
        part *= 0.5;
        Result<Motions> fine = motions(*setup, values, part, silent);
        if (!fine) return fine.error();
        truth.path_change = path_change(*fine, *coarse);
        if (truth.path_change < p.max_path_change) {
            truth.positions_m = extrapolated(std::move(*fine), *coarse);
            return truth;
        }
        coarse = std::move(fine);
    }
    return Error{"the truth's path does not settle with the step", c.name()};
}

}  // namespace myo::validation
