#include "validation/effect_level.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prediction/predict_trials.hpp"
#include "validation/synthetic_effects.hpp"
#include "validation/synthetic_experiment.hpp"
#include "validation/truth_model.hpp"

namespace myo::validation {
namespace {

// Evaluations of a recalibration, and amounts that are tried for one draw.
constexpr int max_evaluations = 8, max_rounds = 8;

/// Root mean square; residuals in units of the noise give a level.
double rms(const Eigen::VectorXd& residual) {
    return std::sqrt(residual.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, residual.size())));
}

/// With a margin, because the truth is simulated on another mesh.
bool is_visible(double level) { return level > 1.05 * min_level && level < 0.95 * max_level; }

/// Recalibration of a few percent, by secant updates of the Jacobian without the effect.
constexpr diagnosis::Effort recalibration{max_evaluations, 0.03, 0};
constexpr diagnosis::Effort first_fit{1, 0.03, 1};

/// Policy of a diagnosis with a looser criterion of convergence: levels need no more than a few percent.
diagnosis::DiagnosisPolicy recalibration_policy() {
    diagnosis::DiagnosisPolicy policy;
    policy.fits.relative_step = 1e-4;
    return policy;
}

}  // namespace

EffectLevel::EffectLevel(const SyntheticCase& c, setup::Setup setup, const Progress& progress)
    : setup_(std::move(setup)), progress_(progress.with_sink({})) {
    setup_.noise_m.setConstant(c.noise_m);  // the traces that an estimate would need do not exist yet
    data_ = diagnosis::fit_data(setup_, prediction::trials_with_role(setup_, experiment::TrialRole::fit));
    without_ = true_values(c, setup_);
    without_.effects.clear();
    const diagnosis::DiagnosisPolicy policy = recalibration_policy();
    const diagnosis::JointFit fit = diagnosis::joint_fit(
        {setup_, data_, without_, policy, diagnosis::EffectFreedom::all, first_fit}, progress_);
    if (!fit.usable()) return;
    warm_start_ = diagnosis::warm_start_of(fit);
    recalibrated_.emplace(warm_start_.columns);
    without_effect_ = fit.residual;
}

std::optional<Eigen::VectorXd> EffectLevel::change_by(const effect::EffectDeclaration& effect,
                                                      std::vector<prediction::TrialPrediction>& with) const {
    prediction::ParameterValues values = without_;
    values.effects.push_back(effect);
    with = prediction::predict_trials_with(setup_, values, data_.trials, progress_);
    if (!prediction::all_ok(with)) return {};
    Eigen::VectorXd change = diagnosis::flat_residual(data_, with) - without_effect_;
    return change.allFinite() ? std::optional(std::move(change)) : std::nullopt;
}

std::optional<EffectLevel::Level> EffectLevel::of(const effect::EffectDeclaration& effect) const {
    Level level;
    const std::optional<Eigen::VectorXd> change = change_by(effect, level.with);
    if (!change) return {};
    // Projection onto the complement of the parameter space: what a linear recalibration cannot absorb.
    level.first_order = rms(recalibrated_->outside(*change));
    return level;
}

std::optional<double> EffectLevel::least_of_set(const std::vector<effect::EffectDeclaration>& effects) const {
    const Eigen::MatrixXd& declared = warm_start_.columns;
    const auto count = static_cast<Eigen::Index>(effects.size());
    Eigen::MatrixXd all(declared.rows(), declared.cols() + count - 1), changes(declared.rows(), count);
    for (Eigen::Index i = 0; i < count; ++i) {
        std::vector<prediction::TrialPrediction> with;
        const std::optional<Eigen::VectorXd> change = change_by(effects[static_cast<std::size_t>(i)], with);
        if (!change) return {};
        changes.col(i) = *change;
    }
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < count; ++i) {
        all << declared, changes.leftCols(i), changes.rightCols(count - 1 - i);
        least = std::min(least, rms(statistics::NuisanceSpace(all).outside(changes.col(i))));
    }
    return least;
}

double EffectLevel::fitted(const Level& level) const {
    setup::Setup seen = setup_;
    // The motion with the effect is taken for the recording, and the model without the effect is fitted to it.
    for (std::size_t i = 0; i < data_.trials.size(); ++i)
        seen.trials[data_.trials[i]].measured.tracks = level.with[i].positions_m;
    const diagnosis::DiagnosisPolicy policy = recalibration_policy();
    const diagnosis::JointFit fit = diagnosis::joint_fit(
        {seen, data_, without_, policy, diagnosis::EffectFreedom::all, recalibration, warm_start_}, progress_);
    return fit.usable() && fit.residual.allFinite() ? rms(fit.residual) : 0.0;
}

std::optional<effect::EffectDeclaration> visible_effect(const SyntheticCase& c, std::size_t which,
                                                        const EffectLevel& levels, double& level) {
    effect::EffectDeclaration effect = c.effects[which];
    const effect::EffectDraw& draw = effect_draw(effect.id);
    std::optional<EffectLevel::Level> found = levels.of(effect);
    // An effect without amount is visible as it is, or the case is drawn again.
    if (draw.amount.empty()) {
        level = found ? levels.fitted(*found) : 0.0;
        return level > min_fitted ? std::optional(effect) : std::nullopt;
    }
    double power = draw.grows ? 1.0 : -1.0;  // level ~ amount^power, refined by secants of the logarithms
    double last_amount = 0.0, last_level = 0.0;
    double wanted = c.wanted_levels[which];
    for (int round = 0; round < max_rounds; ++round) {
        const double amount = effect_amount(effect);
        const double there = found ? found->first_order : 0.0;
        // The first two rounds aim at the wanted level within a third; later ones accept any visible level.
        if (is_visible(there) && (round > 1 || std::abs(std::log(there / wanted)) < 0.3)) {
            level = levels.fitted(*found);
            if (level > min_fitted) return effect;
            // Too little is left after the fit: a larger amount is tried, as long as the level may grow.
            wanted = std::min(1.6 * std::max(wanted, there), 0.9 * max_level);
            if (there > 0.85 * max_level) return {};
        }
        // A run that fails means that the amount is too large.
        double next = draw.grows ? amount / 5.0 : amount * 5.0;
        if (found && found->first_order > 0.0) {
            if (last_level > 0.0 && last_amount != amount) {
                const double secant = std::log(found->first_order / last_level) / std::log(amount / last_amount);
                // A secant of the wrong sign or nearly flat is not trusted; the exponent is limited so that no step
                // becomes tiny.
                if (secant * power > 0.2) power = std::copysign(std::min(std::abs(secant), 3.0), power);
            }
            last_amount = amount;
            last_level = found->first_order;
            next = amount * std::pow(wanted / found->first_order, 1.0 / power);
        }
        next = std::clamp(next, draw.lowest, max_amount(c, effect.id));
        // At a limit of the amount: nothing else can be tried.
        if (next == amount) return {};
        effect = with_amount(effect, next);
        found = levels.of(effect);
    }
    return {};
}

}  // namespace myo::validation
