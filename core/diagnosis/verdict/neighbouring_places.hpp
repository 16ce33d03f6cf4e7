#pragma once

#include <vector>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/phase_log.hpp"

namespace myo::diagnosis {

/// Values of a fit in which a fitted place of an effect (position_m) lies one cell further, for each direction and
/// sense that the data determine to within a few cells; the other parameters follow such that predictions change least,
/// to first order. Empty without such a place.
/// @param cell_m  edge length of the cells [m]
std::vector<prediction::ParameterValues> neighbouring_places(const JointFit& fit, double cell_m,
                                                             const PlacePolicy& policy);

/// The fit, or one that leaves less from a place some cells further: a force that acts on the nodes of one cell depends
/// on where in the cell it acts, so that the squares have a minimum in each of several cells.
/// @param data  with the shift of the fit
/// @return      not corrected for its own numerical error if it is another fit; with the criterion and weight of `fit`
JudgedFit with_best_place(const DiagnosisContext& context, const FitData& data, JudgedFit fit, FitStore& store,
                          PhaseLog& log);

}  // namespace myo::diagnosis
