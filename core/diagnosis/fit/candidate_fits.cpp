#include "diagnosis/fit/candidate_fits.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "base/parallel.hpp"
#include "diagnosis/fit/pruning.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "inverse/bounded_step.hpp"
#include "inverse/fit_evaluations.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Squared residual that the Jacobian predicts for the best step within the bounds.
/// One Gauss-Newton step in the internal (scaled or logarithmic) parameters, as the solver takes it.
double predicted_squares(const JointFit& fit) {
    std::vector<inverse::Parameter> parameters;
    VectorXd at(static_cast<Index>(fit.parameters.size()));
    for (const prediction::ModelParameter& p : fit.parameters) {
        at(static_cast<Index>(parameters.size())) = inverse::internal_value(p.parameter,
                                                                            prediction::value_of(p, fit.values));
        parameters.push_back(p.parameter);
    }
    const inverse::StepBounds bounds = inverse::internal_step_bounds(parameters, at);
    VectorXd residual(fit.residual.size() + fit.sensor_residual.size());
    residual << fit.residual, fit.sensor_residual;
    const MatrixXd J = all_slopes(fit) * inverse::physical_slopes(parameters, at).asDiagonal();
    return (residual + J * inverse::bounded_step(J, residual, bounds.lower, bounds.upper)).squaredNorm();
}

/// Value after a step, within its bounds. A parameter over decades changes by at most the factor `most`.
double stepped(const inverse::Parameter& p, double value, double step, double most) {
    const double lower = p.over_decades ? std::max(p.lower, (value + p.scale) / most - p.scale) : p.lower;
    const double upper = p.over_decades ? std::min(p.upper, (value + p.scale) * most - p.scale) : p.upper;
    return std::clamp(value + step, lower, upper);
}

/// Initial Jacobian of a fit: that of an earlier fit, or a new one.
enum class Slopes { of_earlier_fit, computed };

/// Candidate fits in rounds; each round fits some of the candidates in parallel.
class Rounds {
public:
    /// Refers to its arguments, which must outlive the rounds.
    Rounds(const CandidateFitInput& in, FitStore& store, const Progress& progress)
        : in_(in), store_(store), progress_(progress), serial_(in.setup), of_base_(warm_start_of(in.base)) {
        serial_.settings.threads = 1;
        fits_.resize(in.starts.size());
    }

    const JudgedFit& fit(std::size_t i) const { return fits_[i]; }
    int runs() const { return runs_; }

    /// Whether a usable fit has not converged, or not with all parameters of its effects yet.
    bool is_unfinished(std::size_t i) const {
        const JointFit& found = fit(i).fit;
        return fit(i).usable() && (!found.report.converged() ||
                                   found.parameters.size() <
                                       joint_parameters(in_.setup, found.values, in_.settings.policy.declared).size());
    }

    // All are called from several threads at once, for different candidates; they must not write.
    using Wanted = std::function<bool(std::size_t)>;
    using Start = std::function<prediction::ParameterValues(std::size_t)>;
    using EffortOf = std::function<Effort(std::size_t)>;

    /// Fits the amounts of the wanted candidates, each on one thread.
    void fit_amounts(const Effort& effort, const Wanted& wanted, const Start& from,
                     Slopes slopes = Slopes::of_earlier_fit) {
        run(
            serial_, EffectFreedom::amount, [&](std::size_t) { return effort; }, wanted, from, slopes);
    }
    /// Continues the wanted candidates with all parameters, each on its share of the threads.
    ///
    /// @param count  how many are wanted, at least 1
    void continue_fits(const EffortOf& effort, std::size_t count, const Wanted& wanted) {
        setup::Setup shared = in_.setup;
        shared.settings.threads = std::max(1, in_.setup.settings.threads / static_cast<int>(count));
        run(
            shared, EffectFreedom::all, effort, wanted, [this](std::size_t i) { return fit(i).fit.values; },
            Slopes::of_earlier_fit);
    }

