#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "fibre/signal.hpp"

namespace myo::inverse {

/// Command of an actuator: passive + factor (s - passive) of signal s. Antagonists share a signal.
struct SignalShare {
    std::size_t signal = 0;  // index of the signal
    double factor = 1.0;
    std::optional<fibre::Signal> own{};  // a command that is not sought; the members above are then without meaning
};

/// A signal to be determined, with its bounds: activation of muscles [-], pressure [Pa], tension [N] or shortening [m].
struct SoughtSignal {
    std::string name;
    double lower = 0.0;
    double upper = 0.0;
    double before = 1.0;   // value up to t = 0
    double passive = 1.0;  // value at which the actuator does nothing: 1 of a muscle, else 0
    double scale = 1.0;    // typical magnitude of a change, > 0: unit in which signals are comparable
};

/// The unknowns: values of the signals, signals x knots, with knots 1 / frequency apart.
struct SoughtSignals {
    std::vector<SoughtSignal> signals;
    std::vector<SignalShare> groups;  // per fibre group of the model, then per driven force element, see command.hpp
    double frequency_Hz = 20.0;
    double end_s = 1.0;     // the knots extend at least to this time
    bool hold = false;      // piecewise constant instead of piecewise linear
    bool constant = false;  // one value of each signal, for a body at rest; the flags below and `hold` have no effect
    /// Up to t = 0 the signals are at `before` and the body rests there, so that the first change counts as a rate.
    /// Linear signals then start at `before`, and their first free knot is one period later.
    bool from_before = false;
    /// With from_before: `before` is unknown and is the first value of each signal. For linear signals this is the
    /// value at t = 0; a held signal has an additional value, whose knot lies one period before the start.
    bool seek_before = false;
};

/// Times of the free knots [s]. A negative time belongs to the level before t = 0.
std::vector<double> knot_times(const SoughtSignals& sought);

/// Initial values: `before` in all knots, clipped to the bounds.
Eigen::MatrixXd unmoved_values(const SoughtSignals& sought);

/// Signals of the actuators in the order of SoughtSignals::groups. `values`: signals x knots.
std::vector<fibre::Signal> commands_of(const SoughtSignals& sought, const Eigen::MatrixXd& values);

/// Chain rule: derivative with respect to the values from that with respect to the knots of commands_of().
///
/// @param command  per actuator and knot
/// @return         signals x knots
Eigen::MatrixXd value_gradient(const SoughtSignals& sought, const std::vector<std::vector<double>>& command);

/// Scale of each signal.
Eigen::VectorXd signal_scales(const SoughtSignals& sought);

/// Derivative of the rates counted by mean_square_rate() with respect to the values over their scales [1/s]. In rows
/// and columns the signal index varies fastest.
Eigen::MatrixXd rate_matrix(const SoughtSignals& sought, Eigen::Index knots);

/// Mean square rate of change between knots, of values over their scales [1/s2]. Adds `weight` times its derivative to
/// `gradient`.
double mean_square_rate(const SoughtSignals& sought, const Eigen::MatrixXd& values, double weight,
                        Eigen::MatrixXd& gradient);

}  // namespace myo::inverse
