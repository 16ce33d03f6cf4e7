#pragma once

#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// Values with which half the step and finer cells move most like the setup does with a fit's, to first order.
///
/// A finer mesh with the same values may swing faster or slower, and ever more out of step: that is no shift of
/// positions which one could extrapolate. What it changes beyond what the fit's numbers make up for is, and so are the
/// numbers themselves: see extrapolated_values().
///
/// One step of Gauss and Newton with the fit's derivatives. @param error  found with the fit's own values, or with
/// error.alike of the step before
MatchedValues match_discretisation(const FitData& data, const JointFit& fit, const NumericalError& error);

/// A match moved to the values of another fit: the values of the refined runs keep their distance to the coarse run's.
MatchedValues moved_match(const JointFit& fit, const MatchedValues& matched);

/// Richardson's extrapolation of the numbers of a fit: the values of a body without cells, run without steps, that
/// moves like the setup with alike.setup.
prediction::ParameterValues extrapolated_values(const JointFit& fit, const MatchedValues& matched, double mesh_factor);

}  // namespace myo::diagnosis
