#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "loop/candidate_fits.hpp"
#include "loop/candidate_scores.hpp"
#include "loop/confusion.hpp"
#include "loop/diagnosis.hpp"
#include "loop/effect_words.hpp"
#include "loop/error_finder.hpp"
#include "loop/fit_store.hpp"
#include "loop/judge.hpp"
#include "loop/unbent_values.hpp"
#include "loop/verdict.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The step is doubled for all that follows when that changes the predictions by less, in units of the noise.
constexpr double step_doubt = 1.0;
/// Of forces, to which stages are solved: motions are then exact to a hundredth of usual noises.
constexpr double solver_tolerance = 1e-6;
/// Of the linear systems of derivatives: a fit needs the direction, not all digits.
constexpr double tangent_tolerance = 1e-4;
/// Where a candidate explains so much from the fit with what is bent put back, that is the place to start from.
constexpr double sure_base = 0.8;
/// Runs start their stages near those of others, where these can be kept.
constexpr double most_path_bytes = 1e8;
/// How far fits with all trials side by side go: the declared one, with the numerical error taken off, the best where
/// nothing explains the residual, the one the verdict stands on, and the best attempt where it is unknown.
constexpr Effort declared_effort{30}, again_effort{12}, polish_effort{20, 3e-4}, last_effort{20}, attempt_effort{4, 1e-3};
/// The numerical error is found anew where taking it off moves the predictions by more, in units of the noise and as a share of what is left, and
/// at most so often.
constexpr double declared_settled = 1.0, effect_settled = 3.0, settled_share = 0.3;
constexpr int most_rounds = 3;
/// It is not taken over where the fit then leaves so many times the squares.
constexpr double gone_astray = 1.2;
/// For so many candidates before the verdict.
constexpr std::size_t settled_candidates = 2;
/// Those that leave at most so many times the squares of the best compete with it.
constexpr double close_rival = 1.5;
/// Where nothing explains the residual so many fits go on so far.
constexpr std::size_t polished_candidates = 3;
/// A run that takes so many times the iterations of the declared fit's is given up: its numbers are absurd.
constexpr int absurd_run = 4;
/// Of a first round of fits those go on that leave at most so many times the squares of the best; of pairs fewer, as one of the two is at its best.
constexpr double hopeful = 4.0, hopeful_pair = 1.5;
/// Two effects are tried where the better one leaves at most this share of what noise does not make.
constexpr double worth_a_second = 0.6;
/// Once the best candidate has been found to explain all, no probe that takes away less than the first share of what the best does is worth a fit; once
/// it leaves at most so much of the squares, and systematic ones like noise, less than the second.
constexpr double worth_beside_all = 0.4, worth_beside_most = 0.25, most_of_all = 0.5, like_noise = 1.0;
/// A fit that leaves less than this share of what noise does not make of the declared one's squares is nearer to the truth than that.
constexpr double far_better = 0.3;
/// A candidate whose fit leaves more than this share of the squares has perhaps not found its way.
constexpr double little_better = 0.9;
/// So many candidates are fitted before anything is concluded.
constexpr std::size_t first_fits = 3;

std::string study_words(const Study& study) {
    return study.experiment.name + ", " + to_string(study.mesh.element) + " " + std::to_string(study.mesh.mesh.node_count()) + " nodes, h " +
           std::to_string(study.trials.front().options.h_s) + " s, " + to_string(study.settings.integrator);
}

/// A diagnosis on its way.
class Work {
public:
    Work(const Study& study, const DiagnoseSettings& settings, const Progress& progress, const std::function<void(const Diagnosis&)>& live)
        : study_(study), serial_(study_), progress_(progress), live_(live), errors_(study_, settings.refine_mesh) {
        for (StudyTrial& trial : study_.trials) {
            trial.options.solver.tolerance = std::max(solver_tolerance, trial.options.solver.tolerance);
            trial.options.solver.tangent_tolerance = std::max(tangent_tolerance, trial.options.solver.tangent_tolerance);
            const double stages = 2.0 * trial.options.end_s / trial.options.h_s;
            trial.options.keep_path = 8.0 * stages * study_.body->dofs() < most_path_bytes;
        }
        serial_ = study_;
        serial_.settings.threads = 1;
        result_.settings = settings;
        if (settings.fits) store_ = std::make_unique<FitStore>(*settings.fits, study_words(study));
        else store_ = std::make_unique<FitStore>();
    }

