#pragma once

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/verdict/verdict.hpp"
#include "prediction/run_trials.hpp"

namespace myo::diagnosis {

/// Input of final_fit(). Refers to values that outlive it.
struct FinalFitInput {
    const DiagnosisContext& context;
    const NumericalError& declared_error;  // of the declared fit, for all trials
    const Decision& decision;
    const PredictionShift& shift;   // with which the fit of the decision was made
    bool corrects_attempts = true;  // false: a best attempt that explains nothing keeps the error of the declared fit
};

/// Fit of the verdict with the numerical error of its own motion removed, and predictions of all trials.
struct FinalFit {
    JudgedFit fit;
    prediction::SetupRun before, after;  // with the declared fit, and with this one; numerical error removed
    std::vector<std::string> notes;      // markers that sit far from their declared places
    bool complete = false;               // false: cancelled
};

/// Corrects the fit of the verdict unless that was done in the search, and predicts all trials. The effort is smaller
/// if the fit is only the best attempt.
FinalFit final_fit(const FinalFitInput& in, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
