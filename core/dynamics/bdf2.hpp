#pragma once

#include "dynamics/single_stage.hpp"

namespace myo::dynamics {

/// Two-step backward differentiation formula (BDF2) for steps of unequal length.
///
/// D1 = u + r (u - u0) with the mean slopes u of this step and u0 of the step before it, r = h / (h + h0). Second
/// order, L-stable. With h0 = 0 and u0 = derivative, as at the start of a run, the formula is the trapezoidal rule:
/// BDF2 needs no separate starting scheme and keeps its order. At a jump the force is recomputed, and u0 of the momenta
/// changes by the same jump, as if the new loads had acted during the step before.
///
/// @param h            length of this step [s]
/// @param step_before  length h0 of the step before it [s]; 0 at the start of a run
/// Source: Hairer, Norsett & Wanner 1993, ch. III.5.
inline StepFormula bdf2_formula(double h, double step_before) {
    const double r = h / (h + step_before);
    return {.change_1_s = (1.0 + r) / h, .slope = r, .next_change_1_s = 1.0 / h};
}

}  // namespace myo::dynamics
