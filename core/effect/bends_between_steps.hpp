#pragma once

#include "fibre/signal.hpp"

namespace myo::effect {

/// Replaces a signal by one whose impulse in a run does not depend on where its kinks fall between the steps.
///
/// An integrator samples a signal at its stages. If the slope changes at the fraction θ of a step, the impulse of the
/// stages has an error of h² times the change of slope times a function of θ that vanishes at the ends of steps. This
/// error does not decrease by four with half the step, and it changes as the signal shifts. The result is the mean over
/// one step around each time, minus 0.082 times the second difference of these means: under TR-BDF2 its impulse equals,
/// for every θ, that of a kink at the end of a step; linear signals are unchanged. Under other schemes the error is of
/// second order and the same for all θ. The result is linear between times h/4 apart up to `end_s`.
///
/// A jump is treated as a kink of zero length. Otherwise the derivative of a run with respect to a delay would vanish
/// until the jump passes a stage. Jumps so close to the start that the mean would reach before it stay jumps; steps end
/// there.
///
/// @param h_s    step of the run [s]
/// @param end_s  end of the run [s]
fibre::Signal with_bends_between_steps(const fibre::Signal& signal, double h_s, double end_s);

}  // namespace myo::effect
