#pragma once

#include <optional>
#include <string>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"

namespace myo::diagnosis {

/// Rms of the residual over the beginnings of the fit trials [noise levels]: the given share of the samples of each
/// that moves, and of the poses (hold = true) the share with the smallest motion, at least BeginningPolicy::min_poses.
double residual_in_beginnings(const DiagnosisContext& context, double share);

/// What the beginnings are: "the first 25 % of every recording", "the 2 poses with the smallest motion", or both.
std::string beginning_words(const DiagnosisContext& context, double share);

/// The context on the beginnings of the fit trials, with a declared fit of its own and the numerical error of the whole
/// one.
///
/// @param share  of the samples and poses, > 0, as in residual_in_beginnings()
/// @return       empty if the fit is not usable, or cancelled
std::optional<DiagnosisContext> beginning_context(const DiagnosisContext& context, double share, FitStore& store,
                                                  PhaseLog& log);

}  // namespace myo::diagnosis
