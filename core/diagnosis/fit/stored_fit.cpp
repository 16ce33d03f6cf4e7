#include "diagnosis/fit/stored_fit.hpp"

#include <limits>

#include "base/text.hpp"
#include "diagnosis/report/effect_words.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Text from which a double is restored exactly.
std::string exact(double number) { return format_number(number, std::numeric_limits<double>::max_digits10); }

/// Number that distinguishes shifts in the key of a fit.
/// The sum of squares: two shifts that differ but have the same sum are not expected.
double fingerprint(const PredictionShift& shift) {
    double sum = 0.0;
    for (const auto& trial : shift)
        for (const auto& marker : trial) sum += marker.squaredNorm();
    return sum;
}

/// See fit_key(). `parameters` with their start values, as joint_parameters() returns them.
std::string key_of(const FitTask& task, const std::vector<prediction::ModelParameter>& parameters) {
    std::string key = std::to_string(task.effort.evaluations) + " " + exact(task.effort.relative_decrease) + " " +
                      std::to_string(task.effort.max_jacobians) + " samples " +
                      std::to_string(task.data.layout.size()) + " shift " + exact(fingerprint(task.data.shift)) +
                      " unknowns " + std::to_string(task.setup.body->dofs()) + " modulus factor " +
                      exact(task.setup.modulus_factor) + " steps";
    for (const std::size_t t : task.data.trials)
        key += " " + std::to_string(t) + ": " + exact(task.setup.trials[t].options.h_s);
    for (const effect::EffectDeclaration& effect : task.start.effects) key += " " + effect_words(effect);
    for (const prediction::ModelParameter& p : parameters)
        key += " " + p.parameter.name + " " + exact(p.parameter.value);
    return key;
}

/// Fitted parameters of a task with their start values.
std::vector<prediction::ModelParameter> parameters_of(const FitTask& task) {
    return joint_parameters(task.setup, task.start, task.policy.declared, task.freedom);
}

}  // namespace

std::string fit_key(const FitTask& task) { return key_of(task, parameters_of(task)); }

JointFit stored_fit(const FitTask& task, FitStore& store, const Progress& progress) {
    const std::vector<prediction::ModelParameter> parameters = parameters_of(task);
    const std::string key = key_of(task, parameters);
    Effort effort = task.effort;
    prediction::ParameterValues from = task.start;
    if (const std::optional<VectorXd> done = store.find(key);
        done && done->size() == static_cast<Index>(parameters.size())) {
        for (std::size_t i = 0; i < parameters.size(); ++i)
            prediction::set_value(parameters[i], (*done)(static_cast<Index>(i)), from);
        // The evaluation that is left recomputes residual and Jacobian at the stored values; the file has only these.
        effort.evaluations = 0;
    }
    JointFit fit = joint_fit({task.setup, task.data, from, task.policy, task.freedom, effort, task.warm}, progress);
    if (!fit.usable() || progress.cancelled()) return fit;
    VectorXd found(static_cast<Index>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        found(static_cast<Index>(i)) = prediction::value_of(parameters[i], fit.values);
    // A file that cannot be written costs time at the next start, not the result.
    static_cast<void>(store.keep(key, found));
    return fit;
}

JointFit logged_fit(const std::string& phase, const FitTask& task, FitStore& store, PhaseLog& log) {
    JointFit fit = log.timed(phase, 0, [&] { return stored_fit(task, store, log.progress()); });
    log.add(phase, 0.0, fit.runs(static_cast<int>(task.data.trials.size())));
    return fit;
}

}  // namespace myo::diagnosis
