#pragma once

#include <optional>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"

namespace myo::diagnosis {

/// Rms of the residual over the beginnings of all trials, the given share of the samples of each [noise levels].
double residual_in_beginnings(const DiagnosisContext& context, double share);

/// The context on the beginnings of the fit trials, with a declared fit of its own and the numerical error of the whole
/// one.
///
/// @param share  of the samples of each fit trial that moves, > 0
/// @return       empty if the fit is not usable, or cancelled
std::optional<DiagnosisContext> beginning_context(const DiagnosisContext& context, double share, FitStore& store,
                                                  PhaseLog& log);

}  // namespace myo::diagnosis
