#include "planning/power_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.hpp"
#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/missing_force/peak_energy.hpp"
#include "diagnosis/screening/effect_responses.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "effect/catalogue.hpp"
#include "experiment/new_effect.hpp"
#include "planning/detection.hpp"
#include "planning/effect_variants.hpp"
#include "planning/planned_trials.hpp"
#include "prediction/predict_trials.hpp"
#include "statistics/score_test.hpp"

namespace myo::planning {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The model without further effects, and what recalibration absorbs.
struct Reference {
    setup::Setup setup;
    diagnosis::FitData data;
    prediction::ParameterValues values;
    std::vector<prediction::ModelParameter> parameters;
    std::vector<prediction::TrialPrediction> predictions;
    effect::EffectSearch search;
    std::vector<ErrorBlock> blocks;
    double numerical_error = 0.0;  // [noise levels]
    std::string failure;

    diagnosis::UnaffectedRuns runs() const { return {setup, data, values, search, predictions}; }
};

/// Runs the planned trials with the declared values. `failure` is set if one cannot be run or none has a marker.
Reference reference_of(const setup::Setup& as_declared, const PowerSettings& settings, const Progress& progress) {
    const diagnosis::DiagnoseSettings all;
    Reference r;
    r.setup = with_planned_trials(diagnosis::prepared_setup(as_declared, all));
    r.data = diagnosis::fit_data(r.setup, prediction::trials_with_role(r.setup, experiment::TrialRole::fit));
    if (r.data.layout.size() == 0) {
        r.failure = "no trial to fit or to simulate has a marker that a camera would see";
        return r;
    }
    r.values = prediction::declared_values(r.setup);
    // With the steps that a diagnosis would use.
    r.setup = with_longer_steps(std::move(r.setup), r.values, all.policy.numerics.max_step_change, progress);
    r.parameters = diagnosis::joint_parameters(r.setup, r.values, all.policy.declared);
    // With tangents by all parameters that a calibration would fit.
    r.predictions = prediction::predict_trials_with(r.setup, r.values, r.data.trials, progress, r.parameters);
    for (std::size_t i = 0; i < r.predictions.size(); ++i)
        if (!r.predictions[i].ok()) {
            r.failure = "trial " + r.setup.trials[r.data.trials[i]].name +
                        " cannot be run with the declared values: " + r.predictions[i].message;
            return r;
        }
    r.data = diagnosis::with_unknown_places(r.setup, std::move(r.data), r.predictions);
    r.search = diagnosis::effect_search(r.setup, r.data, r.values);
    r.search.largest_energy_density_J_m3 = diagnosis::peak_isochoric_energy(r.search.models, r.predictions);
    r.blocks = error_blocks(r.data.layout);
    r.numerical_error = settings.numerical_error_m ? *settings.numerical_error_m / diagnosis::mean_noise_m(r.data)
                                                   : settings.policy.detection.numerical_error;
    return r;
}

/// A variant at one size with its response.
struct SizedVariant {
    std::size_t variant = 0;
    std::optional<double> size;
    std::vector<effect::EffectParameters> columns;
    statistics::ProjectedCandidate candidate;
    double noncentrality = 0.0;  // mean over the columns
    double squares = 0.0;        // of the change outside the nuisance space, likewise
    std::string failure;

