#pragma once

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {

/// Fits of single effects and of pairs.
struct PairSearch {
    RankedFits fits;
    PredictionShift shift;  // with which the pairs were fitted: that of the best single effect
};

/// Fits a second effect together with the best one if that leaves an excess, and then refits each of the two alone to
/// test whether the other is needed; its earlier fit may have ended in a local minimum.
/// @param singles  ranked fits of single effects, see search_effects()
/// @return         the given fits if no pair is worth fitting. Incomplete if cancelled
PairSearch search_pairs(const DiagnosisContext& context, RankedFits singles, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
