#pragma once

#include <optional>
#include <string>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"

namespace myo::diagnosis {

/// Input of a correction.
struct CorrectionInput {
    const setup::Setup& setup;
    const FitData& data;  // with the shift of the fit that is corrected
    const DiagnoseSettings& settings;
    const Refinement& refinement;
    std::string phase;  // under which refits are logged
    ErrorCorrection correction;
};

/// Computes the numerical error at a fit and refits with the error removed; repeats while the fit changes, because the
/// error depends on the motion.
///
/// If the error of a fit with effects is large, the fit's parameters are matched between the coarse and the refined
/// runs, and only the remaining error is removed, see match_discretisation().
/// @return  the corrected fit with its error and the criterion and weight of the given one; the given fit, without an
///          error, if no refit is usable or one is far worse. Empty if cancelled.
std::optional<JudgedFit> correct_discretisation(const CorrectionInput& in, JudgedFit fit, FitStore& store,
                                                PhaseLog& log);

/// Declared fit with its numerical error removed.
struct CorrectedDeclaredFit {
    JudgedFit fit;                // with an error, which is zero if none could be computed
    Refinement refinement;        // for the errors of all later fits
    double modulus_factor = 1.0;  // of the cells in all later runs
};

/// correct_discretisation() of the declared fit. Makes the finer mesh, and finds the effective modulus of the cells,
/// with which this fit and all later ones are run.
///
/// The parameters are not matched: the error of this fit serves all candidates, so its parameters must stay.
/// @param in  its refinement is not used
/// @return    empty if cancelled
std::optional<CorrectedDeclaredFit> correct_declared_fit(const CorrectionInput& in, JudgedFit fit, FitStore& store,
                                                         PhaseLog& log);

/// Numerical error of a fit, completed by that of the trials that were not used in the fit.
/// @param fit  with an error of its own (numerics)
NumericalError with_error_of_other_trials(const DiagnosisContext& context, const JudgedFit& fit, PhaseLog& log);

}  // namespace myo::diagnosis
