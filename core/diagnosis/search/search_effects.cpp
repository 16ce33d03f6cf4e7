#include "diagnosis/search/search_effects.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/screening/confusion.hpp"
#include "diagnosis/screening/debiased_start.hpp"
#include "diagnosis/selection/judgement.hpp"

namespace myo::diagnosis {
namespace {

/// State of the search: the fit from which candidates are scored and fitted.
struct Search {
    DiagnosisWork& work;
    std::optional<JointFit> debiased;  // declared fit with its distorted parameters reset; empty: not used

    const JointFit& base() const { return debiased ? *debiased : work.result.declared.fit; }
};

/// Declared fit with its distorted parameters reset; empty if none is distorted, or if the fit is not usable.
std::optional<JointFit> debiased_fit(DiagnosisWork& work) {
    const std::optional<prediction::ParameterValues> values = debiased_start(work.result.declared.fit,
                                                                             prediction::declared_values(work.setup));
    if (!values) return std::nullopt;
    JointFit fit_there = stored_fit(*work.store, work.setup, work.result.data, *values, EffectFreedom::all, {1}, {},
                                    work.progress);
    return fit_there.usable() ? std::optional(std::move(fit_there)) : std::nullopt;
}

std::vector<EffectScore> scored_from(DiagnosisWork& work, const JointFit& base, ProbeSize size) {
    return score_with_longer_steps(
        work.setup, work.result.data, base, [&work](const std::string& id) { return work.allowed(id); }, size,
        work.progress);
}

/// Scores from the reset declared fit, or from the declared fit itself if its best effect leaves less; sets the base.
std::vector<EffectScore> first_scores(Search& search) {
    DiagnosisWork& work = search.work;
    std::vector<EffectScore> scores = work.stage("score", 2 * work.fit_count(), [&] {
        search.debiased = debiased_fit(work);
        return scored_from(work, search.base(), ProbeSize::small);
    });
    if (work.progress.cancelled() || !search.debiased ||
        best_score(scores).test.explained >= diagnosis_policy.search.sure_base)
        return scores;
    // The distorted values may be right, or the reset values no better: also score from the declared fit.
    std::vector<EffectScore> others = work.stage(
        "score", work.fit_count(), [&] { return scored_from(work, work.result.declared.fit, ProbeSize::small); });
    if (best_score(others).left >= best_score(scores).left) return scores;
    search.debiased.reset();
    return others;
}

/// Lists each effect once, with its best probe. P-values are Holm-adjusted over all probes.
void list_candidates(Diagnosis& result, const std::vector<EffectScore>& scores) {
    std::vector<double> p;
    for (const EffectScore& score : scores) p.push_back(score.usable() ? score.test.p : 1.0);
    const std::vector<double> adjusted = statistics::holm_adjusted(p);
    std::map<std::string, std::size_t> best_probe;
    for (std::size_t i = 0; i < scores.size(); ++i) {
        const auto [place, first] = best_probe.emplace(scores[i].id, i);
        if (!first && scores[i].share() > scores[place->second].share()) place->second = i;
    }
    for (const auto& [id, i] : best_probe) result.candidates.push_back({scores[i], adjusted[i], {}, {}});
    order_candidates(result);
}

/// Fits the candidates of the starts [first, last). Returns false if cancelled.
bool refit(Search& search, const std::vector<CandidateStart>& starts, std::size_t first, std::size_t last) {
    if (first >= last) return true;
    Diagnosis& result = search.work.result;
    const std::vector<CandidateStart> part(starts.begin() + static_cast<std::ptrdiff_t>(first),
                                           starts.begin() + static_cast<std::ptrdiff_t>(last));
    std::vector<JudgedFit> fits = search.work.fit_all("refit", search.base(), part, least_left(result),
                                                      diagnosis_policy.search.pruning_factor);
    if (search.work.progress.cancelled()) return false;
    for (std::size_t i = 0; i < fits.size(); ++i)
        for (Candidate& candidate : result.candidates)
            if (candidate.score.id == part[i].effect.id && fits[i].usable() &&
                !(candidate.judged && candidate.judged->fit.squares() < fits[i].fit.squares()))
                candidate.judged = std::move(fits[i]);
    order_candidates(result);
    return true;
}

/// correct_discretisation() of one candidate; the others keep the shift of the declared fit. Returns false if
/// cancelled.
bool correct_candidate(DiagnosisWork& work, JudgedFit& candidate) {
    const bool corrected = correct_discretisation(work, candidate, "last fit", diagnosis_policy.search.correction);
    work.result.data.shift = work.result.numerics.shift;
    return corrected;
}

/// Recomputes the numerical error at the best candidates if they explain most but not all of the residual: it was
/// computed at the declared fit, whose motion may be far off. Returns false if cancelled.
bool correct_best(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    const std::size_t count = std::min(diagnosis_policy.search.corrected_candidates, result.candidates.size());
    for (std::size_t i = 0; i < count; ++i) {
        std::optional<JudgedFit>& best = result.candidates[i].judged;
        if (!best || best->numerics ||
            best->fit.excess() > diagnosis_policy.search.much_better * result.declared.fit.excess())
            continue;
        if (explains(*best, result.declared, result.data, result.numerics, result.settings.policy.judgement)) break;
        if (!correct_candidate(work, *best)) return false;
    }
    order_candidates(result);
    return true;
}

/// Continues a fit that used secants or few evaluations, with new derivatives. Returns false if cancelled.
bool polish(DiagnosisWork& work, JudgedFit& found) {
    if (found.numerics || (found.fit.report.jacobians > 1 && found.fit.report.converged())) return true;
    JointFit again = work.fit("refit", found.fit.values, diagnosis_policy.search.polish);
    if (work.progress.cancelled()) return false;
    if (again.usable() && again.squares() < found.fit.squares())
        found = judged(work.result.data, std::move(again), work.result.settings);
    else
        found.fit.report.jacobians += again.report.jacobians;  // derivatives spent on this fit
    return true;
}

/// Compares rivals of the best fit on equal terms, each with the numerical error of its own motion: that of the
/// declared fit suits some motions better than others (a delayed signal bends between steps, drag and damping act at
/// other speeds). Returns false if cancelled.
bool correct_rivals(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    const double best = least_left(result);
    const auto competes = [&](const Candidate& candidate) {
        return candidate.judged && candidate.judged->fit.squares() <= diagnosis_policy.search.rival_factor * best;
    };
    for (std::size_t i = 0; i < std::min(diagnosis_policy.search.polished_rivals, result.candidates.size()); ++i)
        if (competes(result.candidates[i]) && !polish(work, *result.candidates[i].judged)) return false;
    order_candidates(result);
    const std::size_t count = std::min(diagnosis_policy.search.corrected_candidates + 1, result.candidates.size());
    const std::ptrdiff_t rivals = std::count_if(
        result.candidates.begin(), result.candidates.begin() + static_cast<std::ptrdiff_t>(count), competes);
    if (rivals < 2) return true;
    for (std::size_t i = 0; i < count; ++i) {
        Candidate& candidate = result.candidates[i];
        if (!competes(candidate) || candidate.judged->numerics) continue;
        if (!correct_candidate(work, *candidate.judged)) return false;
    }
    order_candidates(result);
    return true;
}

/// Continues the best fits if none explains the residual. Returns false if cancelled.
bool polish_the_best(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    const std::size_t count = explained(result)
                                  ? 0
                                  : std::min(diagnosis_policy.search.polished_candidates, result.candidates.size());
    for (std::size_t i = 0; i < count; ++i) {
        std::optional<JudgedFit>& found = result.candidates[i].judged;
        if (found && !polish(work, *found)) return false;
    }
    return count == 0 || correct_best(work);
}

/// Number of starts, counted from the first, that are fitted in the first two rounds.
std::size_t worth_going_on(const Diagnosis& result, const std::vector<CandidateStart>& starts, bool surely) {
    const JudgedFit* const best = !result.candidates.empty() && result.candidates.front().judged
                                      ? &*result.candidates.front().judged
                                      : nullptr;
    const bool mostly = best &&
                        best->fit.squares() < diagnosis_policy.search.most_left * result.declared.fit.squares() &&
                        best->tests.systematic.rms < diagnosis_policy.search.noise_like;
    if (!surely && !mostly) return starts.size();
    const double worth = diagnosis_policy.search.least_reduction_beside * starts.front().predicted_reduction;
    std::size_t last = std::min(diagnosis_policy.search.first_fits, starts.size());
    while (last < starts.size() && starts[last].predicted_reduction > worth) ++last;
    return last;
}

/// Refits effects with a place or an axis that come close to the best, from other places and axes.
bool refit_elsewhere(Search& search, const std::vector<EffectScore>& scores) {
    const Diagnosis& result = search.work.result;
    std::vector<CandidateStart> starts;
    for (const std::size_t i : other_places(scores, [&](const std::string& id) {
             return left_by(result, id) <= diagnosis_policy.search.pruning_factor * least_left(result);
         }))
        starts.push_back(start_of(scores[i]));
    return refit(search, starts, 0, starts.size());
}

/// Scores and fits large probes: small ones underestimate effects whose response is quadratic in their amount.
bool refit_by_large_probes(Search& search) {
    DiagnosisWork& work = search.work;
    const std::vector<EffectScore> scores = work.stage(
        "score", work.fit_count(), [&] { return scored_from(work, search.base(), ProbeSize::large); });
    if (work.progress.cancelled()) return false;
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(scores, work.result.settings.refits))
        for (Candidate& candidate : work.result.candidates)
            if (candidate.score.id == scores[i].id && scores[i].share() > candidate.score.share()) {
                candidate.score = scores[i];
                starts.push_back(start_of(scores[i]));
            }
    return starts.empty() || (refit(search, starts, 0, starts.size()) && correct_best(work) && polish_the_best(work));
}

}  // namespace

