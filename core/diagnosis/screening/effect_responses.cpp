#include "diagnosis/screening/effect_responses.hpp"

#include <functional>
#include <mutex>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/throttle.hpp"
#include "prediction/first_order_effects.hpp"

namespace myo::diagnosis {
namespace {

using prediction::TrialPrediction;

/// What flat_residual() reads of a prediction.
TrialPrediction residual_of(const TrialPrediction& prediction) {
    TrialPrediction part;
    part.status = prediction.status;
    part.message = prediction.message;
    part.residual_m = prediction.residual_m;
    part.places_m = prediction.places_m;
    return part;
}

/// How far the markers move from their start, rms over all coordinates [m].
double motion_of(const TrialPrediction& prediction) {
    std::vector<Eigen::Matrix3Xd> moved = prediction.positions_m;
    for (std::size_t m = 0; m < moved.size(); ++m) moved[m].colwise() -= prediction.start_m[m];
    return prediction::rms(moved);
}

/// Predictions of all trials with each effect, as they are found.
class EffectPredictions {
public:
    /// Refers to its arguments, which must outlive it.
    EffectPredictions(const UnaffectedRuns& runs, const std::vector<effect::EffectDeclaration>& effects,
                      const std::string& task, const Progress& progress)
        : runs_(runs), effects_(effects), task_(task), progress_(progress), seconds_(effects.size(), 0.0) {
        predictions_.assign(effects.size(), std::vector<TrialPrediction>(runs.predictions.size()));
    }

    /// To first order in the effects, where that is possible and the response is small; the others stay open.
    void find_first_order(const FirstOrderPolicy& policy) {
        std::vector<Part> parts;
        for (std::size_t i = 0; i < runs_.predictions.size(); ++i) add_parts(i, policy.effects_of_a_run, parts);
        parallel(parts.size(), [&](std::size_t p) {
            const Stopwatch watch;
            follow(parts[p], policy.max_response);
            std::vector<std::size_t> known;
            for (const std::size_t e : parts[p].effects)
                if (predictions_[e][parts[p].trial].ok()) known.push_back(e);
            if (!known.empty()) finish(known, watch.seconds());
        });
    }

    /// All that are open, by a run each.
    void find_open() {
        std::vector<std::pair<std::size_t, std::size_t>> open;
        for (std::size_t e = 0; e < effects_.size(); ++e)
            for (std::size_t i = 0; i < runs_.predictions.size(); ++i)
                if (!predictions_[e][i].ok()) open.emplace_back(e, i);
        parallel(open.size(), [&](std::size_t o) {
            const auto [e, i] = open[o];
            const Stopwatch watch;
            predictions_[e][i] = run(e, i);
            finish({e}, watch.seconds());
        });
    }

    const std::vector<TrialPrediction>& of(std::size_t effect) const { return predictions_[effect]; }
    double seconds(std::size_t effect) const { return seconds_[effect]; }

private:
    /// Effects that share a run of a trial.
    struct Part {
        std::size_t trial = 0;
        std::vector<std::size_t> effects;
    };

    bool acts(std::size_t effect, std::size_t i) const {
        return effect::acts_on(runs_.search.trials[i], effects_[effect].parameters);
    }

    void add_parts(std::size_t i, std::size_t most, std::vector<Part>& parts) const {
        for (std::size_t e = 0; e < effects_.size(); ++e) {
            if (setup::changes_observation_only(effects_[e]) || !acts(e, i)) continue;
            if (parts.empty() || parts.back().trial != i || parts.back().effects.size() == most)
                parts.push_back({i, {}});
            parts.back().effects.push_back(e);
        }
    }

    void follow(const Part& part, double max_response) {
        const TrialPrediction& unaffected = runs_.predictions[part.trial];
        const double motion = motion_of(unaffected);
        std::vector<effect::EffectDeclaration> chosen;
        for (const std::size_t e : part.effects) chosen.push_back(effects_[e]);
        const auto changes = prediction::first_order_changes(runs_.setup, runs_.data.trials[part.trial], runs_.values,
                                                             chosen, progress_.with_sink({}), unaffected.trace.path);
        for (std::size_t k = 0; k < changes.size(); ++k) {
            if (!changes[k] || prediction::rms(*changes[k]) > max_response * motion) continue;
            TrialPrediction& prediction = predictions_[part.effects[k]][part.trial];
            prediction = residual_of(unaffected);
            for (std::size_t m = 0; m < prediction.residual_m.size(); ++m) prediction.residual_m[m] += (*changes[k])[m];
        }
    }

    TrialPrediction run(std::size_t effect, std::size_t i) const {
        const std::size_t trial = runs_.data.trials[i];
        const TrialPrediction& unaffected = runs_.predictions[i];
        // The response is exactly zero.
        if (!acts(effect, i)) return residual_of(unaffected);
        prediction::ParameterValues values = runs_.values;
        values.effects.push_back(effects_[effect]);
        return residual_of(setup::changes_observation_only(effects_[effect])
                               ? prediction::observe_trial(runs_.setup, trial, values, unaffected.trace)
                               : prediction::predict_trial(runs_.setup, trial, values, {}, progress_.with_sink({}),
                                                           unaffected.trace.path));
    }

    /// Tasks write to their own predictions; only finish() needs the mutex.
    void parallel(std::size_t count, const std::function<void(std::size_t)>& task) const {
        parallel_tasks(static_cast<int>(count), runs_.setup.settings.threads, [&](int number) {
            if (!progress_.cancelled()) task(static_cast<std::size_t>(number));
        });
    }

    void finish(const std::vector<std::size_t>& effects, double seconds) {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (const std::size_t e : effects) seconds_[e] += seconds / static_cast<double>(effects.size());
        done_ += effects.size();
        const std::size_t all = effects_.size() * runs_.predictions.size();
        if (done_ == all || throttle_.ready())
            progress_.report(
                {task_, static_cast<double>(done_), static_cast<double>(all), "runs", effects_[effects.front()].id});
    }

    const UnaffectedRuns& runs_;
    const std::vector<effect::EffectDeclaration>& effects_;
    const std::string& task_;
    const Progress& progress_;
    std::vector<std::vector<TrialPrediction>> predictions_;  // [effect][i]
    std::vector<double> seconds_;
    std::mutex mutex_;
    Throttle throttle_;
    std::size_t done_ = 0;
};

}  // namespace

std::vector<EffectResponse> effect_responses(const UnaffectedRuns& runs,
                                             const std::vector<effect::EffectDeclaration>& effects,
                                             const std::optional<FirstOrderPolicy>& first_order,
                                             const std::string& task, const Progress& progress) {
    EffectPredictions predictions(runs, effects, task, progress);
    if (first_order) predictions.find_first_order(*first_order);
    predictions.find_open();
    if (progress.cancelled()) return {};
    std::vector<EffectResponse> responses(effects.size());
    // In the difference of two residuals the measurement and the shift cancel.
    const Eigen::VectorXd before = diagnosis::flat_residual(runs.data, runs.predictions);
    for (std::size_t e = 0; e < effects.size(); ++e) {
        responses[e].seconds = predictions.seconds(e);
        for (const TrialPrediction& prediction : predictions.of(e))
            if (!prediction.ok()) responses[e].failure = prediction.message;
        if (responses[e].failure.empty())
            responses[e].change = diagnosis::flat_residual(runs.data, predictions.of(e)) - before;
    }
    return responses;
}

}  // namespace myo::diagnosis
