#include "effect/signal_response.hpp"

#include <algorithm>
#include <cmath>

#include "model/force_element.hpp"

namespace myo::effect {

bool moves(const fibre::Signal& signal, double) {
    return std::any_of(signal.values.begin(), signal.values.end(),
                       [&](double value) { return value != signal.values.front(); });
}

bool acts(const fibre::Signal& signal, double passive) {
    return std::any_of(signal.values.begin(), signal.values.end(), [&](double value) { return value != passive; });
}

namespace {

/// Samples of the signal at multiples of `spacing`, and on both sides of its jumps.
fibre::Signal sampled(const fibre::Signal& signal, double spacing, double end_s) {
    const auto count = static_cast<std::size_t>(std::ceil(end_s / spacing)) + 2;
    std::vector<double> jumps = signal.jumps();
    // Jumps before the run are in its start, those beyond the last sample never act.
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
        // A multiple at which the signal jumps is there already.
        if (t > samples.times_s.back()) add(t, signal.value(t));
    }
    return samples;
}

}  // namespace

EffectParameterEntry signal_parameter() {
    return {.name = "signal", .kind = EffectParameterKind::actuator, .optional = true};
}

void change_signals(const TrialContext& context, const EffectParameters& parameters, model::Model& model,
                    const std::function<void(fibre::Signal&, double passive)>& change) {
    const std::string only = has(parameters, "signal") ? text(parameters, "signal") : "";
    // Actuators are named in the order of their signals: muscles first, then force elements.
    std::size_t number = 0;
    const auto chosen = [&]() {
        const std::size_t i = number++;
        return only.empty() || (i < context.actuator_names.size() && context.actuator_names[i] == only);
    };
    for (fibre::Signal& signal : model.activation)
        if (chosen()) change(signal, 1.0);
    for (model::ForceElementPointer& element : model.force_elements) {
        if (element->command() == nullptr || !chosen()) continue;
        fibre::Signal command = *element->command();
        change(command, 0.0);
        element = element->with_command(command);
    }
}

void respond_to_signals(const TrialContext& context, const EffectParameters& parameters, SignalKind kind,
                        const Response& respond, Affected& affected) {
    change_signals(context, parameters, affected.model, [&](fibre::Signal& signal, double passive) {
        if (!kind(signal, passive)) return;
        fibre::Signal samples = sampled(signal, 0.25 * affected.options.h_s, affected.options.end_s);
        for (double& value : samples.values) value -= passive;
        signal.values = respond(samples.times_s, samples.values);
        for (double& value : signal.values) value += passive;
        // Response and samples have the same times.
        signal.times_s = std::move(samples.times_s);
    });
}

namespace {

/// Calls visit(signal, passive) for every signal of every model.
template <class Visit>
void for_each_signal(const EffectSearch& search, const Visit& visit) {
    for (const model::Model& model : search.models) {
        for (const fibre::Signal& signal : model.activation) visit(signal, 1.0);
        for (const model::ForceElementPointer& element : model.force_elements)
            if (element->command() != nullptr) visit(*element->command(), 0.0);
    }
}

}  // namespace

bool any_signal(SignalKind kind, const EffectSearch& search) {
    bool any = false;
    for_each_signal(search, [&](const fibre::Signal& signal, double passive) { any = any || kind(signal, passive); });
    return any;
}

double largest_input(const EffectSearch& search) {
    double largest = 0.0;
    for_each_signal(search, [&](const fibre::Signal& signal, double passive) {
        for (const double value : signal.values) largest = std::max(largest, std::abs(value - passive));
    });
    return largest;
}

}  // namespace myo::effect
