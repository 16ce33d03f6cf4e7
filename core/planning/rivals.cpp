#include "planning/rivals.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "effect/catalogue.hpp"
#include "experiment/new_effect.hpp"
#include "mesh/surface_mesh.hpp"
#include "planning/planned_trials.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::planning {
namespace {

using diagnosis::JointFit;
using prediction::ParameterValues;

/// A typical effect of this experiment.
/// The id must be that of an effect or a law.
effect::EffectDeclaration typical_effect(const std::string& id, const setup::Setup& setup) {
    const experiment::NewEffectPlace place{mesh::bounding_box(setup.surface.vertices),
                                           0.5 * setup.trials.front().options.end_s};
    return experiment::new_effect(*effect::find_effect(id, setup.experiment.laws), setup.experiment, place);
}

/// Fits of one setup to its data.
class Fits {
public:
    Fits(const setup::Setup& setup, const Progress& progress) : setup_(setup), progress_(progress) {
        data_ = diagnosis::fit_data(setup, prediction::trials_with_role(setup, experiment::TrialRole::fit));
        if (!(setup.experiment.markers.placement_m > 0.0)) return;
        const std::vector<prediction::TrialPrediction> declared = prediction::predict_trials_with(
            setup, prediction::declared_values(setup), data_.trials, progress);
        if (prediction::all_ok(declared)) data_ = diagnosis::with_unknown_places(setup, std::move(data_), declared);
    }

    const diagnosis::FitData& data() const { return data_; }

    JointFit fit(const ParameterValues& start, const diagnosis::Effort& effort,
                 const diagnosis::WarmStart& warm = {}) const {
        return diagnosis::joint_fit({setup_, data_, start, policy_, diagnosis::EffectFreedom::all, effort, warm},
                                    progress_);
    }
    /// Fit of the declared model.
    JointFit declared() const { return fit(prediction::declared_values(setup_), policy_.declared.effort); }

    /// The effects of the set one after the other, each from its best score on what the others leave.
    ///
    /// @param declared  fit without them
    JointFit of_set(const std::vector<std::string>& ids, const JointFit& declared) const {
        JointFit best = declared;
        for (const std::string& id : ids) {
            if (!best.usable() || progress_.cancelled()) return best;
            ParameterValues start = best.values;
            const diagnosis::EffectScore::Start scored = best_start(best, id);
            for (std::size_t i = 0; i < best.parameters.size() && scored.step.size() > 0; ++i) {
                const prediction::ModelParameter& p = best.parameters[i];
                const double value = prediction::value_of(p, start) + scored.step(static_cast<Eigen::Index>(i));
                prediction::set_value(p, std::clamp(value, p.parameter.lower, p.parameter.upper), start);
            }
            start.effects.push_back({id, scored.effect, false, effect::find_law(id, setup_.experiment.laws)});
            // All effects found so far are fitted together with the new one.
            best = fit(start, policy_.fits.leader, diagnosis::warm_start_of(best));
        }
        return best;
    }
    /// Fitted values of a report, evaluated.
    JointFit at(const RivalStart& known) const {
        ParameterValues values = prediction::declared_values(setup_);
        for (effect::EffectDeclaration effect : known.effects) {
            effect.law = effect::find_law(effect.id, setup_.experiment.laws);
            values.effects.push_back(std::move(effect));
        }
        for (const prediction::ModelParameter& p : prediction::free_parameters(setup_))
            if (const auto value = known.parameters.find(p.parameter.name); value != known.parameters.end())
                prediction::set_value(p, value->second, values);
        // One evaluation: residual and Jacobian at these values.
        return fit(values, {1});
    }

private:
    /// Start of an effect by its best small probe; a typical one if no probe explains anything.
    diagnosis::EffectScore::Start best_start(const JointFit& base, const std::string& id) const {
        const std::vector<diagnosis::EffectScore> scores = diagnosis::score_effects(
            setup_, data_, base, base.predictions, [&](const std::string& other) { return other == id; },
            diagnosis::ProbeSize::small, policy_.screening, progress_);
        const auto best = std::max_element(scores.begin(), scores.end(),
                                           [](const auto& a, const auto& b) { return a.share() < b.share(); });
        if (best == scores.end() || !best->usable() || best->best.effect.empty())
            return {typical_effect(id, setup_).parameters, {}};
        return best->best;
    }

    const setup::Setup& setup_;
    const Progress& progress_;
    diagnosis::FitData data_;
    diagnosis::DiagnosisPolicy policy_;
};

/// The trials as the first rival with effects would show them.
Result<setup::Setup> with_typical_motion(setup::Setup setup, const std::array<RivalStart, 2>& starts,
                                         const Progress& progress) {
    // The declared model would show no difference from what is already assumed.
    const RivalStart& truth = starts[0].ids.empty() ? starts[1] : starts[0];
    ParameterValues values = prediction::declared_values(setup);
    for (const std::string& id : truth.ids) values.effects.push_back(typical_effect(id, setup));
    return with_motion(with_planned_trials(std::move(setup)), values, progress);
}

}  // namespace

std::string rival_words(const std::vector<std::string>& ids) {
    return ids.empty() ? "the declared model" : join(ids, " and ");
}

Rival rival_of(const JointFit& fit, const diagnosis::FitData& data) {
    Rival rival;
    for (const effect::EffectDeclaration& effect : fit.effects) rival.ids.push_back(effect.id);
    rival.values = fit.values;
    rival.parameters = fit.parameters;
    rival.slopes = diagnosis::all_slopes(fit);
    rival.blocks = error_blocks(data.layout);
    return rival;
}

Result<FittedRivals> fitted_rivals(const setup::Setup& as_declared, const std::array<RivalStart, 2>& starts,
                                   const Progress& progress) {
    FittedRivals result;
    result.setup = diagnosis::prepared_setup(as_declared, {});
    // Planning before any measurement: the fits need a motion to be linearised at.
    result.made_motion = !has_fit_recording(result.setup);
    if (result.made_motion) {
        Result<setup::Setup> made = with_typical_motion(std::move(result.setup), starts, progress);
        if (!made) return made.error();
        result.setup = std::move(*made);
    }
    const ParameterValues at = prediction::declared_values(result.setup);
    result.setup = with_longer_steps(std::move(result.setup), at, diagnosis::NumericsPolicy().max_step_change,
                                     progress);
    const Fits fits(result.setup, progress);
    if (fits.data().layout.size() == 0) return Error{"no marker is seen in the trials to fit", ""};
    const auto is_known = [](const RivalStart& start) { return !start.effects.empty() || !start.parameters.empty(); };
    // The fit without effects is needed only where a set has to be fitted from it.
    const JointFit declared = is_known(starts[0]) && is_known(starts[1]) ? JointFit() : fits.declared();
    for (std::size_t i = 0; i < starts.size(); ++i) {
        progress.report({"fit of " + rival_words(starts[i].ids), static_cast<double>(i), 2.0, "fits", {}});
        const JointFit fit = is_known(starts[i]) ? fits.at(starts[i]) : fits.of_set(starts[i].ids, declared);
        if (progress.cancelled()) return Error{"stopped", ""};
        if (!fit.usable()) return Error{rival_words(starts[i].ids) + " cannot be fitted: " + fit.report.message, ""};
        result.rivals[i] = rival_of(fit, fits.data());
        result.rms_m[i] = diagnosis::flat_rms_m(fits.data(), fit.residual);
    }
    return result;
}

}  // namespace myo::planning
