#include "trust/effect_level.hpp"

#include <algorithm>
#include <cmath>

#include "project/predict_trials.hpp"
#include "trust/synthetic_effects.hpp"
#include "trust/synthetic_experiment.hpp"
#include "trust/truth_model.hpp"

namespace myo {

EffectLevel::EffectLevel(const SyntheticCase& c, Study study, const Progress& progress) : study_(std::move(study)), progress_(progress) {
    study_.settings.derivatives = Derivatives::differences;
    study_.noise_m.setConstant(c.noise_m);   // an estimate would be that of the traces, which are still to be made
    data_ = fit_data(study_, trials_with_role(study_, TrialRole::fit));
    without_ = true_values(c, study_);
    without_.effects.clear();
    const std::vector<StudyParameter> parameters = study_parameters(study_);
    const std::vector<TrialPrediction> found = predictions(without_, parameters);
    if (found.empty()) return;
    residual_ = flat_residual(data_, found);
    space_ = std::make_unique<NuisanceSpace>(flat_jacobian(data_, found, parameters.size()));
}

std::vector<TrialPrediction> EffectLevel::predictions(const StudyValues& values, const std::vector<StudyParameter>& parameters) const {
    std::vector<PredictionTask> tasks;
    for (const std::size_t trial : data_.trials) tasks.push_back({trial, &values});
    std::vector<TrialPrediction> found = predict_trials(study_, tasks, parameters, progress_.with_sink({}));
    if (std::all_of(found.begin(), found.end(), [](const TrialPrediction& p) { return p.ok(); })) return found;
    return {};
}

std::optional<double> EffectLevel::of(const EffectDeclaration& effect) const {
    StudyValues values = without_;
    values.effects.push_back(effect);
    const std::vector<TrialPrediction> found = predictions(values, {});
    if (found.empty()) return {};
    const Eigen::VectorXd change = flat_residual(data_, found) - residual_;
    const double rms = std::sqrt(space_->outside(change).squaredNorm() / static_cast<double>(change.size()));
    if (!std::isfinite(rms)) return {};
    return rms;
}

std::optional<EffectDeclaration> visible_effect(const SyntheticCase& c, const EffectLevel& levels, double& level) {
    const EffectDraw& draw = *find_effect_draw(c.effect->id);
    EffectDeclaration effect = *c.effect;
    std::optional<double> found = levels.of(effect);
    if (draw.amount.empty()) {
        level = found.value_or(0.0);
        return level > least_level ? std::optional(effect) : std::nullopt;
    }
    double power = draw.grows ? 1.0 : -1.0;   // level ~ amount^power, improved by the secant of logarithms
    double last_amount = 0.0, last_level = 0.0;
    for (int round = 0; round < 7; ++round) {
        const double amount = effect_amount(effect);
        if (found && *found > 1.05 * least_level && *found < 0.95 * most_level && (round > 1 || std::abs(std::log(*found / c.wanted_level)) < 0.3)) {
            level = *found;
            return effect;
        }
        // What does not run is too much.
        double next = draw.grows ? amount / 5.0 : amount * 5.0;
        if (found && *found > 0.0) {
            if (last_level > 0.0 && last_amount != amount) {
                const double secant = std::log(*found / last_level) / std::log(amount / last_amount);
                if (secant * power > 0.2) power = std::copysign(std::min(std::abs(secant), 3.0), power);
            }
            last_amount = amount;
            last_level = *found;
            next = amount * std::pow(c.wanted_level / *found, 1.0 / power);
        }
        next = std::clamp(next, draw.lowest, draw.highest);
        if (next == amount) return {};
        effect = with_amount(effect, next);
        found = levels.of(effect);
    }
    return {};
}

}  // namespace myo
