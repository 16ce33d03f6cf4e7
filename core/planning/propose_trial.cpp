#include "planning/propose_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/throttle.hpp"
#include "experiment/read_experiment.hpp"
#include "planning/planned_trials.hpp"
#include "prediction/prediction.hpp"
#include "prediction/time_step.hpp"
#include "statistics/nuisance_space.hpp"

namespace myo::planning {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The declared limits, replaced one by one by those of the task.
experiment::LimitsDeclaration merged(experiment::LimitsDeclaration declared, const experiment::LimitsDeclaration& own) {
    const auto replace = [](std::optional<double>& value, const std::optional<double>& by) {
        if (by) value = by;
    };
    replace(declared.force_N, own.force_N);
    replace(declared.mass_kg, own.mass_kg);
    replace(declared.duration_s, own.duration_s);
    replace(declared.pressure_Pa, own.pressure_Pa);
    replace(declared.tension_N, own.tension_N);
    replace(declared.shortening_m, own.shortening_m);
    replace(declared.activation, own.activation);
    return declared;
}

/// Every n-th trial, so that all kinds stay.
std::vector<PossibleTrial> evenly(std::vector<PossibleTrial> family, std::size_t most) {
    if (family.size() <= most) return family;
    std::vector<PossibleTrial> chosen;
    for (std::size_t i = 0; i < most; ++i) chosen.push_back(family[i * family.size() / most]);
    return chosen;
}

/// Shortest step of the moving trials, in whole parts of the sampling interval.
/// With a step that is a whole part of the interval, every sample is at the end of a step.
double step_of(const setup::Setup& setup, const setup::PreparedTrial& trial) {
    const double interval = setup::sampling_interval_s(trial);
    double shortest = std::numeric_limits<double>::infinity();
    for (const setup::PreparedTrial& other : setup.trials)
        if (!other.hold) shortest = std::min(shortest, other.options.h_s);
    if (shortest > interval) shortest = 0.5 * interval;
    return prediction::whole_part(interval, shortest);
}

/// The setup with the trials of a family behind its own.
Result<setup::Setup> with_family(const ProposalTask& task, const std::vector<PossibleTrial>& family,
                                 const Progress& progress) {
    // By way of the text, so that a proposed trial is read and checked as the user's own will be. Only signals of
    // muscles are added behind the reader, which takes them from files.
    std::string text = task.declaration + "\n";
    for (PossibleTrial trial : family) {
        trial.signal.reset();
        text += trial_text(trial) + "\n";
    }
    const Result<experiment::Experiment> read = experiment::read_experiment_text(text, task.file);
    if (!read) return read.error();
    experiment::Experiment added = task.setup.experiment;
    // Only the new trials are prepared; mesh and body of the fits are kept.
    added.trials.assign(read->trials.end() - static_cast<std::ptrdiff_t>(family.size()), read->trials.end());
    for (std::size_t i = 0; i < family.size(); ++i) added.trials[i].tried_actuation = family[i].signal;
    Result<setup::Setup> prepared = setup::prepare_setup(added, task.setup.settings, progress, &task.setup.mesh);
    if (!prepared) return prepared.error();
    setup::Setup whole = task.setup;
    for (std::size_t i = 0; i < family.size(); ++i) {
        setup::PreparedTrial& trial = prepared->trials[i];
        trial.model.body = whole.body;  // perhaps of another element than the declared one
        trial.options.solver = task.setup.trials.front().options.solver;
        if (!trial.hold) setup::set_step(trial, step_of(task.setup, trial));
        whole.experiment.trials.push_back(added.trials[i]);
        whole.trials.push_back(std::move(trial));
    }
    // Steps are chosen per trial; the list would be too short for the added ones.
    whole.steps.clear();
    return with_planned_trials(std::move(whole));
}

/// Values of a rival with entries for the further trials.
prediction::ParameterValues extended(prediction::ParameterValues values, std::size_t trials) {
    values.start_shift_s.resize(trials, 0.0);
    values.levels.resize(trials);
    return values;
}

/// Predictions of all trials of the family with both rivals, in parallel: [trial][rival]. Incomplete if cancelled.
std::vector<std::array<prediction::TrialPrediction, 2>> rival_predictions(const setup::Setup& whole,
                                                                          const ProposalTask& task, std::size_t family,
                                                                          const Progress& progress) {
    const std::size_t first = whole.trials.size() - family;
    const std::array values{extended(task.rivals[0].values, whole.trials.size()),
                            extended(task.rivals[1].values, whole.trials.size())};
    std::vector<std::array<prediction::TrialPrediction, 2>> predictions(family);
    std::mutex mutex;
    Throttle throttle;
    int done = 0;
    const int all = static_cast<int>(2 * family);
    parallel_tasks(all, whole.settings.threads, [&](int number) {
        if (progress.cancelled()) return;
        const std::size_t t = static_cast<std::size_t>(number) / 2, k = static_cast<std::size_t>(number) % 2;
        prediction::TrialPrediction& made = predictions[t][k];
        made = prediction::predict_trial(whole, first + t, values[k], task.rivals[k].parameters,
                                         progress.with_sink({}));
        made.trace = {};  // the memory of many runs
        const std::lock_guard<std::mutex> lock(mutex);
        if (++done == all || throttle.ready())
            progress.report({"possible trials", static_cast<double>(done), static_cast<double>(all), "runs",
                             whole.trials[first + t].name});
    });
    return predictions;
}

/// Rates a trial by the harder of two questions: whether each rival, if the other one is true, is rejected.
RatedTrial rated(const setup::Setup& whole, std::size_t trial, const PossibleTrial& possible, const ProposalTask& task,
                 const std::array<prediction::TrialPrediction, 2>& made, double numerical_error) {
    RatedTrial result{possible, 0.0, 0.0, 0.0, {}};
    for (const prediction::TrialPrediction& prediction : made)
        if (!prediction.ok()) result.failure = prediction.message;
    if (!result.failure.empty()) return result;
    for (std::size_t k = 0; k < made.size(); ++k) {
        const Rival& wrong = task.rivals[k];
        const std::vector<prediction::TrialPrediction> of_wrong{made[k]}, of_true{made[1 - k]};
        const diagnosis::FitData data = diagnosis::with_unknown_places(whole, diagnosis::fit_data(whole, {trial}),
                                                                       of_wrong);
        // Both residuals refer to the same planned recording, which cancels.
        const VectorXd d = diagnosis::flat_residual(data, of_true) - diagnosis::flat_residual(data, of_wrong);
        const MatrixXd J = diagnosis::flat_jacobian(data, of_wrong, wrong.parameters.size());
        double left = 0.0;
        const double value = contradiction(wrong.slopes, wrong.blocks, J, d, error_blocks(data.layout), numerical_error,
                                           left);
        if (k > 0 && value >= result.noncentrality) continue;
        result.noncentrality = value;
        result.difference_m = diagnosis::mean_noise_m(data) * left /
                              std::sqrt(static_cast<double>(std::max<Index>(1, d.size())));
    }
    // One degree of freedom: the difference of two given rivals is one direction.
    result.probability = detection_probability(result.noncentrality, 1.0, task.policy.detection.alpha);
    return result;
}

}  // namespace

