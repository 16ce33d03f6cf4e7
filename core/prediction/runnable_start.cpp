#include "prediction/runnable_start.hpp"

#include <algorithm>

#include "prediction/predict_trials.hpp"

namespace myo::prediction {
namespace {

struct RunnableStartPolicy {
    double growth = 1.25;  // of the modulus; the commands that a body bears grow with it
    int max_attempts = 6;  // up to 3.8 times the modulus: data sheets are not wrong by more
};
constexpr RunnableStartPolicy runnable_start_policy;

/// Raises the fitted moduli; returns whether one of them could be.
bool stiffen(const std::vector<ModelParameter>& parameters, ParameterValues& values) {
    bool raised = false;
    for (const ModelParameter& p : parameters) {
        if (p.kind != ModelParameter::Kind::youngs_modulus && p.kind != ModelParameter::Kind::part_modulus) continue;
        const double value = value_of(p, values);
        const double next = std::min(runnable_start_policy.growth * value, p.parameter.upper);
        raised = raised || next > value;
        set_value(p, next, values);
    }
    return raised;
}

}  // namespace

std::optional<ParameterValues> runnable_start(const setup::Setup& setup, const ParameterValues& values,
                                              const std::vector<ModelParameter>& parameters,
                                              const std::vector<std::size_t>& trials, const Progress& progress) {
    ParameterValues start = values;
    for (int attempt = 0; attempt < runnable_start_policy.max_attempts && stiffen(parameters, start); ++attempt) {
        if (progress.cancelled()) return {};
        if (all_ok(predict_trials_with(setup, start, trials, progress))) return start;
    }
    return {};
}

}  // namespace myo::prediction
