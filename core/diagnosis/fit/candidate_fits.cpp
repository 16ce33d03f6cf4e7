#include "diagnosis/fit/candidate_fits.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>

#include "base/parallel.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "inverse/bounded_step.hpp"
#include "inverse/fit_evaluations.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Squared residual that the Jacobian predicts for the best step within the bounds.
double predicted_squares(const JointFit& fit) {
    std::vector<inverse::Parameter> parameters;
    VectorXd at(static_cast<Index>(fit.parameters.size()));
    for (const prediction::ModelParameter& p : fit.parameters) {
        at(static_cast<Index>(parameters.size())) = inverse::internal_value(p.parameter,
                                                                            prediction::value_of(p, fit.values));
        parameters.push_back(p.parameter);
    }
    const inverse::StepBounds bounds = inverse::internal_step_bounds(parameters, at);
    const MatrixXd J = fit.jacobian * inverse::physical_slopes(parameters, at).asDiagonal();
    return (fit.residual + J * inverse::bounded_step(J, fit.residual, bounds.lower, bounds.upper)).squaredNorm();
}

/// Value after a step, within its bounds. A parameter over decades changes by at most a factor of e squared.
double stepped(const inverse::Parameter& p, double value, double step) {
    const double most = diagnosis_policy.fits.most_factor;
    const double lower = p.over_decades ? std::max(p.lower, (value + p.scale) / most - p.scale) : p.lower;
    const double upper = p.over_decades ? std::min(p.upper, (value + p.scale) * most - p.scale) : p.upper;
    return std::clamp(value + step, lower, upper);
}

/// Initial Jacobian of a fit: that of an earlier fit, or a new one.
enum class Slopes { of_neighbours, anew };

class Rounds {
public:
    Rounds(const CandidateFitting& fitting, const JointFit& base, const std::vector<CandidateStart>& starts,
           const std::string& name, const Progress& progress)
        : fitting_(fitting), starts_(starts), name_(name), progress_(progress), of_base_(neighbourhood_of(base)) {
        result_.fits.resize(starts.size());
    }

    const JudgedFit& fit(std::size_t i) const { return result_.fits[i]; }

    bool is_unfinished(std::size_t i) const {
        const JointFit& found = fit(i).fit;
        return fit(i).usable() && (!found.report.converged() ||
                                   found.parameters.size() < joint_parameters(fitting_.setup, found.values).size());
    }

    /// Fits the wanted candidates from the given values. A result is kept only if it is better than the previous one.
    void run(const setup::Setup& setup, EffectFreedom freedom, const Effort& effort,
             const std::function<bool(std::size_t)>& wanted,
             const std::function<prediction::ParameterValues(std::size_t)>& from,
             Slopes slopes = Slopes::of_neighbours) {
        parallel_tasks(static_cast<int>(starts_.size()), fitting_.setup.settings.threads, [&](int task) {
            const auto i = static_cast<std::size_t>(task);
            if (progress_.cancelled() || !wanted(i)) return;
            Neighbourhood known = slopes == Slopes::anew ? Neighbourhood{}
                                  : fit(i).usable()      ? neighbourhood_of(fit(i).fit)
                                                         : of_base_;
            known.paths = of_base_.paths;  // the paths of all candidates would exceed the memory
            JointFit found = stored_fit(fitting_.store, setup, fitting_.data, from(i), freedom, effort, known,
                                        progress_.with_sink({}));
            if (!found.usable() || progress_.cancelled()) return;
            for (prediction::TrialPrediction& prediction : found.predictions) prediction.trace = {};
            JudgedFit fresh = judged(fitting_.data, std::move(found), fitting_.settings);
            const std::lock_guard<std::mutex> lock(mutex_);
            result_.runs += fresh.fit.runs(static_cast<int>(fitting_.data.trials.size()));
            if (!fit(i).usable() || fresh.fit.squares() < fit(i).fit.squares()) result_.fits[i] = std::move(fresh);
            progress_.report({name_, static_cast<double>(++done_), 2.0 * static_cast<double>(starts_.size()), "fits",
                              starts_[i].effect.id});
        });
    }

    CandidateFits take() { return std::move(result_); }

private:
    const CandidateFitting& fitting_;
    const std::vector<CandidateStart>& starts_;
    const std::string& name_;
    const Progress& progress_;
    Neighbourhood of_base_;
    CandidateFits result_;
    std::atomic<int> done_{0};
    std::mutex mutex_;
};

}  // namespace

CandidateStart start_of(const EffectScore& score) {
    return {{score.id, score.best.effect, false}, score.best.step, false, score.share(), score.probed};
}

std::vector<CandidateStart> nonlinear_starts(const std::vector<EffectScore>& scores,
                                             const std::function<bool(const EffectScore&)>& wanted) {
    std::map<std::string, const EffectScore*> best;
    for (const EffectScore& score : scores) {
        if (!score.failure.empty() || score.nonlinear.empty() || !wanted(score)) continue;
        const EffectScore*& found = best[score.id];
        if (!found || score.share() > found->share()) found = &score;
    }
    std::vector<CandidateStart> starts;
    for (const auto& [id, score] : best)
        for (const EffectScore::Start& start : score->nonlinear)
            starts.push_back({{id, start.effect, false}, start.step, true, score->share(), {}});
    return starts;
}