    bool usable() const { return failure.empty() && candidate.rank() > 0; }
};

/// Runs the variants at their sizes and projects recalibration out.
void respond(const Reference& r, const statistics::NuisanceSpace& nuisance, const std::vector<EffectVariant>& variants,
             const std::string& task, const Progress& progress, std::vector<SizedVariant>& sized, PowerMap& map) {
    std::vector<effect::EffectDeclaration> effects;
    // All columns of all variants in one parallel call; `next` below follows the same order.
    for (const SizedVariant& s : sized)
        for (const effect::EffectParameters& column : s.columns)
            effects.push_back({variants[s.variant].effect->id, column, false,
                               effect::find_law(variants[s.variant].effect->id, r.setup.experiment.laws)});
    const std::vector<diagnosis::EffectResponse> responses = diagnosis::effect_responses(r.runs(), effects, {}, task,
                                                                                         progress);
    // No responses: the user cancelled.
    if (responses.empty()) return;
    map.runs += static_cast<int>(effects.size() * r.data.trials.size());
    std::size_t next = 0;
    for (SizedVariant& s : sized) {
        MatrixXd S(r.data.layout.size(), static_cast<Index>(s.columns.size()));
        for (Index c = 0; c < S.cols(); ++c, ++next) {
            if (!responses[next].failure.empty())
                s.failure = responses[next].failure;
            else
                S.col(c) = responses[next].change;
        }
        if (!s.failure.empty() || S.cols() == 0) continue;
        s.candidate = statistics::project_candidate(nuisance, S);
        // What a calibration would absorb is no evidence.
        const MatrixXd outside = nuisance.outside(S);
        for (Index c = 0; c < S.cols(); ++c) {
            s.noncentrality += noncentrality(outside.col(c), r.blocks, r.numerical_error) /
                               static_cast<double>(S.cols());
            s.squares += outside.col(c).squaredNorm() / static_cast<double>(S.cols());
        }
    }
}

/// Variant of median visibility among the usable ones of an effect; null if none is.
const SizedVariant* median_variant(const std::vector<SizedVariant>& sized, const std::vector<EffectVariant>& variants,
                                   const effect::Effect& effect) {
    std::vector<const SizedVariant*> own;
    for (const SizedVariant& s : sized)
        if (variants[s.variant].effect == &effect && s.usable()) own.push_back(&s);
    if (own.empty()) return nullptr;
    // The lower median of an even number: a place that really exists.
    const auto middle = own.begin() + static_cast<std::ptrdiff_t>((own.size() - 1) / 2);
    std::nth_element(own.begin(), middle, own.end(),
                     [](const SizedVariant* a, const SizedVariant* b) { return a->noncentrality < b->noncentrality; });
    return *middle;
}

/// Largest share of the response in any direction that recalibration leaves.
double largest_kept(const statistics::ProjectedCandidate& candidate) {
    return candidate.kept.size() > 0 ? candidate.kept.maxCoeff() : 0.0;
}

/// Why no variant of an effect changes what the markers show.
std::string reason_unseen(const effect::Effect& effect, const std::vector<SizedVariant>& sized,
                          const std::vector<EffectVariant>& variants, const experiment::Experiment& experiment) {
    if (const std::string lacking = experiment::lacking_for(effect, experiment); !lacking.empty())
        return "the experiment lacks " + lacking;
    for (const SizedVariant& s : sized)
        if (variants[s.variant].effect == &effect) {
            if (!s.failure.empty()) return "it could not be run: " + s.failure;
            if (s.candidate.length.size() > 0 && s.candidate.length.maxCoeff() > 0.0)
                return "the calibrated parameters make up for all of it";
        }
    return "nothing in these trials shows it apart from what is calibrated";
}

/// The other effect whose change is most similar.
void set_confusion(const SizedVariant& own, const std::vector<SizedVariant>& sized,
                   const std::vector<EffectVariant>& variants, EffectPower& power) {
    for (const SizedVariant& other : sized) {
        if (!other.usable() || variants[other.variant].effect->id == power.id) continue;
        const double cosine = std::abs(statistics::principal_cosine(own.candidate, other.candidate));
        if (cosine <= power.cosine) continue;
        power.cosine = cosine;
        power.confused_with = variants[other.variant].effect->id;
    }
}

/// From weak to strong.
void sort_sizes(const effect::Effect& effect, std::vector<SizePower>& sizes) {
    std::sort(sizes.begin(), sizes.end(), [&](const SizePower& a, const SizePower& b) {
        return effect.draw.grows ? a.size < b.size : a.size > b.size;
    });
}

/// Weakest detected size: between the sizes that were run by a power law, and below them with squares in proportion.
std::optional<double> detected_size(const effect::Effect& effect, const std::vector<SizePower>& sizes, double needed) {
    if (sizes.empty() || !std::isfinite(sizes.front().size)) return std::nullopt;
    // Below the range the response is linear, and the noncentrality quadratic in the size.
    if (sizes.front().noncentrality >= needed) {
        const double ratio = std::sqrt(needed / sizes.front().noncentrality);
        return sizes.front().size * (effect.draw.grows ? ratio : 1.0 / ratio);
    }
    for (std::size_t i = 1; i < sizes.size(); ++i) {
        const SizePower &below = sizes[i - 1], &above = sizes[i];
        if (above.noncentrality < needed) continue;
        // Straight line in the logarithms of size and noncentrality between two runs.
        const double share = below.noncentrality > 0.0 ? std::log(needed / below.noncentrality) /
                                                             std::log(above.noncentrality / below.noncentrality)
                                                       : 1.0;
        return below.size * std::pow(above.size / below.size, share);
    }
    return std::nullopt;
}

/// Power of a variant at its size. The test has as many degrees of freedom as the response has directions.
SizePower power_of(const SizedVariant& s, const Reference& r, const DetectionPolicy& policy) {
    const double freedom = std::max(1.0, static_cast<double>(s.candidate.rank()));
    return {s.size.value_or(std::nan("")),
            diagnosis::mean_noise_m(r.data) * std::sqrt(s.squares / static_cast<double>(r.data.layout.size())),
            s.noncentrality, detection_probability(s.noncentrality, freedom, policy.alpha)};
}

/// Middle size of an effect; empty if it has none.
std::optional<double> middle_size(const effect::Effect& effect, const PowerPolicy& policy) {
    const std::vector<double> sizes = effect_sizes(effect, policy.sizes);
    return sizes.empty() ? std::nullopt : std::optional(sizes[sizes.size() / 2]);
}

/// Variant number v with this size, not run yet.
SizedVariant sized_variant(const std::vector<EffectVariant>& variants, std::size_t v, std::optional<double> size) {
    std::vector<effect::EffectParameters> columns = sized_columns(variants[v], size);
    // A form without the amount is taken as it is.
    if (columns.empty()) return {v, std::nullopt, variants[v].columns, {}, 0.0, 0.0, {}};
    return {v, size, std::move(columns), {}, 0.0, 0.0, {}};
}

/// Effects that the settings ask for, laws of the experiment included.
std::vector<const effect::Effect*> considered_effects(const PowerSettings& settings, const effect::Laws& laws) {
    std::vector<const effect::Effect*> considered;
    for (const effect::Effect* const effect : effect::all_effects(laws))
        if (settings.only.empty() ||
            std::find(settings.only.begin(), settings.only.end(), effect->id) != settings.only.end())
            considered.push_back(effect);
    return considered;
}

/// Noncentrality with which a variant is detected as surely as wanted.
double needed_by(const SizedVariant& s, const DetectionPolicy& policy) {
    return needed_noncentrality(policy.wanted, std::max(1.0, static_cast<double>(s.candidate.rank())), policy);
}

/// Assembles the statement on one effect from the runs of its median form.
///
/// @param others  its median form at the other sizes
EffectPower effect_power(const effect::Effect& effect, const SizedVariant& own, const std::vector<SizedVariant>& others,
                         const Reference& r, const DetectionPolicy& policy) {
    EffectPower power;
    power.id = effect.id;
    power.amount = own.size ? effect.draw.amount : std::string();
    power.example = own.columns.front();
    power.kept = largest_kept(own.candidate);
    power.sizes.push_back(power_of(own, r, policy));
    for (const SizedVariant& other : others)
        if (other.failure.empty()) power.sizes.push_back(power_of(other, r, policy));
    sort_sizes(effect, power.sizes);
    power.detected = detected_size(effect, power.sizes, needed_by(own, policy));
    // The weakest size of the range is already detected: the threshold is an extrapolation.
    power.beyond_range = power.detected && power.sizes.front().probability >= policy.wanted;
    const bool any = std::any_of(power.sizes.begin(), power.sizes.end(),
                                 [&](const SizePower& size) { return size.probability >= policy.wanted; });
    if (power.kept < policy.least_kept)
        power.unseen = "the calibrated parameters make up for it";
    else if (!any)
        power.unseen = "no plausible size is detected";
    return power;
}

}  // namespace

