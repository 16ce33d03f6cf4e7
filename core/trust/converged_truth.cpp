#include "trust/converged_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mesh/box_mesh.hpp"
#include "project/first_vibration.hpp"
#include "project/predict_trials.hpp"
#include "project/study_mesh.hpp"
#include "trust/truth_model.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using Motions = std::vector<std::vector<Matrix3Xd>>;   // per trial and marker

StudyMesh layered_mesh(const SyntheticBody& body, int layers) {
    const ConvergencePolicy& p = convergence_policy;
    const Vector3d size = body.bounds.size();
    const double across = body.thickness_m / layers;
    const auto cells = [&](int axis, double aspect) {
        return std::max(layers, static_cast<int>(std::ceil(size(axis) / (aspect * across))));
    };
    const Eigen::Vector3i counts(cells(0, p.length_aspect), cells(1, p.width_aspect), layers);
    StudyMesh mesh;
    mesh.resolution_m = across;
    if (body.is_declared_box()) {
        mesh.element = ElementKind::tet10;
        mesh.mesh = tet_box_mesh(body.bounds, counts, CellType::tet10);
        return mesh;
    }
    mesh.element = ElementKind::hex8;
    mesh.mesh = box_hex_mesh(body.bounds, counts);
    for (auto node : mesh.mesh.nodes.colwise()) node = body.tapered(node);
    return mesh;
}

/// Whole parts of a sampling interval, no longer than asked for.
double step_within(const StudyTrial& trial, double longest_s) {
    const double interval_s = sampling_interval_s(trial);
    return interval_s / std::max(1.0, std::ceil(interval_s / longest_s - 1e-9));
}

Result<Motions> motions(Study& study, const StudyValues& values, double part_of_step, const Progress& progress) {
    Motions all;
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        const double whole_s = study.trials[t].options.h_s;
        set_step(study.trials[t], part_of_step * whole_s);
        const TrialPrediction prediction = predict_trial(study, t, values, {}, progress);
        set_step(study.trials[t], whole_s);
        if (progress.cancelled()) return Error{"cancelled", ""};
        if (!prediction.ok())
            return Error{"the truth of trial " + study.trials[t].name + " does not run: " + prediction.message, ""};
        all.push_back(prediction.positions_m);
    }
    return all;
}

/// What extrapolated() adds, rms over the rms of the motion about its mean.
double path_change(const Motions& fine, const Motions& coarse) {
    double changed = 0.0, moved = 0.0;
    for (std::size_t t = 0; t < fine.size(); ++t)
        for (std::size_t m = 0; m < fine[t].size(); ++m) {
            changed += (fine[t][m] - coarse[t][m]).squaredNorm();
            moved += (fine[t][m].colwise() - fine[t][m].rowwise().mean()).squaredNorm();
        }
    return moved > 0.0 ? std::sqrt(changed / moved) / 3.0 : 0.0;
}

/// Second-order errors of the step taken off (Roache 1997).
Motions extrapolated(Motions fine, const Motions& coarse) {
    for (std::size_t t = 0; t < fine.size(); ++t)
        for (std::size_t m = 0; m < fine[t].size(); ++m) fine[t][m] += (fine[t][m] - coarse[t][m]) / 3.0;
    return fine;
}

/// The first mesh with which the first frequency has settled.
Result<Study> settled_mesh(const SyntheticCase& c, const Study& prepared, ConvergedTruth& truth,
                           const Progress& progress) {
    const ConvergencePolicy& p = convergence_policy;
    std::optional<Study> coarser;
    for (int layers = p.first_layers; layers <= p.most_layers; ++layers) {
        if (progress.cancelled()) return Error{"cancelled", ""};
        Result<Study> study = on_mesh(prepared, layered_mesh(c.body, layers));
        if (!study) return study;
        const double before_Hz = truth.frequency_Hz;
        truth.frequency_Hz =
            first_vibration_rad_s(trial_model(*study, 0, true_values(c, *study))) / (2.0 * std::numbers::pi);
        if (!(truth.frequency_Hz > 0.0)) return Error{"the truth has no first vibration", c.name()};
        truth.frequency_change = std::abs(truth.frequency_Hz / before_Hz - 1.0);
        if (coarser && truth.frequency_change < p.coarse_enough) return std::move(*coarser);
        if (coarser && truth.frequency_change < p.most_change) return study;
        coarser = std::move(*study);
    }
    return Error{"the truth's frequency does not settle with " + std::to_string(p.most_layers) + " layers", c.name()};
}

}  // namespace

Result<ConvergedTruth> converged_truth(const SyntheticCase& c, const Experiment& experiment,
                                       const Progress& progress) {
    const ConvergencePolicy& p = convergence_policy;
    const Progress silent = progress.with_sink({});
    Result<Study> prepared = prepare_study(experiment, {}, silent);
    if (!prepared) return prepared.error();
    ConvergedTruth truth;
    Result<Study> study = settled_mesh(c, *prepared, truth, silent);
    if (!study) return study.error();
    truth.dofs = study->body->dofs();
    const StudyValues values = true_values(c, *study);
    for (StudyTrial& trial : study->trials)
        set_step(trial, step_within(trial, 1.0 / (p.steps_per_period * truth.frequency_Hz)));
    Result<Motions> coarse = motions(*study, values, 1.0, silent);
    if (!coarse) return coarse.error();
    double part = 1.0;
    for (int halving = 0; halving < p.most_halvings; ++halving) {
        part *= 0.5;
        Result<Motions> fine = motions(*study, values, part, silent);
        if (!fine) return fine.error();
        truth.path_change = path_change(*fine, *coarse);
        if (truth.path_change < p.most_change) {
            truth.positions_m = extrapolated(std::move(*fine), *coarse);
            return truth;
        }
        coarse = std::move(fine);
    }
    return Error{"the truth's path does not settle with the step", c.name()};
}

}  // namespace myo