CandidateFits fit_candidates(const CandidateFitting& fitting, const JointFit& base,
                             const std::vector<CandidateStart>& starts, double least_so_far, double pruning_factor,
                             const std::string& name, const Progress& progress) {
    Rounds rounds(fitting, base, starts, name, progress);
    const auto with_effect = [&](std::size_t i, prediction::ParameterValues values) {
        values.effects.push_back(starts[i].effect);
        return values;
    };
    const auto stepped_base = [&](std::size_t i) {
        prediction::ParameterValues values = base.values;
        for (std::size_t p = 0; p < base.parameters.size() && starts[i].step.size() > 0; ++p) {
            const prediction::ModelParameter& own = base.parameters[p];
            prediction::set_value(
                own,
                stepped(own.parameter, prediction::value_of(own, base.values), starts[i].step(static_cast<Index>(p))),
                values);
        }
        return with_effect(i, values);
    };
    rounds.run(
        fitting.serial, EffectFreedom::amount, diagnosis_policy.fits.amount,
        [&](std::size_t i) { return !starts[i].nonlinear; }, stepped_base);
    rounds.run(
        fitting.serial, EffectFreedom::amount, diagnosis_policy.fits.nonlinear,
        [&](std::size_t i) { return starts[i].nonlinear; }, stepped_base);
    // The start that a score predicts may be far beyond the linear range, or impossible to run.
    const auto went_wrong = [&](std::size_t i) {
        return !rounds.fit(i).usable() || rounds.fit(i).fit.squares() > base.squares();
    };
    rounds.run(
        fitting.serial, EffectFreedom::amount, diagnosis_policy.fits.amount,
        [&](std::size_t i) { return !starts[i].nonlinear && went_wrong(i); },
        [&](std::size_t i) { return with_effect(i, base.values); });
    rounds.run(
        fitting.serial, EffectFreedom::amount, diagnosis_policy.fits.nonlinear,
        [&](std::size_t i) { return !starts[i].nonlinear && !starts[i].safe.empty() && went_wrong(i); },
        [&](std::size_t i) {
            prediction::ParameterValues values = base.values;
            values.effects.push_back({starts[i].effect.id, starts[i].safe, false});
            return values;
        });
    const auto found_so_far = [&](std::size_t i) { return rounds.fit(i).fit.values; };
    double most_promised = 0.0;
    for (const CandidateStart& start : starts) most_promised = std::max(most_promised, start.predicted_reduction);
    const auto has_fallen_short = [&](std::size_t i) {
        if (!rounds.is_unfinished(i) || rounds.fit(i).fit.report.converged() ||
            starts[i].predicted_reduction < diagnosis_policy.fits.worth_repeating * most_promised)
            return false;
        const double squares = rounds.fit(i).fit.squares();
        return squares >
                   diagnosis_policy.fits.missed_reduction * (1.0 - starts[i].predicted_reduction) * base.squares() &&
               squares < diagnosis_policy.fits.least_progress * base.squares();
    };
    rounds.run(fitting.serial, EffectFreedom::amount, diagnosis_policy.fits.repeated, has_fallen_short, found_so_far,
               Slopes::anew);
    const auto has_large_reduction = [&](std::size_t i) {
        return starts[i].predicted_reduction > diagnosis_policy.fits.large_reduction;
    };
    std::vector<bool> went_on(starts.size(), false);
    // The best candidate is fitted first, on all threads: its result may prune the others.
    for (;;) {
        double least = least_so_far, predicted = 1.0;
        for (std::size_t i = 0; i < starts.size(); ++i)
            if (rounds.fit(i).usable() && rounds.fit(i).fit.squares() < least) {
                least = rounds.fit(i).fit.squares();
                predicted = starts[i].predicted_reduction;
            }
        // While the best fit is far above the noise, it may be the wrong effect: the limit is higher.
        const double patience_yet = pruning_factor * std::clamp(least / static_cast<double>(base.residual.size()), 1.0,
                                                                pruning_factor * pruning_factor);
        std::vector<std::size_t> next;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const double patience = starts[i].predicted_reduction >
                                            diagnosis_policy.fits.comparable_reduction * predicted
                                        ? std::max(pruning_factor * pruning_factor, patience_yet)
                                        : patience_yet;
            if (went_on[i] || !rounds.is_unfinished(i)) continue;
            // An unfinished fit also continues if its Jacobian predicts a sufficiently small residual.
            if (rounds.fit(i).fit.squares() < patience * least ||
                predicted_squares(rounds.fit(i).fit) < pruning_factor * least)
                next.push_back(i);
        }
        if (next.empty()) break;
        const bool first = std::find(went_on.begin(), went_on.end(), true) == went_on.end();
        const std::size_t count = std::min(
            next.size(),
            first ? std::size_t{1} : static_cast<std::size_t>(std::max(1, fitting.setup.settings.threads)));
        std::partial_sort(
            next.begin(), next.begin() + static_cast<std::ptrdiff_t>(count), next.end(),
            [&](std::size_t a, std::size_t b) { return rounds.fit(a).fit.squares() < rounds.fit(b).fit.squares(); });
        std::vector<bool> chosen(starts.size(), false);
        for (std::size_t k = 0; k < count; ++k) went_on[next[k]] = chosen[next[k]] = true;
        const setup::Setup& setup = first ? fitting.setup : fitting.serial;
        rounds.run(
            setup, EffectFreedom::all, diagnosis_policy.fits.leader,
            [&](std::size_t i) { return chosen[i] && (first || has_large_reduction(i)); }, found_so_far);
        rounds.run(
            setup, EffectFreedom::all, diagnosis_policy.fits.other,
            [&](std::size_t i) { return chosen[i] && !(first || has_large_reduction(i)); }, found_so_far);
    }
    return rounds.take();
}

}  // namespace myo::diagnosis
