#pragma once

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/search/search_effects.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {

/// Fits of single effects and of sets of two and more.
struct SetSearch {
    RankedFits fits;
    PredictionShift shift;  // with which the last set was fitted
};

/// How far a set is searched: grown, with idle effects dropped; or exchanged, too, where growing no longer helps.
enum class SetSearchExtent { grown, exchanged };

/// Searches a set of effects that explains the residual where no single one does.
///
/// Starts from the best single effect, or from the best set that was found before. Forward: scores all other effects on
/// the residual of the set so far, with its effects and the declared parameters projected out, and fits the best of
/// them together with the set. Backward: refits the set without each of its effects, unless that is far off after a few
/// evaluations, and drops the one without which the evidence does not fall; the single fits are improved by that, too.
/// Where no further effect helps, exchanges each effect for another one. Every fit is kept. Source: the moves are those
/// of FAMoS, Gabel et al. 2019, PLoS Comput Biol 15, e1007230.
/// @param found  ranked fits so far
/// @return       the given fits if no set is worth fitting. Incomplete if cancelled
SetSearch search_sets(const DiagnosisContext& context, RankedFits found, FitStore& store, PhaseLog& log,
                      const SearchObserver& show = {}, SetSearchExtent extent = SetSearchExtent::exchanged);

}  // namespace myo::diagnosis
