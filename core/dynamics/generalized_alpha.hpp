#pragma once

#include <cassert>

#include "dynamics/single_stage.hpp"

namespace myo::dynamics {

/// Generalised-alpha scheme for first-order systems, second order.
///
///   am y'1 + (1 - am) y'0 = af D1 + (1 - af) D0,   y1 = y0 + h ((1 - g) y'0 + g y'1)
/// for positions and momenta. The form of Chung & Hulbert 1993 stores the acceleration, which requires a solve with the
/// mass matrix at the start and at every jump; this form does not, and at equal rho_inf it has half the numerical
/// damping of the low modes.
///
/// @param h        length of the step [s]
/// @param rho_inf  spectral radius at infinite frequency, 0 ... 1: 0 gives BDF2, 1 the trapezoidal rule
/// Errors: asserts the range of rho_inf.
/// Source: Jansen, Whiting & Hulbert 2000; Kadapa, Dettmer & Peric 2017.
inline StepFormula generalized_alpha_formula(double h, double rho_inf) {
    assert(rho_inf >= 0.0 && rho_inf <= 1.0);
    const double am = 0.5 * (3.0 - rho_inf) / (1.0 + rho_inf), af = 1.0 / (1.0 + rho_inf), g = 0.5 + am - af;
    return {.change_1_s = am / (af * g * h),
            .slope = (am * (1.0 - g) / g - (1.0 - am)) / af,
            .derivative = (1.0 - af) / af,
            .next_change_1_s = 1.0 / (g * h),
            .next_slope = (1.0 - g) / g};
}

}  // namespace myo::dynamics
