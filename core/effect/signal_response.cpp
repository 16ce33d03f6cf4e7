#include "effect/signal_response.hpp"

#include <algorithm>
#include <cmath>

namespace myo::effect {

bool moves(const fibre::Signal& signal) {
    return std::any_of(signal.values.begin(), signal.values.end(),
                       [&](double value) { return value != signal.values.front(); });
}

bool acts(const fibre::Signal& signal) {
    return std::any_of(signal.values.begin(), signal.values.end(), [](double value) { return value != 1.0; });
}

namespace {

/// Samples of the signal at multiples of `spacing`, and on both sides of its jumps.
fibre::Signal sampled(const fibre::Signal& signal, double spacing, double end_s) {
    const auto count = static_cast<std::size_t>(std::ceil(end_s / spacing)) + 2;
    std::vector<double> jumps = signal.jumps();
    std::erase_if(jumps, [&](double t) { return t < 0.0 || t >= static_cast<double>(count - 1) * spacing; });
    jumps.erase(std::unique(jumps.begin(), jumps.end()), jumps.end());
    // The value before the start extends to all earlier times.
    fibre::Signal samples{{0.0}, {signal.value_before(0.0)}};
    const auto add = [&](double t, double value) {
        samples.times_s.push_back(t);
        samples.values.push_back(value);
    };
    auto jump = jumps.begin();
    for (std::size_t k = 0; k < count; ++k) {
        const double t = static_cast<double>(k) * spacing;
        // A jump becomes two samples of equal time; one at t = 0 only needs its right value.
        for (; jump != jumps.end() && *jump <= t; ++jump) {
            if (*jump > 0.0) add(*jump, signal.value_before(*jump));
            add(*jump, signal.value(*jump));
        }
        if (t > samples.times_s.back()) add(t, signal.value(t));
    }
    return samples;
}

}  // namespace

void respond_to_signals(SignalKind kind, const Response& respond, Affected& affected) {
    for (fibre::Signal& signal : affected.model.activation) {
        if (!kind(signal)) continue;
        fibre::Signal samples = sampled(signal, 0.25 * affected.options.h_s, affected.options.end_s);
        for (double& value : samples.values) value -= 1.0;
        signal.values = respond(samples.times_s, samples.values);
        for (double& value : signal.values) value += 1.0;
        signal.times_s = std::move(samples.times_s);
    }
}

bool any_signal(SignalKind kind, const EffectSearch& search) {
    for (const model::Model& model : search.models)
        for (const fibre::Signal& signal : model.activation)
            if (kind(signal)) return true;
    return false;
}

}  // namespace myo::effect
