#pragma once

#include <memory>
#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// Deletes stored paths: they need the memory of many runs and are kept only where further runs start.
void forget_paths(std::vector<prediction::TrialPrediction>& predictions);

/// Predictions with the values of a fit, with the levels of validation trials derived from those of the fit trials.
std::vector<prediction::TrialPrediction> fitted_predictions(const setup::Setup& setup,
                                                            const std::vector<std::size_t>& trials,
                                                            const prediction::ParameterValues& fitted,
                                                            const Progress& progress);

/// From what the numerical errors of a setup's runs are computed.
struct Refinement {
    std::shared_ptr<const setup::Setup> finer;  // same setup on a finer mesh; null: none is wanted or could be made
    NumericalError unmatched;                   // error with which the effective modulus was found; default: none was
};

/// Setup on a finer mesh, with the steps of `setup`: about NumericsPolicy::fine_unknowns unknowns, its edge length
/// within the limits of the policy.
/// `finer` is null if `refine_mesh` is false or the body cannot be meshed more finely.
Refinement refined(const setup::Setup& setup, bool refine_mesh, const NumericsPolicy& policy, const Progress& progress);

/// Where the numerical error is computed. Refers to values that outlive the call.
struct ErrorTask {
    const setup::Setup& setup;  // whose modulus factor is that of refinement.unmatched.effective_modulus
    const Refinement& refinement;
    const prediction::ParameterValues& fitted;
    const std::vector<std::size_t>& trials;
    const NumericalError* known = nullptr;   // with similar values, null: none; see numerical_error()
    const MatchedValues* matched = nullptr;  // values of the runs; null: those of the fit in all runs
};

/// numerical_error() at the values of a fit. The shift applies to predictions with task.fitted, also if other values
/// are matched.
NumericalError error_at(const ErrorTask& task, const NumericsPolicy& policy, const Progress& progress);

}  // namespace myo::diagnosis