bool search_effects(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    Search search{work, {}};
    const std::vector<EffectScore> scores = first_scores(search);
    if (work.progress.cancelled()) return false;
    list_candidates(result, scores);
    work.show();
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(scores, result.settings.refits)) starts.push_back(start_of(scores[i]));
    if (!refit(search, starts, 0, std::min(diagnosis_policy.search.first_fits, starts.size())) || !correct_best(work) ||
        !polish_the_best(work))
        return false;
    const bool surely = explained(result, Leniency::strict);
    const bool faint = is_faint(result.declared, result.data, result.numerics,
                                result.settings.policy.judgement);  // a faint residual does not justify a long search
    const std::size_t last = worth_going_on(result, starts, surely);
    starts.resize(last);
    if (!surely && !faint) {
        const auto lost = [&](const EffectScore& score) {
            return left_by(result, score.id) >= diagnosis_policy.search.hardly_better * search.base().squares();
        };
        const std::vector<CandidateStart> nonlinear = nonlinear_starts(scores, lost);
        starts.insert(starts.end(), nonlinear.begin(), nonlinear.end());
    }
    if (!refit(search, starts, std::min(diagnosis_policy.search.first_fits, last), starts.size())) return false;
    if (!explained(result, Leniency::strict) && !faint && !refit_elsewhere(search, scores)) return false;
    if (!explained(result) && !faint && (!correct_best(work) || !polish_the_best(work))) return false;
    if (!explained(result) && !faint && !refit_by_large_probes(search)) return false;
    if (!correct_rivals(work)) return false;
    find_confusions(result);
    work.show();
    return true;
}

}  // namespace myo::diagnosis
