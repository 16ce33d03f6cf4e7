#pragma once

#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// The moduli with which a setup's mesh and step, and finer ones, move most like the limit that a numerical error was
/// extrapolated to.
///
/// Coarse cells bend as if of another modulus, and long steps shift frequencies; both by the same share whatever the
/// motion, while a shift of positions belongs to one motion alone. All are found by least squares on the data's
/// samples; `error` keeps what they leave.
///
/// @param setup   with the modulus factor 1
/// @param values  with which the error was found
/// @param error   of all data.trials; gets .stiffening and less shift
/// @return whether there was enough to take off, and the trials could be run
bool match_modulus(const setup::Setup& setup, const prediction::ParameterValues& values, const FitData& data,
                   NumericalError& error, const Progress& progress);

}  // namespace myo::diagnosis
