#include "effect/signal_response.hpp"

#include <algorithm>
#include <cmath>

namespace myo {

bool moves(const Signal& signal) {
    return std::any_of(signal.values.begin(), signal.values.end(), [&](double value) { return value != signal.values.front(); });
}

bool acts(const Signal& signal) {
    return std::any_of(signal.values.begin(), signal.values.end(), [](double value) { return value != 1.0; });
}

void respond_to_signals(SignalKind kind, const Response& respond, Affected& affected) {
    const double h = 0.25 * affected.options.h_s;
    const auto count = static_cast<std::size_t>(std::ceil(affected.options.end_s / h)) + 2;
    for (Signal& signal : affected.model.activation) {
        if (!kind(signal)) continue;
        std::vector<double> times, u;
        for (std::size_t k = 0; k < count; ++k) {
            times.push_back(static_cast<double>(k) * h);
            u.push_back(signal.value(times.back()) - 1.0);
        }
        // What stood before the start has been so for ever; a jump at t = 0 is the start's.
        u.front() = signal.value_before(0.0) - 1.0;
        std::vector<double> values = respond(u, h);
        for (double& value : values) value += 1.0;
        signal = {std::move(times), std::move(values)};
    }
}

bool any_signal(SignalKind kind, const EffectSearch& search) {
    for (const Model& model : search.models)
        for (const Signal& signal : model.activation)
            if (kind(signal)) return true;
    return false;
}

}  // namespace myo
