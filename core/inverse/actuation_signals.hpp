#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "fibre/signal.hpp"

namespace myo::inverse {

/// A fibre group has the activation a = 1 + factor (s - 1) of signal s: antagonists share one.
struct SignalShare {
    std::size_t signal = 0;
    double factor = 1.0;
};

/// A signal that is looked for.
struct SoughtSignal {
    std::string name;
    double lower = 0.0;
    double upper = 0.0;
    double before = 1.0;  // its value up to t = 0
};

/// What is looked for: values of the signals, signals x knots, the knots 1 / frequency apart.
struct SoughtSignals {
    std::vector<SoughtSignal> signals;
    std::vector<SignalShare> groups;  // per fibre group of the model
    double frequency_Hz = 20.0;
    double end_s = 1.0;  // knots reach at least so far
    bool hold = false;   // constant from knot to knot instead of linear
    /// Up to t = 0 the signals have been at `before` and the body rests there: the first change, too, is one. Linear
    /// signals then leave from there, and their first free knot is one period later.
    bool from_before = false;
    /// With from_before: what `before` is, is not known, and each signal's first value is it. Of linear signals that is
    /// the value at t = 0; a held signal has one value more, whose knot is a period before the start.
    bool seek_before = false;
};

/// Times of the free knots [s]. A negative one is that of the level before t = 0.
std::vector<double> knot_times(const SoughtSignals& sought);

/// All values at `before`, within bounds.
Eigen::MatrixXd unmoved_values(const SoughtSignals& sought);

/// The activations of the model's fibre groups. `values`: signals x knots.
std::vector<fibre::Signal> activations_of(const SoughtSignals& sought, const Eigen::MatrixXd& values);

/// The derivative with respect to the values from the one with respect to the knots of activations_of(), per group.
Eigen::MatrixXd value_gradient(const SoughtSignals& sought, const std::vector<std::vector<double>>& activation);

/// d rate / d value of the changes that mean_square_rate() counts [1/s]; of rows and of columns the signals run
/// fastest.
Eigen::MatrixXd rate_matrix(const SoughtSignals& sought, Eigen::Index knots);

/// Mean square rate of change from knot to knot [1/s2] and, added to `gradient` with this weight, its derivative.
double mean_square_rate(const SoughtSignals& sought, const Eigen::MatrixXd& values, double weight,
                        Eigen::MatrixXd& gradient);

}  // namespace myo::inverse
