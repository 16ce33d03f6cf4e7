#pragma once

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {

/// Fits of the whole recordings that a search on their beginnings led to.
struct BeginningSearch {
    RankedFits fits;     // candidates with their scores on the first beginning; empty: no search
    double share = 0.0;  // of the recordings, on which the effects were scored
    bool cut = false;    // its share of the time was over before the longest beginning
};

/// Searches effects and sets on beginnings of the recordings, of growing length, and fits the best of them to the
/// whole.
///
/// Over a short time a large residual still follows the derivatives by which effects are chosen, and a run costs less.
/// The fits of one beginning are the starts of those of the next; a search goes on from the best of them.
/// Source: progressive horizons, as for the fit of vibrations (calibration::start_from_windows).
/// @return  empty if the residual is small (BeginningPolicy); incomplete if cancelled
BeginningSearch search_beginnings(const DiagnosisContext& context, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
