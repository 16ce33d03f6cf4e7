#include "inverse/actuation_signals.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Whether the first knot has the fixed value `before`: for a held signal that before t = 0, for a linear one that
/// starts there, the knot at t = 0.
bool has_fixed_knot(const SoughtSignals& sought) {
    if (sought.constant) return false;
    return sought.hold ? !sought.seek_before : sought.from_before && !sought.seek_before;
}

/// Whether the signals jump at their knots.
bool is_held(const SoughtSignals& sought) { return sought.hold && !sought.constant; }

/// Index of the first value that ends a rate.
Index first_rate(const SoughtSignals& sought) {
    return sought.from_before && !sought.seek_before && !sought.constant ? 0 : 1;
}

/// Index of the first knot, free or not [periods].
int first_knot(const SoughtSignals& sought) { return sought.hold ? -1 : 0; }

}  // namespace

std::vector<double> knot_times(const SoughtSignals& sought) {
    if (sought.constant) return {0.0};
    // A held signal needs no knot at or beyond the end; a linear one ends at the first knot there.
    const double spans = std::max(1.0, std::ceil(sought.end_s * sought.frequency_Hz - 1e-9));
    const int count = static_cast<int>(spans) + (sought.hold ? 0 : 1);
    std::vector<double> times;
    for (int k = first_knot(sought) + (has_fixed_knot(sought) ? 1 : 0); k < count; ++k)
        times.push_back(k / sought.frequency_Hz);
    return times;
}

MatrixXd unmoved_values(const SoughtSignals& sought) {
    MatrixXd values(static_cast<Index>(sought.signals.size()), static_cast<Index>(knot_times(sought).size()));
    for (Index s = 0; s < values.rows(); ++s) {
        const SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
        values.row(s).setConstant(std::clamp(signal.before, signal.lower, signal.upper));
    }
    return values;
}

std::vector<fibre::Signal> commands_of(const SoughtSignals& sought, const MatrixXd& values) {
    std::vector<double> times = knot_times(sought);
    assert(values.rows() == static_cast<Index>(sought.signals.size()) &&
           values.cols() == static_cast<Index>(times.size()));
    const bool fixed = has_fixed_knot(sought);
    if (fixed) times.insert(times.begin(), first_knot(sought) / sought.frequency_Hz);
    std::vector<fibre::Signal> commands;
    for (const SignalShare& group : sought.groups) {
        if (group.own) {
            commands.push_back(*group.own);
            continue;
        }
        const SoughtSignal& signal = sought.signals[group.signal];
        const auto of_group = [&](double s) { return signal.passive + group.factor * (s - signal.passive); };
        std::vector<double> knots;
        if (fixed) knots.push_back(of_group(signal.before));
        for (const double value : values.row(static_cast<Index>(group.signal))) knots.push_back(of_group(value));
        commands.push_back(is_held(sought) ? fibre::Signal::held(times, knots) : fibre::Signal{times, knots});
    }
    return commands;
}

MatrixXd value_gradient(const SoughtSignals& sought, const std::vector<std::vector<double>>& command) {
    assert(command.size() == sought.groups.size());
    MatrixXd gradient = MatrixXd::Zero(static_cast<Index>(sought.signals.size()),
                                       static_cast<Index>(knot_times(sought).size()));
    for (std::size_t g = 0; g < command.size(); ++g) {
        if (sought.groups[g].own) continue;
        const std::vector<double> knots = is_held(sought) ? fibre::held_sample_gradient(command[g]) : command[g];
        const Index first = static_cast<Index>(knots.size()) - gradient.cols();  // earlier knots are not free
        for (Index k = 0; k < gradient.cols(); ++k)
            gradient(static_cast<Index>(sought.groups[g].signal), k) += sought.groups[g].factor *
                                                                        knots[static_cast<std::size_t>(first + k)];
    }
    return gradient;
}

Eigen::VectorXd signal_scales(const SoughtSignals& sought) {
    Eigen::VectorXd scales(static_cast<Index>(sought.signals.size()));
    for (Index s = 0; s < scales.size(); ++s) scales(s) = sought.signals[static_cast<std::size_t>(s)].scale;
    return scales;
}

MatrixXd rate_matrix(const SoughtSignals& sought, Index knots) {
    const auto signals = static_cast<Index>(sought.signals.size());
    const Index first = first_rate(sought), rates = std::max<Index>(0, knots - first);
    MatrixXd D = MatrixXd::Zero(rates * signals, knots * signals);
    for (Index r = 0; r < rates; ++r)
        for (Index s = 0; s < signals; ++s) {
            const Index k = first + r;
            D(r * signals + s, k * signals + s) = sought.frequency_Hz;
            if (k > 0) D(r * signals + s, (k - 1) * signals + s) = -sought.frequency_Hz;
        }
    return D;
}

double mean_square_rate(const SoughtSignals& sought, const MatrixXd& values, double weight, MatrixXd& gradient) {
    const Index first = first_rate(sought), rates = values.cols() - first;
    if (rates < 1 || values.rows() == 0) return 0.0;
    const double count = static_cast<double>(rates * values.rows());
    double sum = 0.0;
    for (Index s = 0; s < values.rows(); ++s)
        for (Index k = first; k < values.cols(); ++k) {
            const SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
            // The first rate is measured from `before`, which is constant.
            const double left = k > 0 ? values(s, k - 1) : signal.before;
            const double rate = (values(s, k) - left) / signal.scale * sought.frequency_Hz;
            const double slope = weight * 2.0 * rate * sought.frequency_Hz / count / signal.scale;
            sum += rate * rate;
            gradient(s, k) += slope;
            if (k > 0) gradient(s, k - 1) -= slope;
        }
    return sum / count;
}

}  // namespace myo::inverse
