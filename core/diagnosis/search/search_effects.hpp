#pragma once

#include <functional>
#include <vector>

#include "diagnosis/screening/screen_effects.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {

/// Called with the fits so far, from the calling thread; may be null.
using SearchObserver = std::function<void(const RankedFits&)>;

/// Fits the best of the scored effects until one explains the residual: from their best probes, from other places and
/// axes, and from large probes. The best fits and their rivals are corrected by the numerical error of their own
/// motion.
/// @return  every scored effect, ranked; without sets. Incomplete if cancelled
RankedFits search_effects(const DiagnosisContext& context, const Screening& screening, FitStore& store, PhaseLog& log,
                          const SearchObserver& show = {});

}  // namespace myo::diagnosis
