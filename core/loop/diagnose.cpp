#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "loop/candidate_scores.hpp"
#include "loop/confusion.hpp"
#include "loop/diagnosis.hpp"
#include "loop/effect_words.hpp"
#include "loop/fit_store.hpp"
#include "loop/judge.hpp"
#include "loop/verdict.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The numerical error is taken off predictions by a mesh of so many unknowns, within these ratios of the edge.
constexpr double fine_unknowns = 8000.0, finest_ratio = 0.5, coarsest_ratio = 0.75;
/// The step is doubled for all that follows when that changes the predictions by less, in units of the noise.
constexpr double step_doubt = 1.0;
/// Of forces, to which stages are solved: motions are then exact to a hundredth of usual noises.
constexpr double solver_tolerance = 1e-6;
/// Damping that many times the expected one stands in for something else. Where a candidate explains so much from the expected one, it does.
constexpr double far_damping = 3.0, sure_base = 0.8;
/// Runs start their stages near those of others, where these can be kept.
constexpr double most_path_bytes = 1e8;
/// Evaluations of a candidate's amount before the best go on, and of those that do.
constexpr int first_evaluations = 4, more_evaluations = 20;
/// A run that takes so many times the iterations of the declared fit's is given up: its numbers are absurd.
constexpr int absurd_run = 4;
/// Of a first round of fits those go on that leave at most so many times the squares of the best.
constexpr double hopeful = 4.0;
/// Once the best candidate has been found to explain all, no probe that takes away less than this share of what the best does is worth a fit.
constexpr double worth_beside_best = 0.4;
/// A fit that leaves less than this share of the declared one's squares is nearer to the truth than that.
constexpr double far_better = 0.3;
/// So many candidates are fitted before anything is concluded.
constexpr std::size_t first_fits = 3;

std::string study_words(const Study& study) {
    return study.experiment.name + ", " + to_string(study.mesh.element) + " " + std::to_string(study.mesh.mesh.node_count()) + " nodes, h " +
           std::to_string(study.trials.front().options.h_s) + " s, " + to_string(study.settings.integrator);
}

/// Where a candidate's fit starts.
struct CandidateStart {
    EffectDeclaration effect;
    VectorXd step;                       // of the base's own parameters
};
CandidateStart start_of(const EffectScore& score) { return {{score.id, score.start}, score.step}; }

/// A value after a step within its bounds; what goes over decades goes by no more than a factor of e squared.
double stepped(const Parameter& p, double value, double step) {
    const double most = std::exp(2.0);
    const double lower = p.over_decades ? std::max(p.lower, (value + p.scale) / most - p.scale) : p.lower;
    const double upper = p.over_decades ? std::min(p.upper, (value + p.scale) * most - p.scale) : p.upper;
    return std::clamp(value + step, lower, upper);
}

/// A diagnosis on its way.
class Work {
public:
    Work(const Study& study, const DiagnoseSettings& settings, const Progress& progress, const std::function<void(const Diagnosis&)>& live)
        : study_(study), serial_(study_), progress_(progress), live_(live) {
        for (StudyTrial& trial : study_.trials) {
            trial.options.solver.tolerance = std::max(solver_tolerance, trial.options.solver.tolerance);
            const double stages = 2.0 * trial.options.end_s / trial.options.h_s;
            trial.options.keep_path = 8.0 * stages * study_.body->dofs() < most_path_bytes;
        }
        serial_ = study_;
        study_.settings.derivatives = serial_.settings.derivatives = Derivatives::differences;
        serial_.settings.threads = 1;
        result_.settings = settings;
        if (settings.fits) store_ = std::make_unique<FitStore>(*settings.fits, study_words(study));
        else store_ = std::make_unique<FitStore>();
    }

