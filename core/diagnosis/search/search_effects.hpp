#pragma once

#include <functional>
#include <vector>

#include "diagnosis/screening/screen_effects.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {

/// Called with the fits so far, from the calling thread; may be null.
using SearchObserver = std::function<void(const RankedFits&)>;

/// Input of a search for one effect. Refers to values that outlive it.
struct SingleSearchInput {
    const DiagnosisContext& context;
    const Screening& screening;
    const SearchObserver& show;
};

/// Fits the scored effects from their best probes, in the order of their predicted reductions, as long as one may still
/// become the best. Fits that nearly explain the residual are corrected by the numerical error of their own motion.
/// @param found  every scored effect, with the fits so far
/// @return       these, ranked. Incomplete if cancelled
RankedFits search_likely_effects(const SingleSearchInput& in, RankedFits found, FitStore& store, PhaseLog& log);

/// Continues the search until one effect explains the residual: from starts beyond the linear range, from other places
/// and axes, and from large probes. The best fits and their rivals are corrected by the numerical error of their own
/// motion.
/// @param likely  the fits of search_likely_effects()
/// @return        incomplete if cancelled
RankedFits search_all_effects(const SingleSearchInput& in, RankedFits likely, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
