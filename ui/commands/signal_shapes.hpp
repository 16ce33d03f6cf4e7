#pragma once

#include "fibre/signal.hpp"

namespace myo::ui::commands {

/// Shapes of generated signals.
enum class SignalShape { constant, step, ramp, sine };

/// Parameters of a generated signal. Values are target stretches a; a = 1 is passive.
struct SignalRecipe {
    SignalShape shape = SignalShape::ramp;
    double level = 0.8;         // value reached; a sine oscillates between 1 and this value
    double start_s = 0.0;       // passive before
    double rise_s = 0.5;        // ramps only; a step takes a millisecond
    double frequency_Hz = 1.0;  // sines only
    double end_s = 2.0;         // sines only; the value reached is held afterwards
};

/// Generates the signal. A sine has 32 knots per period, which keeps linear interpolation within half a per cent of its
/// swing.
fibre::Signal make_signal(const SignalRecipe& recipe);

// Edits of single knots. All of them keep the times ascending. `knot` must be a valid index.

/// Moves a knot; a jump moves as a whole in time.
///
/// @param time_s  limited to stay a tenth of a millisecond away from both neighbours
fibre::Signal with_knot_moved(fibre::Signal signal, std::size_t knot, double time_s, double value);
/// Adds a knot. Its index is that of the first knot after `time_s`. Does nothing if another knot is too close.
fibre::Signal with_knot_added(fibre::Signal signal, double time_s, double value);
/// Removes a knot. The last remaining knot is kept.
fibre::Signal with_knot_removed(fibre::Signal signal, std::size_t knot);

}  // namespace myo::ui::commands
