#pragma once

#include <optional>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/joint_fit.hpp"

namespace myo::diagnosis {

/// Values of a fit with its distorted parameters reset to the expected ones; empty if none is distorted. Without the
/// missing effect the fitted damping compensates for every loss and lag, and start shifts end at a bound; scores
/// computed there do not identify the effect.
std::optional<prediction::ParameterValues> debiased_start(const JointFit& fit,
                                                          const prediction::ParameterValues& expected,
                                                          const DeclaredFitPolicy& policy);

}  // namespace myo::diagnosis
