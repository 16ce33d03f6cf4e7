#include "project/run_study.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "base/parallel.hpp"
#include "project/level_curve.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Joins the progress of trials that run side by side into one: seconds of simulated time done of all.
class JoinedProgress {
public:
    JoinedProgress(const Study& study, const std::vector<std::size_t>& trials, const Progress& outer) : outer_(outer), done_(study.trials.size(), 0.0) {
        for (const std::size_t t : trials) total_ += study.trials[t].options.end_s;
    }
    Progress of(std::size_t trial) {
        return outer_.with_sink([this, trial](const ProgressEvent& event) {
            const std::lock_guard<std::mutex> lock(mutex_);
            done_[trial] = event.done;
            double sum = 0.0;
            for (const double d : done_) sum += d;
            outer_.report({event.task, sum, total_, event.unit, event.message});
        });
    }

private:
    const Progress& outer_;
    std::mutex mutex_;
    std::vector<double> done_;
    double total_ = 0.0;
};

std::vector<TrialPrediction> predict(const Study& study, const StudyValues& values, const std::vector<StudyParameter>& parameters,
                                     const std::vector<std::size_t>& trials, const Progress& progress) {
    std::vector<TrialPrediction> predictions(study.trials.size());
    JoinedProgress joined(study, trials, progress);
    parallel_tasks(static_cast<int>(trials.size()), study.settings.threads, [&](int i) {
        const std::size_t t = trials[static_cast<std::size_t>(i)];
        predictions[t] = predict_trial(study, t, values, parameters, joined.of(t));
    });
    return predictions;
}

/// Residuals and Jacobian of the fit trials in units of the noise; occluded coordinates have residual 0.
ResidualEvaluation evaluate(const Study& study, const StudyValues& values, const std::vector<StudyParameter>& parameters,
                            const std::vector<std::size_t>& trials, const Progress& progress) {
    const std::vector<TrialPrediction> predictions = predict(study, values, parameters, trials, progress);
    ResidualEvaluation result;
    Eigen::Index rows = 0;
    for (const std::size_t t : trials) {
        if (!predictions[t].ok()) {
            result.message = "trial " + study.trials[t].name + ": " + predictions[t].message;
            return result;
        }
        rows += 3 * static_cast<Eigen::Index>(study.marker_names.size()) * study.trials[t].measured.sample_count();
    }
    result.residuals = Eigen::VectorXd::Zero(rows);
    result.jacobian = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(parameters.size()));
    Eigen::Index row = 0;
    for (const std::size_t t : trials)
        for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
            const double weight = 1.0 / study.noise_m(static_cast<Eigen::Index>(m));
            const Matrix3Xd& residual = predictions[t].residual_m[m];
            for (Eigen::Index k = 0; k < residual.size(); ++k, ++row) {
                if (!std::isfinite(residual.data()[k])) continue;
                result.residuals(row) = weight * residual.data()[k];
                for (std::size_t p = 0; p < parameters.size(); ++p)
                    result.jacobian(row, static_cast<Eigen::Index>(p)) = weight * predictions[t].tangents[p][m].data()[k];
            }
        }
    result.ok = true;
    return result;
}

double pooled_rms(const Study& study, const std::vector<TrialPrediction>& predictions, TrialRole role) {
    std::vector<Matrix3Xd> all;
    for (std::size_t t = 0; t < predictions.size(); ++t)
        if (study.trials[t].role == role && predictions[t].ok())
            all.insert(all.end(), predictions[t].residual_m.begin(), predictions[t].residual_m.end());
    return rms(all);
}

std::vector<std::size_t> trials_with_role(const Study& study, TrialRole role) {
    std::vector<std::size_t> list;
    for (std::size_t t = 0; t < study.trials.size(); ++t)
        if (study.trials[t].role == role) list.push_back(t);
    return list;
}

/// A condition that differs between the fit trials with a free level of this muscle, and that `trial` has too.
std::optional<std::string> telling_condition(const Study& study, std::size_t trial, const std::vector<std::size_t>& fit_trials) {
    for (const auto& [name, value] : study.experiment.trials[trial].condition) {
        bool everywhere = !fit_trials.empty();
        for (const std::size_t t : fit_trials) everywhere = everywhere && study.experiment.trials[t].condition.count(name) > 0;
        if (everywhere) return name;
    }
    return std::nullopt;
}

}  // namespace

TrialScore score(const Study& study, std::size_t trial, const TrialPrediction& prediction) {
    const StudyTrial& data = study.trials[trial];
    TrialScore result{data.name, data.role, rms(prediction.residual_m), {}};
    const Eigen::Index samples = data.measured.sample_count();
    const Eigen::Index first_steady = samples - std::max<Eigen::Index>(1, (samples - data.first_sample) / 5);
    const bool displacement = !data.reference_m.empty();
    for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
        MarkerScore marker;
        marker.name = study.marker_names[m];
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
        const double share = seen > 0 ? 1.0 / seen : std::numeric_limits<double>::quiet_NaN();
        marker.steady_measured_m = share * measured;
        marker.steady_simulated_m = share * (measured + error);
        marker.steady_error_m = (share * error).norm();
        result.markers.push_back(std::move(marker));
    }
    return result;
}

