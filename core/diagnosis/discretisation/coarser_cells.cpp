#include "diagnosis/discretisation/coarser_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "prediction/predict_trials.hpp"
#include "setup/refined_setup.hpp"

namespace myo::diagnosis {
namespace {

using Predictions = std::vector<prediction::TrialPrediction>;

/// The setup with the mesh of another one of the same experiment, and everything that refers to nodes and cells.
setup::Setup with_cells_of(setup::Setup setup, setup::Setup other) {
    setup.settings.mesh = other.settings.mesh;
    setup.mesh = std::move(other.mesh);
    setup.body = std::move(other.body);
    setup.part_shares = std::move(other.part_shares);
    setup.chambers = std::move(other.chambers);
    setup.tendons = std::move(other.tendons);
    setup.markers = std::move(other.markers);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) setup.trials[t].model = std::move(other.trials[t].model);
    return setup;
}

/// Whether both have the same trials: a caller may have taken some out, or read others.
bool have_same_trials(const setup::Setup& a, const setup::Setup& b) {
    return std::equal(a.trials.begin(), a.trials.end(), b.trials.begin(), b.trials.end(),
                      [](const setup::PreparedTrial& x, const setup::PreparedTrial& y) { return x.name == y.name; });
}

/// The setup on cells of `ratio` times the edge length; null if there are none, or if they save little.
std::shared_ptr<const setup::Setup> on_coarser_cells(const setup::Setup& setup, double ratio,
                                                     const NumericsPolicy& policy, const Progress& progress) {
    Result<setup::Setup> coarser = setup::refined_setup(setup, ratio, progress);
    if (!coarser || !have_same_trials(setup, *coarser) ||
        coarser->body->dofs() > policy.max_share_of_unknowns * setup.body->dofs())
        return {};
    return std::make_shared<const setup::Setup>(with_cells_of(setup, std::move(*coarser)));
}

/// Sum of (a - from_a).(b - from_b) over all finite coordinates of the markers of a trial.
double product(const prediction::TrialPrediction& a, const prediction::TrialPrediction& from_a,
               const prediction::TrialPrediction& b, const prediction::TrialPrediction& from_b) {
    double sum = 0.0;
    for (std::size_t m = 0; m < a.positions_m.size(); ++m) {
        const Eigen::ArrayXXd products = (a.positions_m[m] - from_a.positions_m[m]).array() *
                                         (b.positions_m[m] - from_b.positions_m[m]).array();
        sum += products.isFinite().select(products, 0.0).sum();
    }
    return sum;
}

/// Number of coordinates of all markers.
double coordinates(const prediction::TrialPrediction& p) {
    double count = 0.0;
    for (const Eigen::Matrix3Xd& marker : p.positions_m) count += static_cast<double>(marker.size());
    return std::max(count, 1.0);
}

/// Largest change of the prediction of a trial by other cells, without the part that one stiffness for all trials makes
/// up for [m, rms]; infinite if a run fails.
double change_by_cells(const setup::Setup& coarser, const prediction::ParameterValues& values,
                       const std::vector<std::size_t>& trials, const Predictions& reference,
                       const NumericsPolicy& policy, const Progress& progress) {
    setup::Setup stiffer = coarser;
    stiffer.modulus_factor *= 1.0 + policy.modulus_step;
    const Predictions there = prediction::predict_trials_with(coarser, values, trials, progress),
                      beyond = prediction::predict_trials_with(stiffer, values, trials, progress);
    if (!prediction::all_ok(there) || !prediction::all_ok(beyond)) return std::numeric_limits<double>::infinity();
    // Per trial: squares of the change by a stiffer body, and its product with the change by the cells.
    std::vector<double> own, mixed;
    for (std::size_t t = 0; t < there.size(); ++t) {
        own.push_back(product(beyond[t], there[t], beyond[t], there[t]));
        mixed.push_back(product(there[t], reference[t], beyond[t], there[t]));
    }
    const double all = std::accumulate(own.begin(), own.end(), 0.0),
                 share = all > 0.0 ? std::accumulate(mixed.begin(), mixed.end(), 0.0) / all : 0.0;
    double largest = 0.0;
    for (std::size_t t = 0; t < there.size(); ++t) {
        const double left = product(there[t], reference[t], there[t], reference[t]) - 2.0 * share * mixed[t] +
                            share * share * own[t];
        largest = std::max(largest, std::sqrt(std::max(left, 0.0) / coordinates(reference[t])));
    }
    return largest;
}

}  // namespace

CoarserCells coarser_cells(const setup::Setup& setup, const prediction::ParameterValues& values,
                           const std::vector<std::size_t>& trials,
                           const std::vector<prediction::TrialPrediction>& reference, double max_m,
                           const NumericsPolicy& policy, const Progress& progress) {
    CoarserCells found;
    const bool hexahedra = setup.mesh.mesh.type == mesh::CellType::hex8;
    if (!hexahedra || setup.settings.mesh.resolution_m || !prediction::all_ok(reference)) return found;
    for (const double ratio : policy.cell_ratios) {
        if (progress.cancelled()) return found;
        const std::shared_ptr<const setup::Setup> coarser = on_coarser_cells(setup, ratio, policy, progress);
        if (!coarser) continue;
        found.runs += 2 * static_cast<int>(trials.size());
        const double change_m = change_by_cells(*coarser, values, trials, reference, policy, progress);
        if (change_m > max_m) continue;
        found.setup = coarser;
        found.change_m = change_m;
        return found;
    }
    return found;
}

}  // namespace myo::diagnosis
