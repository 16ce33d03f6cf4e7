#include "project/calibrate_study.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

/// Residuals and Jacobian of the fit trials in units of the noise; occluded coordinates have residual 0.
///
/// @param predictions  of the trials, in their order
ResidualEvaluation weighted_residuals(const Study& study, const std::vector<std::size_t>& trials, const std::vector<TrialPrediction>& predictions,
                                      std::size_t parameters) {
    ResidualEvaluation result;
    Eigen::Index rows = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const StudyTrial& trial = study.trials[trials[i]];
        if (!predictions[i].ok()) {
            result.message = "trial " + trial.name + ": " + predictions[i].message;
            return result;
        }
        rows += 3 * static_cast<Eigen::Index>(study.marker_names.size()) * trial.measured.sample_count();
    }
    result.residuals = Eigen::VectorXd::Zero(rows);
    result.jacobian = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(parameters));
    Eigen::Index row = 0;
    for (const TrialPrediction& prediction : predictions)
        for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
            const double weight = 1.0 / study.noise_m(static_cast<Eigen::Index>(m));
            const Matrix3Xd& residual = prediction.residual_m[m];
            for (Eigen::Index k = 0; k < residual.size(); ++k, ++row) {
                if (!std::isfinite(residual.data()[k])) continue;
                result.residuals(row) = weight * residual.data()[k];
                for (std::size_t p = 0; p < parameters; ++p)
                    result.jacobian(row, static_cast<Eigen::Index>(p)) = weight * prediction.tangents[p][m].data()[k];
            }
        }
    result.ok = true;
    return result;
}

/// All nodes at all steps are most of a prediction's memory, and only the run after the fit is shown in motion.
TrialPrediction markers_only(const TrialPrediction& full) {
    return {full.status, full.message, {}, full.positions_m, full.start_m, full.residual_m, {}};
}

/// Predictions of the fit trials that are worth keeping of all that the fit asks for: at the start, and with the least cost.
struct KeptPredictions {
    std::vector<TrialPrediction> first, best;
    double least_cost = std::numeric_limits<double>::infinity();

    void offer(std::vector<TrialPrediction> predictions, double cost) {
        if (first.empty())
            for (const TrialPrediction& prediction : predictions) first.push_back(markers_only(prediction));
        if (!(cost < least_cost)) return;
        least_cost = cost;
        for (TrialPrediction& prediction : predictions) prediction.tangents.clear();
        best = std::move(predictions);
    }
};

/// The runs before and after: the fit trials as the fit has run them, the validation trials run now. Cancelled, nothing is run.
void set_runs(const Study& study, const StudyValues& declared, const StudyValues& fitted, KeptPredictions kept, const Progress& progress,
              Calibration& result) {
    const std::vector<std::size_t> fit = trials_with_role(study, TrialRole::fit), validation = trials_with_role(study, TrialRole::validate);
    std::vector<TrialPrediction> before(study.trials.size()), after(study.trials.size());
    for (std::size_t i = 0; i < fit.size(); ++i) {
        before[fit[i]] = std::move(kept.first[i]);
        after[fit[i]] = std::move(kept.best[i]);
    }
    std::vector<PredictionTask> tasks;
    for (const std::size_t t : validation) tasks.push_back({t, &declared});
    for (const std::size_t t : validation) tasks.push_back({t, &fitted});
    std::vector<TrialPrediction> predicted(tasks.size(), {RunStatus::cancelled, "stopped by the user", {}, {}, {}, {}, {}});
    if (!progress.cancelled()) predicted = predict_trials(study, tasks, {}, progress);
    for (std::size_t i = 0; i < validation.size(); ++i) {
        before[validation[i]] = markers_only(predicted[i]);
        after[validation[i]] = std::move(predicted[validation.size() + i]);
    }
    for (const TrialPrediction& prediction : after) result.stopped = result.stopped || prediction.status == RunStatus::cancelled;
    for (const TrialPrediction& prediction : before) result.stopped = result.stopped || prediction.status == RunStatus::cancelled;

    std::vector<std::size_t> all(study.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    result.before = scored_run(study, declared, std::move(before), all);
    result.after = scored_run(study, fitted, std::move(after), all);
}

std::vector<std::string> calibration_warnings(const Study& study, const Calibration& calibration) {
    std::vector<std::string> warnings;
    const LeastSquaresReport& fit = calibration.fit;
    const auto name = [&](Eigen::Index i) { return calibration.parameters[static_cast<std::size_t>(i)].parameter.name; };
    for (Eigen::Index i = 0; i < fit.deviations.size(); ++i) {
        const Parameter& parameter = calibration.parameters[static_cast<std::size_t>(i)].parameter;
        if (!std::isfinite(fit.deviations(i))) warnings.push_back(name(i) + ": the data do not determine it");
        else if (fit.deviations(i) > 0.5 * (parameter.upper - parameter.lower))
            warnings.push_back(name(i) + ": the data tell less of it than its bounds do (± " + format_number(fit.deviations(i), 2) + ")");
        for (Eigen::Index j = 0; j < i; ++j)
            if (std::abs(fit.correlation(i, j)) > 0.999)
                warnings.push_back(name(j) + " and " + name(i) + ": these trials cannot tell them apart (correlation " + format_number(fit.correlation(i, j), 6) + ")");
    }
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const Parameter& parameter = calibration.parameters[i].parameter;
        const double value = fit.values(static_cast<Eigen::Index>(i));
        const double near = 1e-6 * parameter.scale;
        if (value > parameter.lower + near && value < parameter.upper - near) continue;
        if (calibration.parameters[i].kind == StudyParameter::Kind::youngs_modulus)
            warnings.push_back("material.youngs_modulus_Pa: the fit ended at the edge of the declared tolerance of " +
                               std::to_string(std::lround(100.0 * study.experiment.material.youngs_modulus_tolerance)) +
                               " %; the model may lack an effect, or material.youngs_modulus_tolerance is too narrow");
        else
            warnings.push_back(parameter.name + ": the fit ended at a bound");
    }
    if (calibration.stopped) return warnings;   // what is missing is the user's wish
    if (!calibration.before.ok()) warnings.push_back("with the declared values a prediction failed: " + calibration.before.failure);
    if (!calibration.after.ok()) warnings.push_back("with the fitted values a prediction failed: " + calibration.after.failure);
    return warnings;
}

}  // namespace

Calibration calibrate_study(const Study& study, const std::vector<std::string>& names, const Progress& progress) {
    const Stopwatch watch;
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
    KeptPredictions kept;
    const auto residuals = [&](const Eigen::VectorXd& p, const Progress& inner) {
        const StudyValues values = values_at(p);
        std::vector<PredictionTask> tasks;
        for (const std::size_t t : fit_trials) tasks.push_back({t, &values});
        std::vector<TrialPrediction> predictions = predict_trials(study, tasks, result.parameters, inner);
        ResidualEvaluation evaluation = weighted_residuals(study, fit_trials, predictions, result.parameters.size());
        if (evaluation.ok) kept.offer(std::move(predictions), evaluation.residuals.squaredNorm());
        return evaluation;
    };
    result.fit = fit_least_squares(parameters, residuals, {}, progress);
    result.stopped = result.fit.status == FitStatus::cancelled;
    if (result.usable()) {
        set_runs(study, with_predicted_levels(study, declared_values(study)), with_predicted_levels(study, values_at(result.fit.values)),
                 std::move(kept), progress, result);
        result.warnings = calibration_warnings(study, result);
    }
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo
