#pragma once

#include <optional>

#include "diagnosis/fit/joint_fit.hpp"

namespace myo::diagnosis {

/// The values of a fit with what it has bent put back to what was expected; none where nothing was. Without the missing
/// effect damping stands in for every loss and lag, and from far up there no effect looks like itself; a shift of the
/// start ends at its bound.
std::optional<prediction::ParameterValues> debiased_start(const JointFit& fit,
                                                          const prediction::ParameterValues& expected);

}  // namespace myo::diagnosis
