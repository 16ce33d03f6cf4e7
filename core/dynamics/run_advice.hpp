#pragma once

namespace myo::dynamics {

/// How the message of a run that failed in a step ends: what helps there. Of one that found no equilibrium to start
/// from it is no help.
inline constexpr const char* smaller_step_advice = "try a smaller step";

}  // namespace myo::dynamics
