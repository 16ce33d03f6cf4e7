#pragma once

#include "diagnosis/diagnose_settings.hpp"
#include "diagnosis/discretisation/refinement.hpp"
#include "diagnosis/selection/judged_fit.hpp"

namespace myo::diagnosis {

/// What the phases after the declared fit are given: the same constant values for all of them.
struct DiagnosisContext {
    setup::Setup setup;         // with element, tolerances, steps, iteration limits and modulus factor of all fits
    DiagnoseSettings settings;  // policy, excluded effects, numbers of fits
    FitData data;               // of the fit trials, with the shift of the declared fit
    JudgedFit declared;         // reference of all comparisons, its numerical error removed
    NumericalError numerics;    // of the declared fit
    Refinement refinement;      // from which the numerical error of other fits is computed

    const DiagnosisPolicy& policy() const { return settings.policy; }
    /// Number of fit trials.
    int fit_count() const { return static_cast<int>(data.trials.size()); }
    /// Declared fit, data and policy, against which other fits are judged.
    Baseline baseline() const { return {declared, data, numerics, settings}; }
};

/// Setup for a diagnosis: with an element that resolves every effect that may be named, the solver tolerances of the
/// policy, and stored paths, from which similar runs start.
/// Tolerances looser than those of the policy are kept.
setup::Setup prepared_setup(const setup::Setup& as_declared, const DiagnoseSettings& settings);

/// Setup with an element that resolves every effect that may be named. All fits of a diagnosis use it: two elements
/// differ by more than small effects do.
setup::Setup for_candidates(setup::Setup setup, const DiagnoseSettings& settings);

}  // namespace myo::diagnosis