double contradiction(const MatrixXd& known, const std::vector<ErrorBlock>& known_blocks, const MatrixXd& J,
                     const VectorXd& d, const std::vector<ErrorBlock>& blocks, double numerical_error, double& left) {
    MatrixXd stacked(known.rows() + J.rows(), J.cols());
    stacked.topRows(known.rows()) = known;
    stacked.bottomRows(J.rows()) = J;
    VectorXd difference = VectorXd::Zero(stacked.rows());
    // The existing trials show no difference: both rivals are fits to them.
    difference.tail(d.size()) = d;
    const VectorXd outside = statistics::NuisanceSpace(stacked).outside(difference);
    left = outside.tail(d.size()).norm();
    std::vector<ErrorBlock> all = known_blocks;
    for (const ErrorBlock& block : blocks) all.push_back({known.rows() + block.begin, block.size});
    return noncentrality(outside, all, numerical_error);
}

Result<Proposal> propose_trial(const ProposalTask& task, const Progress& progress) {
    const Stopwatch watch;
    const PlanningPolicy& policy = task.policy;
    std::vector<PossibleTrial> family = trial_family(task.setup, merged(task.setup.experiment.limits, task.limits),
                                                     policy.family);
    // Within a diagnosis the time is limited.
    if (task.most_trials) family = evenly(std::move(family), *task.most_trials);
    const Result<setup::Setup> whole = with_family(task, family, progress);
    if (!whole) return whole.error();
    Proposal proposal;
    proposal.rivals = {task.rivals[0].ids, task.rivals[1].ids};
    proposal.alpha = policy.detection.alpha;
    proposal.noise_m = setup::mean_noise(*whole);
    const double numerical_error = task.numerical_error_m ? *task.numerical_error_m / proposal.noise_m
                                                          : policy.detection.numerical_error;
    proposal.numerical_error_m = numerical_error * proposal.noise_m;
    // Tangents included, for the recalibration of each.
    const auto predictions = rival_predictions(*whole, task, family.size(), progress);
    if (progress.cancelled()) return Error{"stopped", ""};
    const std::size_t first = whole->trials.size() - family.size();
    for (std::size_t t = 0; t < family.size(); ++t)
        proposal.trials.push_back(rated(*whole, first + t, family[t], task, predictions[t], numerical_error));
    std::stable_sort(proposal.trials.begin(), proposal.trials.end(), [](const RatedTrial& a, const RatedTrial& b) {
        // Failed trials stand last; by noncentrality, since probabilities near 1 no longer differ.
        return a.failure.empty() != b.failure.empty() ? a.failure.empty() : a.noncentrality > b.noncentrality;
    });
    proposal.runs = static_cast<int>(2 * family.size());
    proposal.seconds = watch.seconds();
    return proposal;
}

}  // namespace myo::planning
