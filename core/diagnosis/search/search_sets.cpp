#include "diagnosis/search/search_sets.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/screening/screen_effects.hpp"
#include "diagnosis/search/search_decisions.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Search in progress. Steps return false if the user cancelled.
class SearchOfSets {
public:
    SearchOfSets(const DiagnosisContext& context, RankedFits singles, FitStore& store, PhaseLog& log,
                 const SearchObserver& show, SetSearchExtent extent)
        : context_(context),
          data_(context.data),
          fits_(std::move(singles)),
          store_(store),
          log_(log),
          show_(show),
          extent_(extent) {
        current_ = *best_of_all(fits_);
        follow_current();
    }

    SetSearch run() {
        const SetPolicy& policy = context_.policy().sets;
        // A set from the beginnings may hold an effect that the whole recordings do not need.
        if (effects().size() > 1 && (!drop_idle() || !correct())) return {std::move(fits_), data_.shift};
        for (int round = 0; round < policy.max_rounds && is_open(); ++round) {
            const std::vector<effect::EffectDeclaration> before = effects();
            const bool grows = before.size() < policy.max_effects && !explains(current_, context_.baseline());
            // Forward if the larger set is worth its numbers, then backward; exchanges where growing does not help.
            const std::optional<JudgedFit> larger = grows ? best_extension(current_) : std::nullopt;
            if (log_.cancelled()) break;
            if (larger && is_better(*larger, current_, policy.min_evidence_ratio)) {
                adopt(*larger);
                // Back at the set before: the next round would repeat this one.
                if (!drop_idle() || !correct() || have_same_ids(effects(), before)) break;
            } else if (extent_ == SetSearchExtent::grown || !exchange()) {
                break;
            }
        }
        return {std::move(fits_), data_.shift};
    }

private:
    const std::vector<effect::EffectDeclaration>& effects() const { return current_.fit.effects; }
    std::size_t declared_effects() const { return context_.setup.experiment.effects.size(); }
    /// A set that no other trial tests is exchanged for another one if possible.
    bool is_open() const {
        return !log_.cancelled() && !explained(fits_.candidates, context_.baseline()) &&
               (!explains(current_, context_.baseline()) || is_untested(current_, context_.declared));
    }

    /// Whether the evidence of one fit is so many times that of another one.
    bool is_better(const JudgedFit& fit, const JudgedFit& than, double ratio) const {
        return evidence_ratio(data_, fit, than, context_.policy().judgement) > ratio;
    }

    /// Orders all fits and shows them.
    void rank() {
        fits_ = with_ranked_candidates(std::move(fits_), context_.baseline());
        fits_ = with_ranked_sets(std::move(fits_), context_.baseline());
        if (show_) show_(fits_);
    }

    /// Makes a fit the current set.
    void adopt(JudgedFit fit) {
        current_ = std::move(fit);
        follow_current();
    }
    /// Later fits are made with the numerical error of the current set's motion.
    void follow_current() {
        if (current_.numerics) data_.shift = current_.numerics->shift;
    }

    bool was_extended(const JudgedFit& fit) const {
        return std::any_of(extended_.begin(), extended_.end(), [&](const std::vector<effect::EffectDeclaration>& set) {
            return have_same_ids(set, fit.fit.effects);
        });
    }

    std::optional<JudgedFit> best_extension(const JudgedFit& of, const std::string& without = {});
    std::vector<CandidateStart> likely_starts(const std::vector<EffectScore>& scores, const JointFit& base) const;
    std::optional<JudgedFit> reduced(const JudgedFit& from, std::size_t dropped);
    bool is_needed(const JudgedFit& in, std::size_t effect);
    bool drop_idle();
    bool exchange();
    bool correct();

    const DiagnosisContext& context_;
    FitData data_;
    RankedFits fits_;
    FitStore& store_;
    PhaseLog& log_;
    const SearchObserver& show_;
    SetSearchExtent extent_;
    JudgedFit current_;
    std::vector<std::vector<effect::EffectDeclaration>> extended_;  // sets whose extensions were fitted
};

/// The best probes whose sets are predicted to come near the current one. In growing that is any of them; in an
/// exchange the other effect must make up for the one that was taken out.
std::vector<CandidateStart> SearchOfSets::likely_starts(const std::vector<EffectScore>& scores,
                                                        const JointFit& base) const {
    const double most = context_.policy().search.pruning_factor * current_.fit.squares();
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(scores, context_.settings.extensions, context_.policy().screening))
        if ((1.0 - scores[i].share()) * base.squares() < most) starts.push_back(start_of(scores[i]));
    return starts;
}

/// The best fit with one more effect, other than `without`; all are kept.
std::optional<JudgedFit> SearchOfSets::best_extension(const JudgedFit& of, const std::string& without) {
    extended_.push_back(of.fit.effects);
    // Kept fits have no traces, from which probes start.
    JointFit base = of.fit;
    base.predictions = prediction::predict_trials_with(context_.setup, base.values, data_.trials, log_.progress());
    if (log_.cancelled()) return {};
    // No effect acts twice in a set, and `without` was in it before.
    std::vector<std::string> excluded{without};
    for (const effect::EffectDeclaration& effect : base.effects) excluded.push_back(effect.id);
    const std::vector<EffectScore> scores = log_.timed(
        "score of sets", 0, [&] { return scores_from(context_, data_, base, ProbeSize::small, log_, excluded); });
    if (log_.cancelled()) return {};
    const std::vector<CandidateStart> starts = likely_starts(scores, base);
    // Larger sets must leave less than the best single effect, too.
    const double least = std::min(min_left(fits_.candidates), current_.fit.squares());
    std::vector<JudgedFit> fits = fit_candidates({context_.setup, data_, context_.settings, base, starts, least,
                                                  context_.policy().sets.pruning_factor, "refit of sets"},
                                                 store_, log_);
    const JudgedFit* best = nullptr;
    for (const JudgedFit& fit : fits) {
        // Fits that were finished before a cancellation count, too.
        if (!fit.usable()) continue;
        enter_fit(fits_, fit);
        if (!best || fit.fit.squares() < best->fit.squares()) best = &fit;
    }
    rank();
    return best ? std::optional(*best) : std::nullopt;
}