StudyRun run_study(const Study& study, const StudyValues& values, const Progress& progress, const std::string& only_trial) {
    const Clock::time_point start = Clock::now();
    std::vector<std::size_t> trials;
    for (std::size_t t = 0; t < study.trials.size(); ++t)
        if (only_trial.empty() || study.trials[t].name == only_trial) trials.push_back(t);
    StudyRun run;
    run.values = values;
    run.predictions = predict(study, values, {}, trials, progress);
    for (const std::size_t t : trials) {
        if (run.predictions[t].ok()) run.scores.push_back(score(study, t, run.predictions[t]));
        else if (run.failure.empty()) run.failure = "trial " + study.trials[t].name + ": " + run.predictions[t].message;
    }
    run.fit_rms_m = pooled_rms(study, run.predictions, TrialRole::fit);
    run.validation_rms_m = pooled_rms(study, run.predictions, TrialRole::validate);
    run.seconds = seconds_since(start);
    return run;
}

StudyValues with_predicted_levels(const Study& study, StudyValues values) {
    for (std::size_t v = 0; v < study.trials.size(); ++v) {
        if (study.trials[v].role == TrialRole::fit) continue;
        for (auto& [muscle, level] : values.levels[v]) {
            std::vector<std::size_t> sources;
            double mean = 0.0;
            for (const std::size_t t : trials_with_role(study, TrialRole::fit))
                if (values.levels[t].count(muscle) > 0) {
                    sources.push_back(t);
                    mean += values.levels[t].at(muscle);
                }
            if (sources.empty()) continue;
            level = mean / static_cast<double>(sources.size());
            const std::optional<std::string> condition = telling_condition(study, v, sources);
            if (!condition) continue;
            std::map<double, std::pair<double, int>> points;   // condition -> sum of levels, count
            for (const std::size_t t : sources) {
                auto& [sum, count] = points[study.experiment.trials[t].condition.at(*condition)];
                sum += values.levels[t].at(muscle);
                ++count;
            }
            std::vector<double> x, y;
            for (const auto& [at, point] : points) {
                x.push_back(at);
                y.push_back(point.first / point.second);
            }
            level = curve_through(x, y, study.experiment.trials[v].condition.at(*condition), 1.0);
        }
    }
    return values;
}

Calibration calibrate_study(const Study& study, const std::vector<std::string>& names, const Progress& progress) {
    const Clock::time_point start = Clock::now();
    Calibration result;
    result.parameters = study_parameters(study, names);
    std::vector<Parameter> parameters;
    for (const StudyParameter& p : result.parameters) parameters.push_back(p.parameter);
    const std::vector<std::size_t> fit_trials = trials_with_role(study, TrialRole::fit);
    const auto values_at = [&](const Eigen::VectorXd& p) {
        StudyValues values = declared_values(study);
        for (std::size_t i = 0; i < result.parameters.size(); ++i) set_value(result.parameters[i], p(static_cast<Eigen::Index>(i)), values);
        return values;
    };
    const Progress quiet = progress.with_sink({});   // one event per evaluation, not per step
    result.fit = fit_least_squares(
        parameters, [&](const Eigen::VectorXd& p, const Progress&) { return evaluate(study, values_at(p), result.parameters, fit_trials, quiet); }, {}, progress);
    if (result.fit.status == FitStatus::cancelled || result.fit.status == FitStatus::failed) {
        result.seconds = seconds_since(start);
        return result;
    }
    result.before = run_study(study, with_predicted_levels(study, declared_values(study)), quiet);
    result.after = run_study(study, with_predicted_levels(study, values_at(result.fit.values)), quiet);

    const MaterialDeclaration& material = study.experiment.material;
    const double relative = result.after.values.youngs_modulus_Pa / material.youngs_modulus_Pa - 1.0;
    if (std::abs(relative) > material.youngs_modulus_tolerance)
        result.warnings.push_back("material.youngs_modulus_Pa: the fitted value is " + std::to_string(std::lround(100.0 * relative)) +
                                  " % from the declared one, outside its tolerance of " +
                                  std::to_string(std::lround(100.0 * material.youngs_modulus_tolerance)) + " %; the model may lack an effect");
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const double value = result.fit.values(static_cast<Eigen::Index>(i));
        const double near = 1e-6 * parameters[i].scale;
        if (value < parameters[i].lower + near || value > parameters[i].upper - near)
            result.warnings.push_back(parameters[i].name + ": the fit ended at a bound");
    }
    result.seconds = seconds_since(start);
    return result;
}

}  // namespace myo
