#include "prediction/predict_trials.hpp"

#include <algorithm>
#include <mutex>

#include "base/parallel.hpp"
#include "base/throttle.hpp"

namespace myo::prediction {
namespace {

const setup::Setup& setup_of(const PredictionTask& task, const setup::Setup& common) {
    return task.setup ? *task.setup : common;
}

/// Merges the progress of trials that run in parallel into one: simulated seconds done, summed over the trials.
class JoinedProgress {
public:
    JoinedProgress(const setup::Setup& setup, const std::vector<PredictionTask>& tasks, const Progress& outer)
        : outer_(outer), done_(tasks.size(), 0.0) {
        for (const PredictionTask& task : tasks) total_ += setup_of(task, setup).trials[task.trial].options.end_s;
    }
    Progress of(std::size_t task) {
        return outer_.with_sink([this, task](const ProgressEvent& event) {
            const std::lock_guard<std::mutex> lock(mutex_);
            sum_ += event.done - done_[task];
            done_[task] = event.done;
            // The final report is never throttled; rounding can push the sum slightly over the total.
            const bool last = sum_ >= total_;
            if (last || throttle_.ready())
                outer_.report({event.task, std::min(sum_, total_), total_, event.unit, event.message});
        });
    }

private:
    const Progress& outer_;
    std::mutex mutex_;
    std::vector<double> done_;
    double sum_ = 0.0;
    double total_ = 0.0;
    Throttle throttle_;
};

}  // namespace

std::vector<TrialPrediction> predict_trials(const setup::Setup& setup, const std::vector<PredictionTask>& tasks,
                                            const std::vector<ModelParameter>& parameters, const Progress& progress) {
    std::vector<TrialPrediction> predictions(tasks.size());
    JoinedProgress joined(setup, tasks, progress);
    // Trials are independent; each prediction is written by one thread only.
    parallel_tasks(static_cast<int>(tasks.size()), setup.settings.threads, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        predictions[i] = predict_trial(setup_of(tasks[i], setup), tasks[i].trial, *tasks[i].values, parameters,
                                       joined.of(i), tasks[i].warm_start);
    });
    return predictions;
}

std::vector<TrialPrediction> predict_trials_with(const setup::Setup& setup, const ParameterValues& values,
                                                 const std::vector<std::size_t>& trials, const Progress& progress,
                                                 const std::vector<ModelParameter>& parameters) {
    std::vector<PredictionTask> tasks;
    for (const std::size_t trial : trials) tasks.push_back({trial, &values});
    return predict_trials(setup, tasks, parameters, progress);
}

setup::Setup with_kept_paths(setup::Setup setup) {
    for (setup::PreparedTrial& trial : setup.trials) {
        // TR-BDF2 has two stages per step, each with one displacement per degree of freedom of 8 bytes.
        const double stages = 2.0 * trial.options.end_s / trial.options.h_s;
        trial.options.keep_path = 8.0 * stages * setup.body->dofs() < path_policy.max_bytes;
    }
    return setup;
}

bool all_ok(const std::vector<TrialPrediction>& predictions) {
    return std::all_of(predictions.begin(), predictions.end(),
                       [](const TrialPrediction& prediction) { return prediction.ok(); });
}

std::vector<std::size_t> trials_with_role(const setup::Setup& setup, experiment::TrialRole role) {
    std::vector<std::size_t> list;
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        if (setup.trials[t].role == role) list.push_back(t);
    return list;
}

}  // namespace myo::prediction