    Diagnosis take() {
        const Stopwatch watch;
        if (declared_fit() && numbers() && tests()) {
            if (needs_explanation(result_.declared, result_.data, result_.numerics)) {
                if (single_effects()) second_effects();
            }
            if (!progress_.cancelled()) conclude();
        }
        result_.stopped = progress_.cancelled();
        result_.seconds = watch.seconds();
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

    /// A stage whose time goes into the table.
    template <class Task>
    auto stage(const std::string& name, int runs, const Task& task) {
        const Stopwatch watch;
        progress_.report({name, 0.0, 1.0, "stage", {}});
        auto value = task();
        const auto same = std::find_if(result_.cost.begin(), result_.cost.end(), [&](const StageCost& cost) { return cost.stage == name; });
        if (same == result_.cost.end()) result_.cost.push_back({name, watch.seconds(), runs});
        else {
            same->seconds += watch.seconds();
            same->runs += runs;
        }
        show();
        return value;
    }

    int fit_count() const { return static_cast<int>(result_.data.trials.size()); }

    JointFit fit(const Study& study, const StudyValues& start, EffectFreedom freedom, int evaluations, const Neighbourhood& known, const Progress& progress) {
        LeastSquaresOptions options;
        options.max_evaluations = evaluations;
        options.relative_decrease = 1e-4;   // of a sum of thousands of squares: a quarter of a standard deviation, and the step before was larger
        options.relative_step = 1e-5;
        const std::vector<StudyParameter> parameters = joint_parameters(study, start, freedom);
        std::string key = std::to_string(evaluations) + (result_.data.shift.empty() ? "" : " shifted");
        for (const EffectDeclaration& effect : start.effects) key += " " + effect_words(effect);
        for (const StudyParameter& p : parameters) key += " " + p.parameter.name + " " + std::to_string(p.parameter.value);
        StudyValues from = start;
        if (const std::optional<VectorXd> done = store_->find(key); done && done->size() == static_cast<Index>(parameters.size())) {
            for (std::size_t i = 0; i < parameters.size(); ++i) set_value(parameters[i], (*done)(static_cast<Index>(i)), from);
            options.max_evaluations = 0;
        }
        JointFit fit = joint_fit(study, result_.data, from, freedom, options, known, progress);
        if (!fit.usable() || progress.cancelled()) return fit;
        VectorXd found(static_cast<Index>(parameters.size()));
        for (std::size_t i = 0; i < parameters.size(); ++i) found(static_cast<Index>(i)) = value_of(parameters[i], fit.values);
        static_cast<void>(store_->keep(key, found));   // what cannot be kept is done again
        return fit;
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
        JointFit declared = stage("declared fit", 0, [&] { return fit(study_, declared_values(study_), EffectFreedom::all, 30, {}, progress_); });
        if (progress_.cancelled()) return false;
        if (!declared.usable()) {
            result_.failure = "the declared model cannot be run: " + declared.report.message;
            return false;
        }
        result_.cost.back().runs = declared.runs(fit_count());
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
        std::vector<PredictionTask> tasks;
        for (const std::size_t trial : result_.data.trials) tasks.push_back({trial, &values});
        const std::vector<TrialPrediction> fine = predict_trials(study_, tasks, {}, progress_), coarse = predict_trials(longer, tasks, {}, progress_);
        for (std::size_t i = 0; i < tasks.size(); ++i)
            if (!fine[i].ok() || !coarse[i].ok()) return false;
        const VectorXd change = flat_residual(result_.data, coarse) - flat_residual(result_.data, fine);
        if (change.norm() > step_doubt * std::sqrt(static_cast<double>(change.size()))) return false;
        study_ = std::move(longer);
        result_.step_factor = 2.0;
        for (std::size_t t = 0; t < study_.trials.size(); ++t) serial_.trials[t].options.h_s = study_.trials[t].options.h_s;
        result_.notes.push_back("steps of " + format_number(1e3 * study_.trials.front().options.h_s, 4) + " ms, whose error is taken off");
        return true;
    }

    /// Predictions of all trials with the values of a fit.
    std::vector<TrialPrediction> predict_all(const StudyValues& fitted) const {
        const StudyValues values = with_predicted_levels(study_, fitted);
        std::vector<PredictionTask> tasks;
        for (std::size_t t = 0; t < study_.trials.size(); ++t) tasks.push_back({t, &values});
        return predict_trials(study_, tasks, {}, progress_);
    }

    NumericalError error_at(const StudyValues& fitted) {
        const StudyValues values = with_predicted_levels(study_, fitted);
        if (!refined_ && result_.settings.refine_mesh && !mesh_failed_) {
            const double ratio = std::clamp(std::cbrt(study_.body->dofs() / fine_unknowns), finest_ratio, coarsest_ratio);
            Result<Study> finer = refined_study(study_, ratio, progress_);
            mesh_failed_ = !finer;
            if (finer) {
                refined_ = std::make_unique<Study>(std::move(*finer));
                for (std::size_t t = 0; t < study_.trials.size(); ++t) refined_->trials[t].options.h_s = study_.trials[t].options.h_s;
            }
        }
        return numerical_error(study_, refined_.get(), values, predict_all(fitted), progress_);
    }

    bool numbers() {
        result_.numerics = stage("numerical error", 3 * static_cast<int>(study_.trials.size()), [&] { return error_at(result_.declared.fit.values); });
        if (progress_.cancelled()) return false;
        result_.data.shift = declared_shift_ = result_.numerics.shift;
        JointFit again = stage("declared fit", 2 * fit_count(), [&] { return fit(study_, result_.declared.fit.values, EffectFreedom::all, 6, neighbourhood_of(result_.declared.fit), progress_); });
        if (progress_.cancelled()) return false;
        if (again.usable()) result_.declared = judged(result_.data, std::move(again), result_.settings);
        return true;
    }

    bool tests() {
        progress_.report({"significance", 1.0, 1.0, "stage", {}});
        show();
        return !progress_.cancelled();
    }

    /// Fits of these starts beside a fit's effects: how much of each at first, then the hopeful ones with all their numbers. In the order of the
    /// starts; unusable where they failed.
    std::vector<JudgedFit> fits_from(const std::string& name, const JointFit& base, const std::vector<CandidateStart>& starts) {
        std::vector<JudgedFit> fits(starts.size());
        std::atomic<int> done{0};
        std::mutex mutex;
        const Neighbourhood of_base = neighbourhood_of(base);
        const auto round = [&](const Study& study, EffectFreedom freedom, int evaluations, const std::function<bool(std::size_t)>& wanted,
                               const std::function<StudyValues(std::size_t, double)>& from) {
            parallel_tasks(static_cast<int>(starts.size()), study_.settings.threads, [&](int task) {
                const auto i = static_cast<std::size_t>(task);
                if (progress_.cancelled() || !wanted(i)) return;
                Neighbourhood known = fits[i].usable() ? neighbourhood_of(fits[i].fit) : of_base;
                known.paths = of_base.paths;   // those of all candidates would fill the memory
                JointFit found = fit(study, from(i, 1.0), freedom, evaluations, known, progress_.with_sink({}));
                // What the probe foretells may be more than the model can run with.
                if (!found.usable() && !fits[i].usable() && !progress_.cancelled()) found = fit(study, from(i, 0.0), freedom, evaluations, known, progress_.with_sink({}));
                if (!found.usable() || progress_.cancelled()) return;
                for (TrialPrediction& prediction : found.predictions) prediction.trace = {};
                JudgedFit fresh = judged(result_.data, std::move(found), result_.settings);
                const std::lock_guard<std::mutex> lock(mutex);
                runs_ += fresh.fit.runs(fit_count());
                if (!fits[i].usable() || fresh.fit.squares() < fits[i].fit.squares()) fits[i] = std::move(fresh);
                progress_.report({name, static_cast<double>(++done), 2.0 * static_cast<double>(starts.size()), "fits", starts[i].effect.id});
            });
        };
        round(serial_, EffectFreedom::amount, first_evaluations, [](std::size_t) { return true; }, [&](std::size_t i, double share) {
            StudyValues values = base.values;
            for (std::size_t p = 0; p < base.parameters.size() && starts[i].step.size() > 0; ++p) {
                const StudyParameter& own = base.parameters[p];
                set_value(own, stepped(own.parameter, value_of(own, base.values), share * starts[i].step(static_cast<Index>(p))), values);
            }
            values.effects.push_back(starts[i].effect);
            return values;
        });
        double best = std::numeric_limits<double>::infinity();
        for (const Candidate& candidate : result_.candidates)
            if (candidate.judged) best = std::min(best, candidate.judged->fit.squares());
        for (const JudgedFit& fit : fits)
            if (fit.usable()) best = std::min(best, fit.fit.squares());
        done = static_cast<int>(starts.size());
        const auto unfinished = [&](const JointFit& fit) { return !fit.report.converged() || fit.parameters.size() < joint_parameters(study_, fit.values).size(); };
        const auto found_so_far = [&](std::size_t i, double) { return fits[i].fit.values; };
        const auto hopeful_one = [&](std::size_t i) { return fits[i].usable() && unfinished(fits[i].fit) && fits[i].fit.squares() < hopeful * best; };
        // The best goes first: what it comes to may leave the others no hope.
        std::size_t leader = starts.size();
        for (std::size_t i = 0; i < starts.size(); ++i)
            if (hopeful_one(i) && (leader == starts.size() || fits[i].fit.squares() < fits[leader].fit.squares())) leader = i;
        round(study_, EffectFreedom::all, more_evaluations, [&](std::size_t i) { return i == leader; }, found_so_far);
        if (leader < starts.size()) best = std::min(best, fits[leader].fit.squares());
        round(serial_, EffectFreedom::all, more_evaluations, [&](std::size_t i) { return i != leader && hopeful_one(i); }, found_so_far);
        return fits;
    }

    static void order_by_criterion(const FitData& data, JudgedFit& declared, std::vector<Candidate>& candidates) {
        std::vector<JudgedFit*> fits{&declared};
        for (Candidate& candidate : candidates)
            if (candidate.judged) fits.push_back(&*candidate.judged);
        weigh(data, fits);
        std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
            if (a.judged.has_value() != b.judged.has_value()) return a.judged.has_value();
            if (a.judged) return a.judged->criterion < b.judged->criterion;
            return (a.score.usable() ? a.score.test.explained : -1.0) > (b.score.usable() ? b.score.test.explained : -1.0);
        });
    }

    /// Where candidates are scored and their fits start. A fit without the missing effect bends what it has: damping stands in for every loss and
    /// lag, and from far up there no effect looks like itself. Numbers that have left what was expected go back there.
    JointFit base_of_candidates() {
        StudyValues values = result_.declared.fit.values;
        const StudyValues expected = declared_values(study_);
        bool bent = false;
        for (const StudyParameter& p : result_.declared.fit.parameters) {
            const double now = value_of(p, values), before = value_of(p, expected);
            const bool far = p.kind == StudyParameter::Kind::damping ? now > far_damping * before
                                                                      : p.kind == StudyParameter::Kind::start_shift && (now <= p.parameter.lower || now >= p.parameter.upper);
            if (!far) continue;
            bent = true;
            set_value(p, before, values);
        }
        if (!bent) return result_.declared.fit;
        JointFit base = fit(study_, values, EffectFreedom::all, 1, {}, progress_);
        return base.usable() ? base : result_.declared.fit;
    }

    bool single_effects() {
        const EffectFilter may_be_named = [this](const std::string& id) { return allowed(id); };
        std::vector<EffectScore> scores = stage("score", 2 * fit_count(), [&] {
            base_ = base_of_candidates();
            return score_coarsely(study_, result_.data, base_, may_be_named, progress_);
        });
        // What was bent may also be right, or no better elsewhere: then from where the declared fit ended.
        if (!progress_.cancelled() && base_.residual != result_.declared.fit.residual && best_score(scores).test.explained < sure_base) {
            std::vector<EffectScore> others = stage("score", fit_count(), [&] { return score_coarsely(study_, result_.data, result_.declared.fit, may_be_named, progress_); });
            if (best_score(others).left < best_score(scores).left) {
                scores = std::move(others);
                base_ = result_.declared.fit;
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
            const auto share = [&](std::size_t k) { return scores[k].usable() ? scores[k].test.explained : -1.0; };
            if (!first && share(i) > share(place->second)) place->second = i;
        }
        for (const auto& [id, i] : best_probe) result_.candidates.push_back({scores[i], adjusted[i], {}, {}});
        order_by_criterion(result_.data, result_.declared, result_.candidates);
        show();
        std::vector<CandidateStart> starts;
        for (const std::size_t i : chosen) starts.push_back(start_of(scores[i]));
        if (!refit(starts, 0, std::min(first_fits, starts.size())) || !correct_the_best()) return false;
        std::size_t last = starts.size();
        if (!result_.candidates.empty() && result_.candidates.front().judged &&
            explains(*result_.candidates.front().judged, result_.declared, result_.data, result_.numerics)) {
            last = std::min(first_fits, last);
            while (last < starts.size() && scores[chosen[last]].test.explained > worth_beside_best * scores[chosen[0]].test.explained) ++last;
        }
        if (!refit(starts, std::min(first_fits, starts.size()), last)) return false;
        find_confusions(study_, result_);
        show();
        return true;
    }

    /// The numerical error was found with the declared fit, whose motion may be far off: where the best candidate explains most but not all, it is
    /// found anew with that.
    bool correct_the_best() {
        if (result_.candidates.empty() || !result_.candidates.front().judged) return true;
        JudgedFit& best = *result_.candidates.front().judged;
        if (explains(best, result_.declared, result_.data, result_.numerics) || best.fit.squares() > far_better * result_.declared.fit.squares()) return true;
        return corrected(best);
    }

    bool is_corrected(const JudgedFit& judged_fit) const {
        const std::vector<EffectDeclaration>& effects = judged_fit.fit.values.effects;
        return !effects.empty() && std::equal(effects.begin(), effects.end(), corrected_at_.begin(), corrected_at_.end(), [](const EffectDeclaration& a, const EffectDeclaration& b) {
            return effect_words(a) == effect_words(b);
        });
    }

    /// The numerical error at a fit, and the fit with it.
    bool corrected(JudgedFit& judged_fit) {
        result_.numerics = stage("numerical error", 3 * static_cast<int>(study_.trials.size()), [&] { return error_at(judged_fit.fit.values); });
        if (progress_.cancelled()) return false;
        result_.data.shift = result_.numerics.shift;
        JointFit again = stage("last fit", 4 * fit_count(), [&] { return fit(study_, judged_fit.fit.values, EffectFreedom::all, 12, neighbourhood_of(judged_fit.fit), progress_); });
        if (progress_.cancelled()) return false;
        if (!again.usable()) return true;
        const double weight = judged_fit.weight, criterion = judged_fit.criterion;
        judged_fit = judged(result_.data, std::move(again), result_.settings);
        judged_fit.weight = weight;
        judged_fit.criterion = criterion;
        corrected_at_ = judged_fit.fit.values.effects;
        return true;
    }

    /// Fits the candidates first ... last of the starts.
    bool refit(const std::vector<CandidateStart>& starts, std::size_t first, std::size_t last) {
        if (first >= last) return true;
        const std::vector<CandidateStart> part(starts.begin() + static_cast<std::ptrdiff_t>(first), starts.begin() + static_cast<std::ptrdiff_t>(last));
        runs_ = 0;
        std::vector<JudgedFit> fits = stage("refit", 0, [&] { return fits_from("refit", base_, part); });
        result_.cost.back().runs += runs_;
        if (progress_.cancelled()) return false;
        for (std::size_t i = 0; i < fits.size(); ++i)
            for (Candidate& candidate : result_.candidates)
                if (candidate.score.id == part[i].effect.id && fits[i].usable()) candidate.judged = std::move(fits[i]);
        order_by_criterion(result_.data, result_.declared, result_.candidates);
        return true;
    }

    /// Where one effect leaves something, a second beside the best one, and the first is asked whether it is still needed.
    void second_effects() {
        if (result_.candidates.empty() || !result_.candidates.front().judged) return;
        const JudgedFit& first = *result_.candidates.front().judged;
        if (explains(first, result_.declared, result_.data, result_.numerics)) return;
        JointFit base = first.fit;
        std::vector<PredictionTask> tasks;
        for (const std::size_t trial : result_.data.trials) tasks.push_back({trial, &base.values});
        base.predictions = predict_trials(study_, tasks, {}, progress_);
        if (progress_.cancelled()) return;
        const std::string first_id = result_.candidates.front().score.id;
        const std::vector<EffectScore> scores = stage("score of pairs", 0, [&] {
            return score_coarsely(study_, result_.data, base, [&](const std::string& id) { return id != first_id && allowed(id); }, progress_);
        });
        if (progress_.cancelled()) return;
        std::vector<CandidateStart> starts;
        for (const std::size_t i : worth_fitting(scores, result_.settings.pairs)) starts.push_back(start_of(scores[i]));
        runs_ = 0;
        std::vector<JudgedFit> fits = stage("refit of pairs", 0, [&] { return fits_from("refit of pairs", base, starts); });
        result_.cost.back().runs += runs_;
        if (progress_.cancelled()) return;
        for (JudgedFit& fit : fits)
            if (fit.usable()) result_.pairs.push_back(std::move(fit));
        std::vector<JudgedFit*> all{&result_.declared};
        for (Candidate& candidate : result_.candidates)
            if (candidate.judged) all.push_back(&*candidate.judged);
        for (JudgedFit& pair : result_.pairs) all.push_back(&pair);
        weigh(result_.data, all);
        std::stable_sort(result_.pairs.begin(), result_.pairs.end(), [](const JudgedFit& a, const JudgedFit& b) { return a.criterion < b.criterion; });
        show();
    }

    /// The verdict, the fit it stands on with the numerical error taken anew, and all trials before and after.
    void conclude() {
        result_.augmented = decide(result_);
        const std::vector<TrialPrediction> before = stage("prediction", 2 * static_cast<int>(study_.trials.size()), [&] { return predict_all(result_.declared.fit.values); });
        const auto scored = [&](const StudyValues& fitted, const PredictionShift& shift, std::vector<TrialPrediction> predictions) {
            for (std::size_t t = 0; t < predictions.size(); ++t) predictions[t] = shifted(std::move(predictions[t]), shift, t);
            std::vector<std::size_t> all(study_.trials.size());
            std::iota(all.begin(), all.end(), std::size_t{0});
            return scored_run(study_, with_predicted_levels(study_, fitted), std::move(predictions), all);
        };
        result_.before = scored(result_.declared.fit.values, declared_shift_, before);
        if (result_.verdict.kind == VerdictKind::none) {
            result_.data.shift = declared_shift_;
            result_.after = result_.before;
            return;
        }
        if (!is_corrected(result_.augmented) && !corrected(result_.augmented)) return;
        if (result_.verdict.kind == VerdictKind::effects) result_.verdict.effects = result_.augmented.fit.effects;
        result_.after = scored(result_.augmented.fit.values, result_.data.shift, predict_all(result_.augmented.fit.values));
    }

    Study study_;
    Study serial_;                       // its fits run on one thread each, side by side
    const Progress& progress_;
    const std::function<void(const Diagnosis&)>& live_;
    std::unique_ptr<FitStore> store_;
    std::unique_ptr<Study> refined_;
    bool mesh_failed_ = false;
    JointFit base_;                                 // where candidates are scored and start
    PredictionShift declared_shift_;                // found with the declared fit, which it belongs to
    std::vector<EffectDeclaration> corrected_at_;   // effects of the fit at which the numerical error was last found
    int runs_ = 0;
    Diagnosis result_;
};

}  // namespace

Study with_steps_of(const Diagnosis& diagnosis, Study study) {
    for (StudyTrial& trial : study.trials) trial.options.h_s *= diagnosis.step_factor;
    return study;
}

Diagnosis diagnose(const Study& study, const DiagnoseSettings& settings, const Progress& progress, const std::function<void(const Diagnosis&)>& live) {
    return Work(study, settings, progress, live).take();
}

}  // namespace myo
