#include "prediction/run_trials.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "base/stopwatch.hpp"
#include "prediction/level_curve.hpp"
#include "prediction/predict_trials.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::prediction {
namespace {

using Eigen::Matrix3Xd;

/// Root mean square over all trials of one role. NaN if one of them failed: a value over fewer trials would not be
/// comparable with other runs.
double pooled_rms(const setup::Setup& setup, const SetupRun& run, const std::vector<std::size_t>& trials,
                  experiment::TrialRole role) {
    std::vector<Matrix3Xd> all;
    for (const std::size_t t : trials) {
        if (setup.trials[t].role != role) continue;
        if (!run.predictions[t].ok()) return std::numeric_limits<double>::quiet_NaN();
        all.insert(all.end(), run.predictions[t].residual_m.begin(), run.predictions[t].residual_m.end());
    }
    return rms(all);
}

/// Mean distance of prediction and measurement over the compared samples [m]; NaN if there are none.
double mean_distance(const Matrix3Xd& residual_m) {
    double sum = 0.0, count = 0.0;
    for (const auto& difference : residual_m.colwise())
        if (difference.allFinite()) sum += difference.norm(), ++count;
    return sum / count;
}

/// A test condition that `trial` and all these fit trials have in common, over which levels can be interpolated.
std::optional<std::string> telling_condition(const setup::Setup& setup, std::size_t trial,
                                             const std::vector<std::size_t>& fit_trials) {
    for (const auto& [name, value] : setup.experiment.trials[trial].condition) {
        bool everywhere = !fit_trials.empty();
        for (const std::size_t t : fit_trials)
            everywhere = everywhere && setup.experiment.trials[t].condition.count(name) > 0;
        if (everywhere) return name;
    }
    return std::nullopt;
}

}  // namespace

TrialScore score(const setup::Setup& setup, std::size_t trial, const TrialPrediction& prediction) {
    const setup::PreparedTrial& data = setup.trials[trial];
    TrialScore result{data.name, data.role, rms(prediction.residual_m), {}, 0.0};
    const Eigen::Index samples = data.measured.sample_count();
    // Last fifth of the compared samples, at least one.
    const Eigen::Index first_steady = samples - std::max<Eigen::Index>(1, (samples - data.first_sample) / 5);
    const bool displacement = !data.reference_m.empty();
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
        MarkerScore marker;
        marker.name = setup.marker_names[m];
        marker.rms_m = rms({prediction.residual_m[m]});
        Eigen::Vector3d measured = Eigen::Vector3d::Zero(), error = Eigen::Vector3d::Zero();
        int seen = 0;
        for (Eigen::Index t = first_steady; t < samples; ++t) {
            if (!prediction.residual_m[m].col(t).allFinite()) continue;
            Eigen::Vector3d y = data.measured.tracks[m].col(t);
            if (displacement) y -= data.reference_m[m];
            measured += y;
            error += prediction.residual_m[m].col(t);
            ++seen;
        }
        // The mean over visible samples only; NaN if the marker was never visible in the steady part.
        const double share = seen > 0 ? 1.0 / seen : std::numeric_limits<double>::quiet_NaN();
        marker.steady_measured_m = share * measured;
        marker.steady_simulated_m = share * (measured + error);
        marker.steady_error_m = (share * error).norm();
        marker.distance_m = mean_distance(prediction.residual_m[m]);
        result.markers.push_back(std::move(marker));
    }
    double sum = 0.0, count = 0.0;
    for (const MarkerScore& marker : result.markers)
        if (std::isfinite(marker.distance_m)) sum += marker.distance_m, ++count;
    result.distance_m = sum / count;
    for (std::size_t s = 0; s < prediction.sensor_residuals.size(); ++s) {
        const setup::SensorSeries& series = data.sensors[s];
        double squares = 0.0, readings = 0.0;
        for (const double r : prediction.sensor_residuals[s])
            if (std::isfinite(r)) squares += r * r, ++readings;
        result.sensors.push_back({series.column, series.unit, series.noise, std::sqrt(squares / readings)});
    }
    return result;
}

SetupRun scored_run(const setup::Setup& setup, const ParameterValues& values, std::vector<TrialPrediction> predictions,
                    const std::vector<std::size_t>& trials) {
    SetupRun run;
    run.values = values;
    run.predictions = std::move(predictions);
    for (const std::size_t t : trials) {
        if (run.predictions[t].ok())
            run.scores.push_back(score(setup, t, run.predictions[t]));
        else if (run.failure.empty())
            run.failure = "trial " + setup.trials[t].name + ": " + run.predictions[t].message;
    }
    run.fit_rms_m = pooled_rms(setup, run, trials, experiment::TrialRole::fit);
    run.validation_rms_m = pooled_rms(setup, run, trials, experiment::TrialRole::validate);
    return run;
}

SetupRun run_trials(const setup::Setup& setup, const ParameterValues& values, const Progress& progress,
                    const std::string& only_trial) {
    const Stopwatch watch;
    std::vector<std::size_t> trials;
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        if (only_trial.empty() || setup.trials[t].name == only_trial) trials.push_back(t);
    std::vector<TrialPrediction> done = predict_trials_with(setup, values, trials, progress);
    // Trials that were not requested keep the status not_run, so that indices match the setup.
    std::vector<TrialPrediction> predictions(setup.trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) predictions[trials[i]] = std::move(done[i]);
    SetupRun run = scored_run(setup, values, std::move(predictions), trials);
    run.seconds = watch.seconds();
    return run;
}

ParameterValues with_predicted_levels(const setup::Setup& setup, ParameterValues values) {
    for (std::size_t v = 0; v < setup.trials.size(); ++v) {
        if (setup.trials[v].role == experiment::TrialRole::fit) continue;
        for (auto& [actuator, level] : values.levels[v]) {
            std::vector<std::size_t> sources;
            double mean = 0.0;
            for (const std::size_t t : trials_with_role(setup, experiment::TrialRole::fit))
                if (values.levels[t].count(actuator) > 0) {
                    sources.push_back(t);
                    mean += values.levels[t].at(actuator);
                }
            if (sources.empty()) continue;
            // Fallback if no shared condition exists: the mean level.
            level = mean / static_cast<double>(sources.size());
            const std::optional<std::string> condition = telling_condition(setup, v, sources);
            if (!condition) continue;
            // Repeated conditions are averaged: the interpolation needs distinct abscissae. Its value at 0 is
            // passive.
            std::map<double, std::pair<double, int>> points;  // condition -> sum of levels, count
            for (const std::size_t t : sources) {
                auto& [sum, count] = points[setup.experiment.trials[t].condition.at(*condition)];
                sum += values.levels[t].at(actuator);
                ++count;
            }
            std::vector<double> x, y;
            for (const auto& [at, point] : points) {
                x.push_back(at);
                y.push_back(point.first / point.second);
            }
            level = curve_through(x, y, setup.experiment.trials[v].condition.at(*condition),
                                  setup::passive_level(setup.experiment, actuator));
        }
    }
    return values;
}

}  // namespace myo::prediction
