#include "diagnosis/search/search_effects.hpp"

#include <algorithm>
#include <utility>

#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/search/search_decisions.hpp"

namespace myo::diagnosis {
namespace {

/// Search in progress. Steps return false if the user cancelled.
class Search {
public:
    Search(const SingleSearchInput& in, RankedFits fits, FitStore& store, PhaseLog& log)
        : context_(in.context),
          screening_(in.screening),
          store_(store),
          log_(log),
          show_(in.show),
          fits_(std::move(fits)) {
        rank();
    }

    // Each step is described at its definition.
    bool fit_starts(const std::vector<CandidateStart>& starts, double pruning_factor);
    bool fit_starts(const std::vector<CandidateStart>& starts) { return fit_starts(starts, policy().pruning_factor); }
    bool correct_best();
    bool polish_best();
    bool fit_elsewhere();
    bool fit_large_probes();
    bool correct_rivals();

    bool is_explained(Leniency leniency = Leniency::tolerant) const {
        return explained(fits_.candidates, context_.baseline(), leniency);
    }
    bool is_far() const { return is_far_from_explained(fits_.candidates, context_.baseline()); }
    /// Fit of the most credible candidate, or null.
    const JudgedFit* best() const { return best_fit(fits_.candidates); }
    /// Squared residual that the fit of an effect leaves; infinite without one.
    double left(const std::string& effect) const { return left_by(fits_.candidates, effect); }
    const RankedFits& fits() const { return fits_; }

private:
    const SearchPolicy& policy() const { return context_.policy().search; }
    const JointFit& base() const { return screening_.base(context_); }
    std::vector<Candidate>& candidates() { return fits_.candidates; }

    /// To be called after every change of fits: all decisions read the order of the candidates.
    void rank() {
        fits_ = with_ranked_candidates(std::move(fits_), context_.baseline());
        if (show_) show_(fits_);
    }
    bool correct(JudgedFit& fit);
    bool polish(JudgedFit& fit);