    Diagnosis take() {
        const Stopwatch watch;
        if (declared_fit() && numbers() && tests()) {
            if (needs_explanation(result_.declared, result_.data, result_.numerics)) {
                if (single_effects() && !is_faint(result_.declared, result_.data, result_.numerics)) second_effects();
            }
            if (!progress_.cancelled()) conclude();
        }
        result_.stopped = progress_.cancelled();
        result_.seconds = watch.seconds();
        forget_paths(result_.declared.fit.predictions);
        forget_paths(result_.augmented.fit.predictions);
        return std::move(result_);
    }

private:
    bool allowed(const std::string& id) const {
        const std::vector<std::string>& without = result_.settings.without;
        return std::find(without.begin(), without.end(), id) == without.end();
    }

    void show() const {
        if (live_) live_(result_);
    }

    StageCost& cost_of(const std::string& name) {
        const auto same = std::find_if(result_.cost.begin(), result_.cost.end(), [&](const StageCost& cost) { return cost.stage == name; });
        return same != result_.cost.end() ? *same : result_.cost.emplace_back(StageCost{name, 0.0, 0});
    }

    /// A stage whose time goes into the table.
    template <class Task>
    auto stage(const std::string& name, int runs, const Task& task) {
        const Stopwatch watch;
        progress_.report({name, 0.0, 1.0, "stage", {}});
        auto value = task();
        StageCost& cost = cost_of(name);
        cost.seconds += watch.seconds();
        cost.runs += runs;
        show();
        return value;
    }

    int fit_count() const { return static_cast<int>(result_.data.trials.size()); }

    JointFit fit(const Study& study, const StudyValues& start, EffectFreedom freedom, const Effort& effort, const Neighbourhood& known, const Progress& progress) {
        return stored_fit(*store_, study, result_.data, start, freedom, effort, known, progress);
    }

    bool declared_fit() {
        result_.data = fit_data(study_, trials_with_role(study_, TrialRole::fit));
        result_.noise_m = std::sqrt(result_.data.noise_m.squaredNorm() / static_cast<double>(std::max<Index>(1, result_.data.noise_m.size())));
        if (result_.data.layout.size() == 0) {
            result_.failure = "no sample of a fit trial can be compared";
            return false;
        }
        stage("step", 2 * fit_count(), [&] { return lengthen_step(); });
        if (progress_.cancelled()) return false;
        JointFit declared = stage("declared fit", 0, [&] { return fit(study_, declared_values(study_), EffectFreedom::all, declared_effort, {}, progress_); });
        if (progress_.cancelled()) return false;
        if (!declared.usable()) {
            result_.failure = "the declared model cannot be run: " + declared.report.message;
            return false;
        }
        cost_of("declared fit").runs += declared.runs(fit_count());
        for (std::size_t i = 0; i < result_.data.trials.size(); ++i) {
            const std::size_t t = result_.data.trials[i];
            study_.trials[t].options.most_iterations = serial_.trials[t].options.most_iterations = absurd_run * declared.predictions[i].trace.newton_iterations;
        }
        result_.declared = judged(result_.data, std::move(declared), result_.settings);
        return true;
    }

