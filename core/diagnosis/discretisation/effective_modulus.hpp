#pragma once

#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// Effective moduli with which mesh and step of the setup, and the refined ones, best reproduce the extrapolated limit.
///
/// Coarse cells deform as if of another modulus, and long steps shift frequencies; both by the same factor for every
/// motion, whereas a shift of positions holds for one motion only. Found by least squares over the samples of the data;
/// the error keeps the remainder.
///
/// @param setup   with modulus factor 1
/// @param values  with which the error was found
/// @param error   of all data.trials
/// @return        the error with effective_modulus and by_modulus, its shift reduced; empty if the error is too small,
///                or if the trials could not be run
std::optional<NumericalError> match_modulus(const setup::Setup& setup, const prediction::ParameterValues& values,
                                            const FitData& data, NumericalError error, const NumericsPolicy& policy,
                                            const Progress& progress);

}  // namespace myo::diagnosis