PowerMap power_map(const setup::Setup& as_declared, const PowerSettings& settings, const Progress& progress) {
    const Stopwatch watch;
    const PlanningPolicy& policy = settings.policy;
    PowerMap map;
    map.alpha = policy.detection.alpha;
    map.wanted = policy.detection.wanted;
    // Every way out states time and cancellation; a stopped map holds no partial statements.
    const auto ended = [&] {
        map.stopped = progress.cancelled();
        map.seconds = watch.seconds();
        if (map.stopped) map.effects.clear();
        return map;
    };
    const Reference r = reference_of(as_declared, settings, progress);
    map.failure = r.failure;
    if (!r.failure.empty() || progress.cancelled()) return ended();
    map.noise_m = diagnosis::mean_noise_m(r.data);
    map.numerical_error_m = r.numerical_error * map.noise_m;
    map.samples = r.data.layout.size();
    for (const std::size_t t : r.data.trials) map.trials.push_back(r.setup.trials[t].name);
    for (const prediction::ModelParameter& p : r.parameters) map.parameters.push_back(p.parameter.name);
    const statistics::NuisanceSpace nuisance(diagnosis::flat_jacobian(r.data, r.predictions, r.parameters.size()));

    const std::vector<const effect::Effect*> considered = considered_effects(settings, r.setup.experiment.laws);
    // First all forms at one size, to find that of median visibility; only this one is run at the other sizes.
    std::vector<EffectVariant> variants;
    for (const effect::Effect* const effect : considered)
        // An effect on muscles needs muscles, and so on.
        if (experiment::lacking_for(*effect, r.setup.experiment).empty())
            for (EffectVariant& variant : effect_variants(*effect, r.search, r.setup, r.data.trials, policy.power))
                variants.push_back(std::move(variant));
    std::vector<SizedVariant> middle;
    for (std::size_t v = 0; v < variants.size(); ++v)
        middle.push_back(sized_variant(variants, v, middle_size(*variants[v].effect, policy.power)));
    respond(r, nuisance, variants, "middle sizes", progress, middle, map);
    if (progress.cancelled()) return ended();

    std::vector<SizedVariant> others;
    for (const effect::Effect* const effect : considered)
        if (const SizedVariant* const own = median_variant(middle, variants, *effect); own && own->size)
            for (const double size : effect_sizes(*effect, policy.power.sizes))
                if (size != *own->size) others.push_back(sized_variant(variants, own->variant, size));
    respond(r, nuisance, variants, "other sizes", progress, others, map);
    if (progress.cancelled()) return ended();

    std::vector<SizedVariant> at_threshold;
    for (const effect::Effect* const effect : considered) {
        const SizedVariant* const own = median_variant(middle, variants, *effect);
        if (!own) {
            EffectPower unseen;
            unseen.id = effect->id;
            unseen.unseen = reason_unseen(*effect, middle, variants, r.setup.experiment);
            map.effects.push_back(std::move(unseen));
            continue;
        }
        std::vector<SizedVariant> own_others;
        for (const SizedVariant& other : others)
            if (other.variant == own->variant) own_others.push_back(other);
        map.effects.push_back(effect_power(*effect, *own, own_others, r, policy.detection));
        set_confusion(*own, middle, variants, map.effects.back());
        if (map.effects.back().detected)
            at_threshold.push_back(sized_variant(variants, own->variant, map.effects.back().detected));
    }
    // Last, a run at the interpolated threshold, which replaces the interpolation by a shorter one.
    respond(r, nuisance, variants, "detected sizes", progress, at_threshold, map);
    for (const SizedVariant& s : at_threshold) {
        const effect::Effect& effect = *variants[s.variant].effect;
        EffectPower& power = *std::find_if(map.effects.begin(), map.effects.end(),
                                           [&](const EffectPower& p) { return p.id == effect.id; });
        if (!s.usable()) continue;
        std::vector<SizePower> sizes = power.sizes;
        sizes.push_back(power_of(s, r, policy.detection));
        sort_sizes(effect, sizes);
        power.detected = detected_size(effect, sizes, needed_by(s, policy.detection));
    }
    return ended();
}

}  // namespace myo::planning