    std::vector<JudgedFit> take() { return std::move(fits_); }

private:
    /// A result is kept only if it is better than the previous one.
    void run(const setup::Setup& setup, EffectFreedom freedom, const EffortOf& effort, const Wanted& wanted,
             const Start& from, Slopes slopes) {
        parallel_tasks(static_cast<int>(in_.starts.size()), in_.setup.settings.threads, [&](int task) {
            const auto i = static_cast<std::size_t>(task);
            if (progress_.cancelled() || !wanted(i)) return;
            // The own earlier Jacobian is nearer than that of the base fit, which lacks the columns of the effect.
            WarmStart warm = slopes == Slopes::computed ? WarmStart{}
                             : fit(i).usable()          ? warm_start_of(fit(i).fit)
                                                        : of_base_;
            warm.paths = of_base_.paths;  // the paths of all candidates would exceed the memory
            const prediction::ParameterValues start = from(i);
            JointFit found = stored_fit(
                {setup, in_.data, start, in_.settings.policy, freedom, effort(i), std::move(warm)}, store_,
                progress_.with_sink({}));
            // A cancelled fit is not kept: it would look like one that made no progress.
            if (!found.usable() || progress_.cancelled()) return;
            // Only residuals and positions are needed further on; traces of all candidates would exceed the memory.
            for (prediction::TrialPrediction& prediction : found.predictions) prediction.trace = {};
            JudgedFit fresh = judged(in_.data, std::move(found), in_.settings);
            const std::lock_guard<std::mutex> lock(mutex_);
            runs_ += fresh.fit.runs(static_cast<int>(in_.data.trials.size()));
            if (!fit(i).usable() || fresh.fit.squares() < fit(i).fit.squares()) fits_[i] = std::move(fresh);
            // The total is an estimate: one fit of amounts and one of all parameters per candidate.
            progress_.report({in_.phase, static_cast<double>(++done_), 2.0 * static_cast<double>(in_.starts.size()),
                              "fits", in_.starts[i].effect.id});
        });
    }

    const CandidateFitInput& in_;
    FitStore& store_;
    const Progress& progress_;
    setup::Setup serial_;  // one thread per fit, for fits in parallel
    WarmStart of_base_;
    std::vector<JudgedFit> fits_;
    int runs_ = 0;
    std::atomic<int> done_{0};
    std::mutex mutex_;
};

/// Values with one more effect, behind those of the base.
prediction::ParameterValues with_effect(prediction::ParameterValues values, effect::EffectDeclaration effect) {
    values.effects.push_back(std::move(effect));
    return values;
}

/// Values of the base fit after the step of a start, with its effect.
prediction::ParameterValues stepped_base(const CandidateFitInput& in, const CandidateStart& start) {
    prediction::ParameterValues values = in.base.values;
    for (std::size_t p = 0; p < in.base.parameters.size() && start.step.size() > 0; ++p) {
        const prediction::ModelParameter& own = in.base.parameters[p];
        prediction::set_value(own,
                              stepped(own.parameter, prediction::value_of(own, in.base.values),
                                      start.step(static_cast<Index>(p)), in.settings.policy.fits.max_factor),
                              values);
    }
    return with_effect(std::move(values), start.effect);
}

/// Fits the amounts from the predicted starts. The start that a score predicts may be far beyond the linear range, or
/// impossible to run: then from the base fit, and from the parameters of the probe.
void fit_first_amounts(const CandidateFitInput& in, Rounds& rounds) {
    const CandidateFitPolicy& policy = in.settings.policy.fits;
    const std::vector<CandidateStart>& starts = in.starts;
    const auto stepped = [&](std::size_t i) { return stepped_base(in, starts[i]); };
    rounds.fit_amounts(
        policy.amount, [&](std::size_t i) { return !starts[i].nonlinear; }, stepped);
    rounds.fit_amounts(
        policy.nonlinear, [&](std::size_t i) { return starts[i].nonlinear; }, stepped);
    // The base fit with the amount 0 would be as good as the base: a larger residual means that the start was bad.
    const auto went_wrong = [&](std::size_t i) {
        return !starts[i].nonlinear && (!rounds.fit(i).usable() || rounds.fit(i).fit.squares() > in.base.squares());
    };
    rounds.fit_amounts(policy.amount, went_wrong,
                       [&](std::size_t i) { return with_effect(in.base.values, starts[i].effect); });
    rounds.fit_amounts(
        policy.nonlinear, [&](std::size_t i) { return !starts[i].safe.empty() && went_wrong(i); },
        [&](std::size_t i) {
            return with_effect(in.base.values, {starts[i].effect.id, starts[i].safe, false, starts[i].effect.law});
        });
}

/// Repeats fits of a large predicted reduction that missed it, with derivatives of their own.
void repeat_missed_amounts(const CandidateFitInput& in, Rounds& rounds) {
    const CandidateFitPolicy& policy = in.settings.policy.fits;
    double largest = 0.0;
    for (const CandidateStart& start : in.starts) largest = std::max(largest, start.predicted_reduction);
    // Only fits of a large predicted reduction: the Jacobian of the base does not hold at their start.
    const auto missed = [&](std::size_t i) {
        const double reduction = in.starts[i].predicted_reduction, base = in.base.squares();
        if (!rounds.is_unfinished(i) || rounds.fit(i).fit.report.converged() ||
            reduction < policy.worth_repeating * largest)
            return false;
        const double squares = rounds.fit(i).fit.squares();
        return squares > policy.missed_reduction * (1.0 - reduction) * base && squares < policy.min_progress * base;
    };
    rounds.fit_amounts(
        policy.repeated, missed, [&](std::size_t i) { return rounds.fit(i).fit.values; }, Slopes::computed);
}

