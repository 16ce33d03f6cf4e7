#pragma once

#include "fibre/signal.hpp"

namespace myo::effect {

/// A signal whose bends fall anywhere between the steps of a run, as one that gives the run the same impulses wherever
/// they fall.
///
/// An integrator takes a signal at its stages. Where the signal bends at the share θ of a step, the impulse of the
/// stages differs from its own by a function of θ times h² and the change of slope, zero where bends are ends of steps:
/// it does not fall by four with half the step, and it changes as the signal shifts. The result is the mean over a step
/// around each time less 0.082 times the second difference of these means: at every θ its impulse by TR-BDF2 is that of
/// a bend at a step's end, and lines stay as they are. Other schemes have an error that is of second order and the same
/// for all θ. Linear between times h/4 apart up to `end_s`.
///
/// A jump is a bend of no length and gets the same impulse: without it a run's derivative with respect to a delay would
/// be that of nothing until the jump passes a stage. Jumps so near to the start that their mean would reach before it
/// stay jumps, at which steps end.
fibre::Signal with_bends_between_steps(const fibre::Signal& signal, double h_s, double end_s);

}  // namespace myo::effect
