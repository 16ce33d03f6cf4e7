#pragma once

#include <string>
#include <vector>

#include "calibration/optimize.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::calibration {

/// Actuators of a setup with a single trial whose signals are sought and whose level before t = 0 is not given.
std::vector<std::string> unrecorded_levels(const setup::Setup& setup, const OptimizeSettings& settings);

/// Lowest activation of any muscle: of the settings, of [limits], or 0.5.
double lowest_activation(const experiment::Experiment& experiment, const OptimizeSettings& settings);

/// One signal per muscle that follows none, per chamber and per tendon, as far as they are sought. The bounds of
/// muscles keep their followers within the limits as well; those of chambers and tendons are declared in [limits]
/// or 1.5 times the largest of the experiment's commands, see command_bounds(). A hold has one value of each signal.
/// Actuators whose signals are not sought, and their followers, keep those of the trial.
///
/// @param end_s  last time that the signals reach
/// Errors: none; a signal without a value between its bounds has lower >= upper.
inverse::SoughtSignals sought_signals(const setup::Setup& setup, const OptimizeSettings& settings, double end_s);

/// Values from which a search starts: those before t = 0, within the bounds. Shortenings start a tenth of their limit
/// further in: a slack thread has no derivative by its shortening, and a search would end where it starts.
Eigen::MatrixXd first_values(const setup::Setup& setup, const inverse::SoughtSignals& sought);

/// Signals of the actuators for these values, as results: after the last sample of the target they hold the value that
/// they have there. The last knot of a linear signal may lie beyond it, where nothing determines the slope.
///
/// @param values  signals x knots
std::vector<fibre::Signal> found_commands(const inverse::SoughtSignals& sought, const Eigen::MatrixXd& values);

/// Range and scale of the signal of a chamber or tendon.
///
/// A command of one sign in all trials keeps this sign, as the device may not be able to do otherwise; a tension is
/// never negative, a pressure at least minus one atmosphere. Without a limit and without commands: what
/// setup::level_bounds() allows.
///
/// @param actuator  number of a chamber or tendon, see actuator_signals.hpp
setup::LevelBounds command_bounds(const setup::Setup& setup, std::size_t actuator);

}  // namespace myo::calibration
