#pragma once

#include "fibre/signal.hpp"

namespace myo::ui::commands {

enum class SignalShape { constant, step, ramp, sine };

/// What a generated signal looks like. Values are target stretches a: 1 is passive.
struct SignalRecipe {
    SignalShape shape = SignalShape::ramp;
    double level = 0.8;         // reached, or the middle of a sine's other end: it swings between 1 and this
    double start_s = 0.0;       // passive before
    double rise_s = 0.5;        // of a ramp; a step takes a millisecond
    double frequency_Hz = 1.0;  // of a sine
    double end_s = 2.0;         // of a sine; passive after
};

/// A sine has 32 knots a period, so that it is within half a per cent of its swing.
fibre::Signal make_signal(const SignalRecipe& recipe);

// Edits of single knots; all keep times ascending.

/// @param time_s  kept between the neighbours, a tenth of a millisecond off
fibre::Signal with_knot_moved(fibre::Signal signal, std::size_t knot, double time_s, double value);
/// The new knot's number is that of the first knot after `time_s` before.
fibre::Signal with_knot_added(fibre::Signal signal, double time_s, double value);
/// The last one stays.
fibre::Signal with_knot_removed(fibre::Signal signal, std::size_t knot);

}  // namespace myo::ui::commands
