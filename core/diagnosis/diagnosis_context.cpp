#include "diagnosis/diagnosis_context.hpp"

#include <algorithm>

#include "effect/catalogue.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {

bool may_be_named(const DiagnoseSettings& settings, const std::string& effect) {
    return std::find(settings.without.begin(), settings.without.end(), effect) == settings.without.end();
}

setup::Setup prepared_setup(const setup::Setup& as_declared, const DiagnoseSettings& settings) {
    setup::Setup setup = for_candidates(as_declared, settings);
    const NumericsPolicy& policy = settings.policy.numerics;
    // The fits of a diagnosis are hundreds of runs: digits beyond the noise of the recordings are not paid for.
    for (setup::PreparedTrial& trial : setup.trials) {
        dynamics::SolverOptions& solver = trial.options.solver;
        solver.tolerance = std::max(policy.solver_tolerance, solver.tolerance);
        solver.tangent_tolerance = std::max(policy.tangent_tolerance, solver.tangent_tolerance);
    }
    return prediction::with_kept_paths(std::move(setup));
}

setup::Setup for_candidates(setup::Setup setup, const DiagnoseSettings& settings) {
    const std::vector<const effect::Effect*> all = effect::all_effects(setup.experiment.laws);
    // Moduli that vary within a cell and energies beyond quadratic need more nodes or points per cell.
    const bool fine = std::any_of(all.begin(), all.end(), [&](const effect::Effect* effect) {
        return effect->varies_within_cells && may_be_named(settings, effect->id);
    });
    return fine ? setup::with_fine_element(std::move(setup)) : setup;
}

}  // namespace myo::diagnosis
