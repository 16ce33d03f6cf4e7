#pragma once

#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// Parameters for which the run with half the step and the run on finer cells best match the run of the setup with the
/// values of a fit, to first order.
///
/// With equal parameters a finer mesh may oscillate faster or slower, with a growing phase difference. That is not a
/// shift of positions and cannot be extrapolated. The part of the difference that the fit's parameters do not
/// compensate is extrapolated as a shift; the parameters are extrapolated themselves, see extrapolated_values().
///
/// One Gauss-Newton step with the derivatives of the fit.
/// @param error  found with the values of the fit in all runs, or with error.matched of the previous iteration
MatchedValues match_discretisation(const FitData& data, const JointFit& fit, const NumericalError& error,
                                   const NumericsPolicy& policy);

/// Match moved to the values of another fit; refined and coarse values keep their differences.
MatchedValues moved_match(const JointFit& fit, const MatchedValues& matched);

/// Richardson extrapolation of the parameters of a fit: values with which the limit of zero edge length and step moves
/// like the setup with the fitted values.
/// @param mesh_factor  see NumericalError
prediction::ParameterValues extrapolated_values(const JointFit& fit, const MatchedValues& matched, double mesh_factor,
                                                const NumericsPolicy& policy);

}  // namespace myo::diagnosis
