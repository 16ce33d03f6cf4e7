#include "check/recorded_swing.hpp"

#include <algorithm>
#include <cmath>

#include "model/force_element.hpp"

namespace myo::check {
namespace {

using Eigen::Index;

/// When a recorded motion counts as free oscillation.
struct SwingPolicy {
    int min_turns = 3;                // 1.5 periods: an overshooting step response has one reversal, drift has none
    double noise_levels = 10.0;       // least amplitude of a reversal over the noise: beyond white noise ...
    double travel_share = 0.05;       // ... and over the range of motion: beyond a bumped tripod
    double min_signal_change = 0.05;  // of a signal's range that still counts as a change
};
constexpr SwingPolicy swing_policy;

/// Time of the last knot at which a signal still differs from its final value.
double last_change_s(const fibre::Signal& signal) {
    const auto [least, most] = std::minmax_element(signal.values.begin(), signal.values.end());
    const double off = swing_policy.min_signal_change * (*most - *least);
    // Backwards from the end: the value before knot k differs from the last one, so the signal changes until that knot.
    for (std::size_t k = signal.values.size(); k-- > 1;)
        if (std::abs(signal.values[k - 1] - signal.values.back()) > off) return signal.times_s[k];
    return 0.0;
}

}  // namespace

// Jumps of loads and changes of signals; between them the body moves freely.
double last_change_s(const model::Model& model) {
    double last = 0.0;
    for (const double jump : model::jump_times(model)) last = std::max(last, jump);
    for (const fibre::Signal& signal : model.activation) last = std::max(last, last_change_s(signal));
    for (const model::DeadForce& force : model.forces) last = std::max(last, last_change_s(force.course));
    for (const model::ForceElementPointer& element : model.force_elements)
        if (element->command() != nullptr) last = std::max(last, last_change_s(*element->command()));
    return last;
}

std::vector<double> turning_times(const Eigen::VectorXd& time_s, const Eigen::VectorXd& x_m, double min_m) {
    std::vector<double> turns;
    Index low = -1, high = -1;  // extremes since the last reversal
    int direction = 0;
    for (Index k = 0; k < x_m.size(); ++k) {
        if (!std::isfinite(x_m(k))) continue;
        if (low < 0 || x_m(k) < x_m(low)) low = k;
        if (high < 0 || x_m(k) > x_m(high)) high = k;
        // Hysteresis: a reversal counts only after a return by `min_m`, so noise does not produce reversals.
        if (direction >= 0 && x_m(high) - x_m(k) > min_m) {
            if (direction > 0) turns.push_back(time_s(high));
            direction = -1;
            low = k;
        } else if (direction <= 0 && x_m(k) - x_m(low) > min_m) {
            if (direction < 0) turns.push_back(time_s(low));
            direction = 1;
            high = k;
        }
    }
    return turns;
}

RecordedSwing recorded_swing(const setup::PreparedTrial& trial, double from_s, double noise_m) {
    // A body that its mount shakes does not swing freely.
    if (trial.mount) return {};
    const Eigen::VectorXd& time = trial.measured.time_s;
    // Samples while the body is still driven show the drive, not the body.
    const auto after = std::lower_bound(time.begin(), time.end(), from_s) - time.begin();
    const Index first = std::max(trial.first_sample, static_cast<Index>(after));
    const Index count = time.size() - first;
    // Every reversal takes at least one sample.
    if (count <= swing_policy.min_turns) return {};
    // The coordinate with the largest range has the best ratio of signal to noise.
    Eigen::VectorXd widest;
    double travel = 0.0;
    for (const Eigen::Matrix3Xd& track : trial.measured.tracks)
        for (Index axis = 0; axis < 3; ++axis) {
            const Eigen::VectorXd x = track.row(axis).tail(count);
            double low = INFINITY, high = -INFINITY;
            for (const double value : x)
                if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
            if (high - low > travel) travel = high - low, widest = x;
        }
    if (!(travel > 0.0)) return {};
    // A reversal must exceed noise, and shaking of the camera in a large motion.
    const double least = std::max(swing_policy.noise_levels * noise_m, swing_policy.travel_share * travel);
    const std::vector<double> turns = turning_times(time.tail(count), widest, least);
    RecordedSwing swing;
    if (turns.size() < static_cast<std::size_t>(swing_policy.min_turns)) return swing;
    std::vector<double> halves;
    for (std::size_t i = 1; i < turns.size(); ++i) halves.push_back(turns[i] - turns[i - 1]);
    // Median of the half periods: robust against a missed reversal.
    const auto middle = halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2);
    std::nth_element(halves.begin(), middle, halves.end());
    swing.turns = static_cast<int>(turns.size());
    swing.frequency_Hz = 0.5 / *middle;
    return swing;
}

}  // namespace myo::check