    const DiagnosisContext& context_;
    const Screening& screening_;
    FitStore& store_;
    PhaseLog& log_;
    const SearchObserver& show_;
    RankedFits fits_;
};

/// Fits candidates from the starts; a fit replaces the earlier one of its effect if it is better.
bool Search::fit_starts(const std::vector<CandidateStart>& starts, double pruning_factor) {
    if (starts.empty()) return true;
    std::vector<JudgedFit> fits = fit_candidates({context_.setup, context_.data, context_.settings, base(), starts,
                                                  min_left(candidates()), pruning_factor, "refit"},
                                                 store_, log_);
    // Fits that were finished before a cancellation count, too.
    for (std::size_t i = 0; i < fits.size(); ++i)
        for (Candidate& candidate : candidates())
            if (candidate.score.id == starts[i].effect.id && fits[i].usable() &&
                !(candidate.judged && candidate.judged->fit.squares() < fits[i].fit.squares()))
                candidate.judged = std::move(fits[i]);
    rank();
    return !log_.cancelled();
}

/// Removes the numerical error of the fit's own motion.
bool Search::correct(JudgedFit& fit) {
    std::optional<JudgedFit> corrected = correct_discretisation(
        {context_.setup, context_.data, context_.settings, context_.refinement, "last fit", policy().correction}, fit,
        store_, log_);
    if (!corrected) return false;
    fit = std::move(*corrected);
    // An error that could not be computed must not be tried again.
    if (!fit.numerics) fit.numerics = context_.numerics;
    return true;
}

/// Continues a fit that used secants or few evaluations, with new derivatives.
bool Search::polish(JudgedFit& fit) {
    if (!is_unpolished(fit)) return true;
    JointFit again = logged_fit(
        "refit",
        {context_.setup, context_.data, fit.fit.values, context_.policy(), EffectFreedom::all, policy().polish}, store_,
        log_);
    if (log_.cancelled()) return false;
    if (again.usable() && again.squares() < fit.fit.squares())
        fit = judged(context_.data, std::move(again), context_.settings);
    else
        fit.fit.report.jacobians += again.report.jacobians;  // derivatives spent on this fit
    return true;
}

/// Recomputes the numerical error at the best candidates if they explain most but not all of the residual: it was
/// computed at the declared fit, whose motion may be far off.
bool Search::correct_best() {
    const std::size_t count = std::min(policy().corrected_candidates, candidates().size());
    for (std::size_t i = 0; i < count; ++i) {
        std::optional<JudgedFit>& fit = candidates()[i].judged;
        if (!fit || !is_worth_correcting(*fit, context_.declared, policy())) continue;
        // Candidates behind one that explains the residual need no better error.
        if (explains(*fit, context_.baseline())) break;
        if (!correct(*fit)) return false;
    }
    rank();
    return true;
}

/// Continues the best fits if none explains the residual.
bool Search::polish_best() {
    if (is_explained() || candidates().empty()) return true;
    const std::size_t count = std::min(policy().polished_candidates, candidates().size());
    for (std::size_t i = 0; i < count; ++i)
        if (std::optional<JudgedFit>& fit = candidates()[i].judged; fit && !polish(*fit)) return false;
    return correct_best();
}

/// Fits effects with a place or an axis that come close to the best, from other places and axes.
bool Search::fit_elsewhere() {
    const double most = policy().pruning_factor * min_left(candidates());
    std::vector<CandidateStart> starts;
    for (const std::size_t i : other_places(
             screening_.scores, [&](const std::string& id) { return left(id) <= most; }, context_.policy().screening))
        starts.push_back(start_of(screening_.scores[i]));
    return fit_starts(starts);
}

/// Scores and fits large probes: small ones underestimate effects whose response is quadratic in their amount.
bool Search::fit_large_probes() {
    const std::vector<EffectScore> scores = log_.timed("score", context_.fit_count(), [&] {
        return scores_from(context_, context_.data, base(), ProbeSize::large, log_);
    });
    if (log_.cancelled()) return false;
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(scores, context_.settings.refits, context_.policy().screening))
        for (Candidate& candidate : candidates())
            if (candidate.score.id == scores[i].id && scores[i].share() > candidate.score.share()) {
                candidate.score = scores[i];
                starts.push_back(start_of(scores[i]));
            }
    return starts.empty() || (fit_starts(starts) && correct_best() && polish_best());
}

/// Compares rivals of the best fit on equal terms, each with the numerical error of its own motion: that of the
/// declared fit suits some motions better than others (a delayed signal bends between steps, drag and damping act at
/// other speeds).
bool Search::correct_rivals() {
    const double least = min_left(candidates());
    const auto competes = [&](const Candidate& candidate) { return is_rival(candidate, least, policy()); };
    for (std::size_t i = 0; i < std::min(policy().polished_rivals, candidates().size()); ++i)
        if (competes(candidates()[i]) && !polish(*candidates()[i].judged)) return false;
    rank();
    const std::size_t count = std::min(policy().corrected_candidates + 1, candidates().size());
    const auto end = candidates().begin() + static_cast<std::ptrdiff_t>(count);
    // One rival alone is compared with nothing.
    if (std::count_if(candidates().begin(), end, competes) < 2) return true;
    for (auto candidate = candidates().begin(); candidate != end; ++candidate)
        if (competes(*candidate) && !candidate->judged->numerics && !correct(*candidate->judged)) return false;
    rank();
    return true;
}

/// Starts [first, last); empty if first is beyond last.
std::vector<CandidateStart> part_of(const std::vector<CandidateStart>& starts, std::size_t first, std::size_t last) {
    return {starts.begin() + static_cast<std::ptrdiff_t>(std::min(first, last)),
            starts.begin() + static_cast<std::ptrdiff_t>(last)};
}

/// Fits from the best probes: the first few, and then all that may still win. Returns false if cancelled.
bool fit_likely(Search& search, const DiagnosisContext& context, const Screening& screening) {
    const SearchPolicy& policy = context.policy().search;
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(screening.scores, context.settings.refits, context.policy().screening))
        starts.push_back(start_of(screening.scores[i]));
    const std::size_t first = std::min(policy.first_fits, starts.size());
    if (!search.fit_starts(part_of(starts, 0, first)) || !search.correct_best()) return false;
    // Where the best is far off, sets are tried before it is polished.
    if (!search.is_far() && !search.polish_best()) return false;
    const std::size_t last = starts_worth_fitting(starts, search.best(), context.declared,
                                                  search.is_explained(Leniency::strict), policy);
    return search.fit_starts(part_of(starts, first, last),
                             search.is_far() ? policy.far_pruning_factor : policy.pruning_factor);
}

/// Fits from all other starts, and compares rivals. Returns false if cancelled.
bool fit_unlikely(Search& search, const DiagnosisContext& context, const Screening& screening) {
    // A faint residual does not justify a long search.
    if (is_faint(context.baseline())) return search.correct_rivals();
    // Each further step is left out once an effect explains the residual.
    if (!search.is_explained(Leniency::strict)) {
        // Effects whose fit made no progress probably started outside of the linear range.
        const double most = context.policy().search.restart_share * screening.base(context).squares();
        if (!search.fit_starts(nonlinear_starts(
                screening.scores, [&](const EffectScore& score) { return search.left(score.id) >= most; })))
            return false;
    }
    if (!search.is_explained(Leniency::strict) && !search.fit_elsewhere()) return false;
    if (!search.is_explained() && (!search.correct_best() || !search.polish_best())) return false;
    if (!search.is_explained() && !search.fit_large_probes()) return false;
    return search.correct_rivals();
}

}  // namespace

RankedFits search_likely_effects(const SingleSearchInput& in, RankedFits found, FitStore& store, PhaseLog& log) {
    Search search(in, std::move(found), store, log);
    static_cast<void>(fit_likely(search, in.context, in.screening));
    return search.fits();
}

RankedFits search_all_effects(const SingleSearchInput& in, RankedFits likely, FitStore& store, PhaseLog& log) {
    Search search(in, std::move(likely), store, log);
    static_cast<void>(fit_unlikely(search, in.context, in.screening));
    return search.fits();
}

}  // namespace myo::diagnosis