/// Continues the fits that may still become the best. The best one is fitted first, on all threads: its result may
/// prune the others.
void continue_best(const CandidateFitInput& in, Rounds& rounds) {
    const CandidateFitPolicy& policy = in.settings.policy.fits;
    const std::size_t count = in.starts.size();
    const double stuck_squares = policy.min_progress * in.base.squares();
    const auto squares = [&](std::size_t i) {
        return rounds.fit(i).usable() ? rounds.fit(i).fit.squares() : std::numeric_limits<double>::infinity();
    };
    // A fit without progress is continued in two parts, the second only if the first one makes some.
    std::vector<bool> continued(count, false), tried(count, false);
    const auto is_open = [&](std::size_t i) {
        return !continued[i] && !(tried[i] && squares(i) > stuck_squares) && rounds.is_unfinished(i);
    };
    // Each round prunes with the smallest residual so far, so that a good leader saves most of the others.
    for (bool first = true;; first = false) {
        PruningInput pruning{{},
                             in.least_so_far,
                             in.base.samples(),
                             in.pruning_factor,
                             policy.comparable_reduction,
                             policy.promising * in.base.squares(),
                             policy.noise_like,
                             stuck_squares};
        for (std::size_t i = 0; i < count; ++i)
            pruning.fits.push_back({squares(i), in.starts[i].predicted_reduction, is_open(i)});
        std::vector<std::size_t> next = fits_worth_continuing(
            pruning, [&](std::size_t i) { return predicted_squares(rounds.fit(i).fit); });
        if (next.empty()) return;
        const std::size_t most = first ? 1 : policy.fitted_together;
        const auto end = next.begin() + static_cast<std::ptrdiff_t>(std::min(next.size(), most));
        std::partial_sort(next.begin(), end, next.end(), [&](std::size_t a, std::size_t b) {
            return pruning.fits[a].squares < pruning.fits[b].squares;
        });
        std::vector<bool> chosen(count, false);
        std::vector<Effort> efforts(count);
        for (auto i = next.begin(); i != end; ++i) {
            const bool stuck = !first && squares(*i) > stuck_squares;
            chosen[*i] = true;
            (stuck ? tried : continued)[*i] = true;
            efforts[*i] = stuck                                                        ? policy.stuck
                          : first                                                      ? policy.leader
                          : in.starts[*i].predicted_reduction > policy.large_reduction ? policy.rival
                                                                                       : policy.other;
        }
        const auto effort = [&](std::size_t i) { return efforts[i]; };
        rounds.continue_fits(effort, static_cast<std::size_t>(end - next.begin()),
                             [&](std::size_t i) { return static_cast<bool>(chosen[i]); });
    }
}

}  // namespace

CandidateStart start_of(const EffectScore& score) {
    return {{score.id, score.best.effect, false, score.law}, score.best.step, false, score.share(), score.probed};
}

std::vector<CandidateStart> nonlinear_starts(const std::vector<EffectScore>& scores,
                                             const std::function<bool(const EffectScore&)>& wanted) {
    std::map<std::string, const EffectScore*> best;
    for (const EffectScore& score : scores) {
        if (!score.failure.empty() || score.nonlinear.empty() || !wanted(score)) continue;
        const EffectScore*& found = best[score.id];
        // Other probes of the effect would mostly lead to the same minimum.
        if (!found || score.share() > found->share()) found = &score;
    }
    std::vector<CandidateStart> starts;
    for (const auto& [id, score] : best)
        for (const EffectScore::Start& start : score->nonlinear)
            starts.push_back({{id, start.effect, false, score->law}, start.step, true, score->share(), {}});
    return starts;
}

std::vector<JudgedFit> fit_candidates(const CandidateFitInput& in, FitStore& store, PhaseLog& log) {
    Rounds rounds(in, store, log.progress());
    std::vector<JudgedFit> fits = log.timed(in.phase, 0, [&] {
        fit_first_amounts(in, rounds);
        repeat_missed_amounts(in, rounds);
        continue_best(in, rounds);
        return rounds.take();
    });
    log.add(in.phase, 0.0, rounds.runs());
    return fits;
}

}  // namespace myo::diagnosis
