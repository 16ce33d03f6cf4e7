#pragma once

#include "dynamics/single_stage.hpp"

namespace myo::dynamics {

/// Trapezoidal rule, Newmark's method with beta = 1/4 and gamma = 1/2: (D0 + D1) / 2 = (y1 - y0) / h.
///
/// Second order. Conserves the energy of linear vibrations; frequencies that h does not resolve oscillate undamped.
/// Source: Newmark 1959; Hughes 1987, ch. 9.
inline StepFormula trapezoidal_formula(double h) {
    // The stored slope equals the derivative, so the scheme has no memory of its own.
    return {.change_1_s = 2.0 / h, .slope = 1.0, .next_change_1_s = 2.0 / h, .next_slope = 1.0};
}

}  // namespace myo::dynamics
