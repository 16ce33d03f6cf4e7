#pragma once

namespace myo::dynamics {

/// Ending of the message of a run that failed within a step. Not used if the start equilibrium was not found, because a
/// smaller step does not help there.
inline constexpr const char* smaller_step_advice = "try a smaller step";

}  // namespace myo::dynamics