/// The fit without one of its effects, refitted from its values; to the end only if it may rival the set. Empty if that
/// fails.
std::optional<JudgedFit> SearchOfSets::reduced(const JudgedFit& from, std::size_t dropped) {
    const DiagnosisPolicy& policy = context_.policy();
    const auto fitted = [&](const prediction::ParameterValues& start, const Effort& effort) {
        return logged_fit("refit of sets", {context_.setup, data_, start, policy, EffectFreedom::all, effort}, store_,
                          log_);
    };
    JointFit fit = fitted(without_effect(from.fit.values, declared_effects() + dropped), policy.sets.drop);
    if (log_.cancelled() || !fit.usable()) return {};
    if (!fit.report.converged() && fit.squares() <= policy.search.pruning_factor * from.fit.squares()) {
        JointFit ended = fitted(fit.values, policy.search.polish);
        if (log_.cancelled()) return {};
        if (ended.usable() && ended.squares() < fit.squares()) fit = std::move(ended);
    }
    JudgedFit result = judged(data_, std::move(fit), context_.settings);
    enter_fit(fits_, result);
    rank();
    return result;
}

/// Whether the set without this effect is far from a rival already after a few evaluations.
bool SearchOfSets::is_needed(const JudgedFit& in, std::size_t effect) {
    const DiagnosisPolicy& policy = context_.policy();
    const prediction::ParameterValues start = without_effect(in.fit.values, declared_effects() + effect);
    const JointFit fit = logged_fit(
        "refit of sets",
        {context_.setup, data_, start, policy, EffectFreedom::all, policy.sets.glance, warm_start_of(in.fit)}, store_,
        log_);
    return fit.usable() && fit.squares() > policy.search.pruning_factor * in.fit.squares();
}

/// Drops effects without which the evidence does not fall. Also the last one: without it the others may end in a better
/// minimum than before.
bool SearchOfSets::drop_idle() {
    // From the last one added to the first; indices of those not visited yet stay valid when one is dropped.
    for (std::size_t i = effects().size(); i-- > 0 && effects().size() > 1;) {
        const bool needed = is_needed(current_, i);
        if (log_.cancelled()) return false;
        if (needed) continue;
        const std::optional<JudgedFit> smaller = reduced(current_, i);
        if (log_.cancelled()) return false;
        if (smaller && is_better(*smaller, current_, 1.0)) adopt(*smaller);
    }
    return true;
}

/// Exchanges an effect for another one, if one of the exchanges raises the evidence; false if none does.
bool SearchOfSets::exchange() {
    if (effects().size() < 2) return false;
    std::optional<JudgedFit> best;
    // All exchanges start from this set; current_ changes only if one is adopted.
    const JudgedFit from = current_;
    for (std::size_t i = 0; i < from.fit.effects.size() && !log_.cancelled(); ++i) {
        const std::optional<JudgedFit> smaller = reduced(from, i);
        // The extensions of a set that was extended before were weighed against each other then.
        if (!smaller || log_.cancelled() || was_extended(*smaller)) continue;
        const std::optional<JudgedFit> other = best_extension(*smaller, from.fit.effects[i].id);
        if (other && (!best || other->fit.squares() < best->fit.squares())) best = other;
    }
    if (!best || log_.cancelled() || !is_better(*best, current_, context_.policy().sets.min_evidence_ratio))
        return false;
    adopt(std::move(*best));
    return correct();
}

/// Removes the numerical error of the current set's own motion, if that is far from the declared one and a remainder
/// has to be judged.
bool SearchOfSets::correct() {
    if (!is_open() || !is_worth_correcting(current_, context_.declared, context_.policy().search))
        return !log_.cancelled();
    std::optional<JudgedFit> corrected = correct_discretisation(
        {context_.setup, data_, context_.settings, context_.refinement, "last fit",
         context_.policy().search.correction},
        current_, store_, log_);
    if (!corrected) return false;
    // As for single effects: an error that could not be computed is not tried again.
    if (!corrected->numerics) corrected->numerics = context_.numerics;
    for (JudgedFit& set : fits_.sets)
        if (have_same_ids(set.fit.effects, corrected->fit.effects)) set = *corrected;
    adopt(std::move(*corrected));
    rank();
    return true;
}

}  // namespace

SetSearch search_sets(const DiagnosisContext& context, RankedFits found, FitStore& store, PhaseLog& log,
                      const SearchObserver& show, SetSearchExtent extent) {
    const JudgedFit* const best = best_fit(found.candidates);
    if (found.sets.empty() && !(best && is_worth_a_set(*best, context.baseline())))
        return {std::move(found), context.data.shift};
    return SearchOfSets(context, std::move(found), store, log, show, extent).run();
}

}  // namespace myo::diagnosis
