#include "diagnosis/fit/stored_fit.hpp"

#include <limits>

#include "base/text.hpp"
#include "diagnosis/report/effect_words.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Digits from which a double is restored exactly.
constexpr int all_digits = std::numeric_limits<double>::max_digits10;

/// Number that distinguishes shifts in the key of a fit.
double fingerprint(const PredictionShift& shift) {
    double sum = 0.0;
    for (const auto& trial : shift)
        for (const auto& marker : trial) sum += marker.squaredNorm();
    return sum;
}

}  // namespace

JointFit stored_fit(FitStore& store, const setup::Setup& setup, const FitData& data,
                    const prediction::ParameterValues& start, EffectFreedom freedom, const Effort& effort,
                    const Neighbourhood& known, const Progress& progress) {
    inverse::LeastSquaresOptions options;
    options.max_evaluations = effort.evaluations;
    options.relative_decrease = effort.relative_decrease;
    options.max_jacobians = effort.most_jacobians;
    options.relative_step = diagnosis_policy.fits.relative_step;
    const std::vector<prediction::ModelParameter> parameters = joint_parameters(setup, start, freedom);
    std::string key = std::to_string(effort.evaluations) + " shift " +
                      format_number(fingerprint(data.shift), all_digits) + " modulus factor " +
                      format_number(setup.modulus_factor, all_digits) + " steps";
    for (const std::size_t t : data.trials) key += " " + format_number(setup.trials[t].options.h_s, all_digits);
    for (const effect::EffectDeclaration& effect : start.effects) key += " " + effect_words(effect);
    for (const prediction::ModelParameter& p : parameters)
        key += " " + p.parameter.name + " " + format_number(p.parameter.value, all_digits);
    prediction::ParameterValues from = start;
    if (const std::optional<VectorXd> done = store.find(key);
        done && done->size() == static_cast<Index>(parameters.size())) {
        for (std::size_t i = 0; i < parameters.size(); ++i)
            prediction::set_value(parameters[i], (*done)(static_cast<Index>(i)), from);
        options.max_evaluations = 0;
    }
    JointFit fit = joint_fit(setup, data, from, freedom, options, known, progress);
    if (!fit.usable() || progress.cancelled()) return fit;
    VectorXd found(static_cast<Index>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        found(static_cast<Index>(i)) = prediction::value_of(parameters[i], fit.values);
    static_cast<void>(store.keep(key, found));
    return fit;
}

}  // namespace myo::diagnosis