    /// Doubles the step where that is no matter: its error is taken off anyway.
    bool lengthen_step() {
        if (study_.settings.h_s) return false;
        const StudyValues values = declared_values(study_);
        Study longer = study_;
        for (StudyTrial& trial : longer.trials) trial.options.h_s *= 2.0;
        const std::vector<std::size_t>& trials = result_.data.trials;
        const std::vector<TrialPrediction> fine = predict_trials_with(study_, values, trials, progress_), coarse = predict_trials_with(longer, values, trials, progress_);
        if (!all_ok(fine) || !all_ok(coarse)) return false;
        const VectorXd change = flat_residual(result_.data, coarse) - flat_residual(result_.data, fine);
        if (change.norm() > step_doubt * std::sqrt(static_cast<double>(change.size()))) return false;
        study_ = std::move(longer);
        result_.step_factor = 2.0;
        for (std::size_t t = 0; t < study_.trials.size(); ++t) serial_.trials[t].options.h_s = study_.trials[t].options.h_s;
        result_.notes.push_back("steps of " + format_number(1e3 * study_.trials.front().options.h_s, 4) + " ms, whose error is taken off");
        return true;
    }

    std::vector<std::size_t> all_trials() const {
        std::vector<std::size_t> all(study_.trials.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    }

    bool numbers() {
        if (!settle(result_.declared, "declared fit", again_effort, declared_settled)) return false;
        if (!result_.declared.numerics) result_.declared.numerics.emplace();
        result_.numerics = *result_.declared.numerics;
        return true;
    }

    /// The numerical error at a fit, and the fit with it taken off; again while that takes the fit elsewhere: an error of another motion is another
    /// error.
    bool settle(JudgedFit& judged_fit, const std::string& name, const Effort& effort, double settled_change) {
        for (int round = 0; round < most_rounds; ++round) {
            const NumericalError* const known = judged_fit.numerics ? &*judged_fit.numerics : nullptr;   // the declared fit may be damped far more
            NumericalError numerics = stage("numerical error", 3 * fit_count(), [&] { return errors_.at(judged_fit.fit.values, result_.data.trials, known, progress_); });
            if (progress_.cancelled()) return false;
            const bool is_first = !result_.declared.numerics;   // until then no error was taken off
            if (is_first) match_stiffness(judged_fit.fit, numerics);
            result_.data.shift = numerics.shift;
            JointFit again = stage(name, 0, [&] { return fit(study_, judged_fit.fit.values, EffectFreedom::all, effort, neighbourhood_of(judged_fit.fit), progress_); });
            if (progress_.cancelled()) return false;
            cost_of(name).runs += again.runs(fit_count());
            if (!again.usable() || (!is_first && again.squares() > gone_astray * judged_fit.fit.squares())) break;
            const double left = std::sqrt(again.squares() / static_cast<double>(again.residual.size()));
            const bool settled = change_between(judged_fit.fit, again) < std::max(settled_change, settled_share * left);
            const double weight = judged_fit.weight, criterion = judged_fit.criterion;
            judged_fit = judged(result_.data, std::move(again), result_.settings);
            judged_fit.weight = weight;
            judged_fit.criterion = criterion;
            numerics.left_rms_m = extrapolation_left_m(result_.data, numerics, judged_fit.fit);
            judged_fit.numerics = std::move(numerics);
            if (settled) break;
        }
        if (!judged_fit.numerics) judged_fit.numerics = result_.declared.numerics;
        result_.data.shift = judged_fit.numerics ? judged_fit.numerics->shift : PredictionShift{};
        return true;
    }

    /// Gives the cells the modulus with which they move like finer ones, and a fit one with which they move as before.
    void match_stiffness(JointFit& declared, NumericalError& numerics) {
        if (!stage("numerical error", 3 * fit_count(), [&] { return errors_.match(declared.values, result_.data, numerics, progress_); })) return;
        result_.modulus_factor = study_.modulus_factor = serial_.modulus_factor = numerics.stiffening.factor();
        for (const StudyParameter& p : declared.parameters)
            if (p.kind == StudyParameter::Kind::youngs_modulus)
                set_value(p, std::clamp(declared.values.youngs_modulus_Pa / study_.modulus_factor, p.parameter.lower, p.parameter.upper), declared.values);
    }

    /// The numerical error of the trials that a fit did not see.
    void foretell_error(JudgedFit& judged_fit) {
        if (!judged_fit.numerics || judged_fit.numerics->shift.size() != study_.trials.size()) return;
        std::vector<std::size_t> others;
        for (const std::size_t t : all_trials())
            if (judged_fit.numerics->shift[t].empty()) others.push_back(t);
        if (others.empty() || progress_.cancelled()) return;
        complete(*judged_fit.numerics, stage("numerical error", 3 * static_cast<int>(others.size()), [&] { return errors_.at(judged_fit.fit.values, others, nullptr, progress_); }));
    }

    bool tests() {
        progress_.report({"significance", 1.0, 1.0, "stage", {}});
        show();
        return !progress_.cancelled();
    }

    std::vector<JudgedFit> fits_from(const std::string& name, const JointFit& base, const std::vector<CandidateStart>& starts, double hope) {
        CandidateFits found = stage(name, 0, [&] {
            return fit_candidates({study_, serial_, result_.data, result_.settings, *store_}, base, starts, least_left(), hope, name, progress_);
        });
        cost_of(name).runs += found.runs;
        return std::move(found.fits);
    }

    /// The declared fit with what it has bent put back, where there is any.
    std::optional<JointFit> unbent() {
        const std::optional<StudyValues> values = unbent_values(result_.declared.fit, declared_values(study_));
        if (!values) return std::nullopt;
        JointFit fit_there = fit(study_, *values, EffectFreedom::all, {1}, {}, progress_);
        return fit_there.usable() ? std::optional(std::move(fit_there)) : std::nullopt;
    }

    /// Where candidates are scored and their fits start.
    const JointFit& base() const { return unbent_ ? *unbent_ : result_.declared.fit; }

    bool single_effects() {
        const EffectFilter may_be_named = [this](const std::string& id) { return allowed(id); };
        std::vector<EffectScore> scores = stage("score", 2 * fit_count(), [&] {
            unbent_ = unbent();
            return score_coarsely(study_, result_.data, base(), may_be_named, ProbeSize::small, progress_);
        });
        // What was bent may also be right, or no better elsewhere: then from where the declared fit ended.
        if (!progress_.cancelled() && unbent_ && best_score(scores).test.explained < sure_base) {
            std::vector<EffectScore> others = stage("score", fit_count(), [&] { return score_coarsely(study_, result_.data, result_.declared.fit, may_be_named, ProbeSize::small, progress_); });
            if (best_score(others).left < best_score(scores).left) {
                scores = std::move(others);
                unbent_.reset();
            }
        }
        if (progress_.cancelled()) return false;
        std::vector<double> p;
        for (const EffectScore& score : scores) p.push_back(score.usable() ? score.test.p : 1.0);
        const std::vector<double> adjusted = holm_adjusted(p);
        const std::vector<std::size_t> chosen = worth_fitting(scores, result_.settings.refits);
        std::map<std::string, std::size_t> best_probe;
        for (std::size_t i = 0; i < scores.size(); ++i) {
            const auto [place, first] = best_probe.emplace(scores[i].id, i);
            if (!first && scores[i].share() > scores[place->second].share()) place->second = i;
        }
        for (const auto& [id, i] : best_probe) result_.candidates.push_back({scores[i], adjusted[i], {}, {}});
        order_candidates(result_);
        show();
        std::vector<CandidateStart> starts;
        for (const std::size_t i : chosen) starts.push_back(start_of(scores[i]));
        if (!refit(starts, 0, std::min(first_fits, starts.size())) || !settle_the_best() || !polish()) return false;
        std::size_t last = starts.size();
        const JudgedFit* const best = !result_.candidates.empty() && result_.candidates.front().judged ? &*result_.candidates.front().judged : nullptr;
        const bool surely = explained(Leniency::strict);
        if (best && (surely || (best->fit.squares() < most_of_all * result_.declared.fit.squares() && best->tests.systematic.rms < like_noise))) {
            const double worth = (surely ? worth_beside_all : worth_beside_most) * scores[chosen[0]].test.explained;
            last = std::min(first_fits, last);
            while (last < starts.size() && scores[chosen[last]].test.explained > worth) ++last;
        }
        starts.resize(last);
        const bool faint = is_faint(result_.declared, result_.data, result_.numerics);   // what hardly shows is not worth a long search
        if (!surely && !faint) {
            const std::vector<CandidateStart> winding = winding_starts(scores, [this](const EffectScore& score) { return left_by(score.id) >= little_better * base().squares(); });
            starts.insert(starts.end(), winding.begin(), winding.end());
        }
        if (!refit(starts, std::min(first_fits, last), starts.size())) return false;
        if (!explained(Leniency::strict) && !faint && !refit_elsewhere(scores)) return false;
        if (!explained() && !faint && (!settle_the_best() || !polish())) return false;
        if (!explained() && !faint && !large_effects()) return false;
        if (!settle_rivals()) return false;
        find_confusions(result_);
        show();
        return true;
    }

    /// Effects that go with the square of their amount, so that small probes do not show what they would explain.
    bool large_effects() {
        const std::vector<EffectScore> scores = stage("score", fit_count(), [&] {
            return score_coarsely(study_, result_.data, base(), [this](const std::string& id) { return allowed(id); }, ProbeSize::large, progress_);
        });
        if (progress_.cancelled()) return false;
        std::vector<CandidateStart> starts;
        for (const std::size_t i : worth_fitting(scores, result_.settings.refits))
            for (Candidate& candidate : result_.candidates)
                if (candidate.score.id == scores[i].id && scores[i].share() > candidate.score.share()) {
                    candidate.score = scores[i];
                    starts.push_back(start_of(scores[i]));
                }
        return starts.empty() || (refit(starts, 0, starts.size()) && settle_the_best() && polish());
    }

    /// What a candidate's fit leaves; infinite where it was not fitted.
    double left_by(const std::string& id) const {
        for (const Candidate& candidate : result_.candidates)
            if (candidate.score.id == id && candidate.judged) return candidate.judged->fit.squares();
        return std::numeric_limits<double>::infinity();
    }

    double least_left() const {
        double least = std::numeric_limits<double>::infinity();
        for (const Candidate& candidate : result_.candidates) least = std::min(least, left_by(candidate.score.id));
        return least;
    }

    bool explained(Leniency leniency = Leniency::generous) const {
        const std::vector<Candidate>& ranked = result_.candidates;
        return !ranked.empty() && ranked.front().judged && explains(*ranked.front().judged, result_.declared, result_.data, result_.numerics, leniency);
    }

    /// Where nothing explains the residual: the best ones that had to do with secants, or with few evaluations, go on with derivatives of their own.
    bool polish() {
        const std::size_t count = explained() ? 0 : std::min(polished_candidates, result_.candidates.size());
        for (std::size_t i = 0; i < count; ++i) {
            std::optional<JudgedFit>& found = result_.candidates[i].judged;
            if (!found || found->numerics || (found->fit.report.jacobians > 1 && found->fit.report.converged())) continue;
            JointFit again = stage("refit", 0, [&] { return fit(study_, found->fit.values, EffectFreedom::all, polish_effort, {}, progress_); });
            if (progress_.cancelled()) return false;
            cost_of("refit").runs += again.runs(fit_count());
            if (again.usable() && again.squares() < found->fit.squares()) found = judged(result_.data, std::move(again), result_.settings);
            else found->fit.report.jacobians += again.report.jacobians;   // as many were spent on it
        }
        return count == 0 || settle_the_best();
    }

    /// The numerical error was found with the declared fit, whose motion may be far off: where the best candidates explain most but not all, it is
    /// found anew with them.
    bool settle_the_best() {
        const std::size_t count = std::min(settled_candidates, result_.candidates.size());
        for (std::size_t i = 0; i < count; ++i) {
            std::optional<JudgedFit>& best = result_.candidates[i].judged;
            if (!best || best->numerics || best->fit.excess() > far_better * result_.declared.fit.excess()) continue;
            if (explains(*best, result_.declared, result_.data, result_.numerics)) break;
            if (!settle(*best, "last fit", last_effort, effect_settled)) return false;
            result_.data.shift = result_.numerics.shift;
        }
        order_candidates(result_);
        return true;
    }

    /// Where the numerical error was found anew with the best candidate, also with those that leave hardly more: they are compared on equal terms.
    bool settle_rivals() {
        if (result_.candidates.empty() || !result_.candidates.front().judged || !result_.candidates.front().judged->numerics) return true;
        const double best = result_.candidates.front().judged->fit.squares();
        for (std::size_t i = 1; i < std::min(settled_candidates + 1, result_.candidates.size()); ++i) {
            std::optional<JudgedFit>& rival = result_.candidates[i].judged;
            if (!rival || rival->numerics || rival->fit.squares() > close_rival * best) continue;
            if (!settle(*rival, "last fit", last_effort, effect_settled)) return false;
            result_.data.shift = result_.numerics.shift;
        }
        order_candidates(result_);
        return true;
    }

    /// Fits the candidates first ... last of the starts.
    bool refit(const std::vector<CandidateStart>& starts, std::size_t first, std::size_t last) {
        if (first >= last) return true;
        const std::vector<CandidateStart> part(starts.begin() + static_cast<std::ptrdiff_t>(first), starts.begin() + static_cast<std::ptrdiff_t>(last));
        std::vector<JudgedFit> fits = fits_from("refit", base(), part, hopeful);
        if (progress_.cancelled()) return false;
        for (std::size_t i = 0; i < fits.size(); ++i)
            for (Candidate& candidate : result_.candidates)
                if (candidate.score.id == part[i].effect.id && fits[i].usable() && !(candidate.judged && candidate.judged->fit.squares() < fits[i].fit.squares()))
                    candidate.judged = std::move(fits[i]);
        order_candidates(result_);
        return true;
    }

    /// Effects of a place or an axis that come close to the best, from other places and axes.
    bool refit_elsewhere(const std::vector<EffectScore>& scores) {
        const auto hopeful_fit = [&](const std::string& id) { return left_by(id) <= hopeful * least_left(); };
        std::vector<CandidateStart> starts;
        for (const std::size_t i : other_places(scores, hopeful_fit)) starts.push_back(start_of(scores[i]));
        return refit(starts, 0, starts.size());
    }

    /// Where one effect leaves something, a second beside the best one, and the first is asked whether it is still needed.
    void second_effects() {
        if (result_.candidates.empty() || !result_.candidates.front().judged) return;
        const JudgedFit& first = *result_.candidates.front().judged;
        if (explains(first, result_.declared, result_.data, result_.numerics) || first.fit.excess() > worth_a_second * result_.declared.fit.excess()) return;
        JointFit base = first.fit;
        if (first.numerics) result_.data.shift = first.numerics->shift;
        base.predictions = predict_trials_with(study_, base.values, result_.data.trials, progress_);
        if (progress_.cancelled()) return;
        const std::string first_id = result_.candidates.front().score.id;
        const std::vector<EffectScore> scores = stage("score of pairs", 0, [&] {
            return score_coarsely(study_, result_.data, base, [&](const std::string& id) { return id != first_id && allowed(id); }, ProbeSize::small, progress_);
        });
        if (progress_.cancelled()) return;
        std::vector<CandidateStart> starts;
        for (const std::size_t i : worth_fitting(scores, result_.settings.pairs)) starts.push_back(start_of(scores[i]));
        std::vector<JudgedFit> fits = fits_from("refit of pairs", base, starts, hopeful_pair);
        if (progress_.cancelled()) return;
        for (JudgedFit& fit : fits)
            if (fit.usable()) result_.pairs.push_back(std::move(fit));
        order_pairs(result_);
        if (!result_.pairs.empty())
            for (const std::size_t kept : {1u, 0u}) try_alone(result_.pairs.front(), kept);
        order_pairs(result_);
        show();
    }

    /// One effect of a pair without the other: it may have needed that to find its way only.
    void try_alone(const JudgedFit& pair, std::size_t kept) {
        if (progress_.cancelled() || explained()) return;
        StudyValues values = pair.fit.values;
        values.effects.erase(values.effects.begin() + static_cast<std::ptrdiff_t>(study_.experiment.effects.size() + 1 - kept));
        JointFit alone = stage("refit of pairs", 0, [&] { return fit(study_, values, EffectFreedom::all, polish_effort, {}, progress_); });
        if (progress_.cancelled() || !alone.usable()) return;
        cost_of("refit of pairs").runs += alone.runs(fit_count());
        const std::string id = pair.fit.effects[kept].id;
        for (Candidate& candidate : result_.candidates)
            if (candidate.score.id == id && alone.squares() < left_by(id)) {
                candidate.judged = judged(result_.data, std::move(alone), result_.settings);
                break;
            }
        order_candidates(result_);
    }

    /// The verdict, the fit it stands on with the numerical error taken anew, and all trials before and after.
    void conclude() {
        foretell_error(result_.declared);
        result_.numerics = *result_.declared.numerics;
        result_.augmented = decide(result_);
        const std::vector<std::size_t> all = all_trials();
        const std::vector<TrialPrediction> before = stage("prediction", 2 * static_cast<int>(all.size()), [&] { return fitted_predictions(study_, all, result_.declared.fit.values, progress_); });
        const auto scored = [&](const StudyValues& fitted, const PredictionShift& shift, std::vector<TrialPrediction> predictions) {
            for (std::size_t t = 0; t < predictions.size(); ++t) predictions[t] = shifted(std::move(predictions[t]), shift, t);
            return scored_run(study_, with_predicted_levels(study_, fitted), std::move(predictions), all);
        };
        result_.before = scored(result_.declared.fit.values, result_.numerics.shift, before);
        const Effort& effort = result_.verdict.kind == VerdictKind::effects ? last_effort : attempt_effort;
        if (!result_.augmented.numerics && !settle(result_.augmented, "last fit", effort, effect_settled)) return;
        foretell_error(result_.augmented);
        result_.data.shift = result_.augmented.numerics->shift;
        if (result_.verdict.kind == VerdictKind::effects) result_.verdict.effects = result_.augmented.fit.effects;
        result_.after = result_.verdict.kind == VerdictKind::none
                            ? result_.before
                            : scored(result_.augmented.fit.values, result_.augmented.numerics->shift, fitted_predictions(study_, all, result_.augmented.fit.values, progress_));
        note_worse_predictions(result_);
    }

    Study study_;
    Study serial_;                       // its fits run on one thread each, side by side
    const Progress& progress_;
    const std::function<void(const Diagnosis&)>& live_;
    std::unique_ptr<FitStore> store_;
    ErrorFinder errors_;
    std::optional<JointFit> unbent_;                // the declared fit with what it has bent put back
    Diagnosis result_;
};

}  // namespace

Study as_diagnosed(const Diagnosis& diagnosis, Study study) {
    for (StudyTrial& trial : study.trials) trial.options.h_s *= diagnosis.step_factor;
    study.modulus_factor = diagnosis.modulus_factor;
    return study;
}

Diagnosis diagnose(const Study& study, const DiagnoseSettings& settings, const Progress& progress, const std::function<void(const Diagnosis&)>& live) {
    return Work(study, settings, progress, live).take();
}

}  // namespace myo
