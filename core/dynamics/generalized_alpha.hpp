#pragma once

#include <cassert>

#include "dynamics/single_stage.hpp"

namespace myo::dynamics {

/// Generalised-alpha with the spectral radius rho_inf at infinite frequency, 0 ... 1: second order; 0 is BDF2, 1 the
/// trapezoidal rule.
///   am y'1 + (1 - am) y'0 = af D1 + (1 - af) D0,   y1 = y0 + h ((1 - g) y'0 + g y'1)
/// for positions and momenta alike: the form for first-order systems. Chung & Hulbert's form of 1993 carries the
/// acceleration, which at the start and at every jump asks for a solve with the mass; this one does not, and at the
/// same rho_inf it damps the low modes half as much. Source: Jansen, Whiting & Hulbert 2000; Kadapa, Dettmer & Peric
/// 2017.
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
