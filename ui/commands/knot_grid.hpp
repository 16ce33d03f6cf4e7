#pragma once

namespace myo::ui::commands {

/// The multiple of a round step nearest to a value, with no more decimals than the step has.
///
/// @param step  1, 2 or 5 times a power of ten, as chart::round_step() gives it
double on_grid(double value, double step);

}  // namespace myo::ui::commands
