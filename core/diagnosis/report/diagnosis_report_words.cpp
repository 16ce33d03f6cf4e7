#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/markup.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "results/calibration_report.hpp"
#include "results/readable_parameter.hpp"

namespace myo::diagnosis {
namespace {

/// The name with a small first letter.
std::string in_sentence(std::string name) {
    if (!name.empty()) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

/// Effects of the experiment precede those that were tried.
bool is_tried(const setup::Setup& setup, const prediction::ModelParameter& p) {
    return p.kind == prediction::ModelParameter::Kind::effect && p.index >= setup.experiment.effects.size();
}

/// Estimate of one fitted parameter, in the unit in which people read it.
EffectEstimate estimate_of(const setup::Setup& setup, const JointFit& fit, std::size_t i) {
    const results::ReadableParameter shown = results::readable_parameter(fit.parameters[i], setup);
    const auto row = static_cast<Eigen::Index>(i);
    const double deviation = row < fit.report.deviations.size() ? fit.report.deviations(row) : std::nan("");
    const results::ReadableEstimate estimate = results::readable_estimate(
        shown.factor * prediction::value_of(fit.parameters[i], fit.values), shown.factor * deviation);
    return {shown.name, estimate.value, estimate.deviation, shown.unit};
}

/// Parameters that are not fitted: names, axes.
std::string other_words(const effect::EffectDeclaration& effect) {
    std::string words;
    for (const auto& [name, value] : effect.parameters) {
        std::string text;
        if (const auto* const one = std::get_if<std::string>(&value)) text = *one;
        if (const auto* const several = std::get_if<std::vector<std::string>>(&value))
            for (const std::string& each : *several) text += (text.empty() ? "" : " and ") + each;
        if (const auto* const number = std::get_if<double>(&value); number && name == "axis")
            text = std::string(1, "xyz"[std::clamp(static_cast<int>(*number), 0, 2)]);
        if (!text.empty()) words += (words.empty() ? "" : ", ") + results::readable_quantity(name).name + " " + text;
    }
    return words;
}

}  // namespace

std::string name_in_sentence(const std::string& effect_id) { return in_sentence(results::effect_name(effect_id)); }

std::string names_of(const std::vector<effect::EffectDeclaration>& effects) {
    std::string names;
    for (std::size_t i = 0; i < effects.size(); ++i)
        names += (i == 0 ? "" : i + 1 == effects.size() ? " and " : ", ") + name_in_sentence(effects[i].id);
    return names;
}

std::string after_words(const Diagnosis& d) {
    const std::string names = names_of(d.augmented.fit.effects);
    if (names.empty()) return "declared model, fitted again";
    return (d.verdict.kind == VerdictKind::unknown ? "best attempt, " : "with ") + names;
}

bool has_two_fits(const Diagnosis& d) {
    return d.verdict.kind != VerdictKind::none && !d.augmented.fit.effects.empty();
}

std::string p_words(double p) {
    if (!std::isfinite(p)) return "–";
    return p < 1e-12 ? "< 10⁻¹²" : readable_number(std::min(p, 1.0), 2);
}

std::vector<EffectEstimate> effect_estimates(const setup::Setup& setup, const JointFit& fit) {
    std::vector<EffectEstimate> list;
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
        if (is_tried(setup, fit.parameters[i])) list.push_back(estimate_of(setup, fit, i));
    return list;
}

std::string estimate_words(const EffectEstimate& e) {
    return e.value + (e.deviation.empty() ? "" : " ± " + e.deviation) + (e.unit.empty() ? "" : "\u00a0" + e.unit);
}

std::string fitted_words(const setup::Setup& setup, const JointFit& fit) {
    std::string words;
    for (const EffectEstimate& e : effect_estimates(setup, fit)) {
        // The name of a single effect stands before the table cell; of several, each value needs it.
        const std::string name = fit.effects.size() > 1 ? in_sentence(e.name)
                                                        : e.name.substr(std::min(e.name.size(), e.name.find(", ") + 2));
        words += (words.empty() ? "" : ", ") + name + " " + estimate_words(e);
    }
    for (const effect::EffectDeclaration& effect : fit.effects)
        if (const std::string other = other_words(effect); !other.empty()) words += (words.empty() ? "" : ", ") + other;
    return words;
}

}  // namespace myo::diagnosis
