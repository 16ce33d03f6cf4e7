#pragma once

#include "dynamics/single_stage.hpp"

namespace myo::dynamics {

/// The two-step backward differentiation formula for steps of unequal length: D1 = u + r (u - u0) with the mean slopes
/// u and u0 of this step and of the one before, r = h / (h + h0). Second order, L-stable.
///
/// With h0 = 0 and the derivative for u0, as at the start of a run, it is the trapezoidal rule: it starts itself at its
/// own order. At a jump the force, and with it u0 of the momenta, changes by the jump, as if the new loads had acted
/// before. Source: Hairer, Norsett & Wanner 1993, ch. III.5.
inline StepFormula bdf2_formula(double h, double step_before) {
    const double r = h / (h + step_before);
    return {.change_1_s = (1.0 + r) / h, .slope = r, .next_change_1_s = 1.0 / h};
}

}  // namespace myo::dynamics
