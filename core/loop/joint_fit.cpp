#include "loop/joint_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double prior_widths = 10.0;

StudyValues values_at(const std::vector<StudyParameter>& parameters, const VectorXd& p, StudyValues values) {
    for (std::size_t i = 0; i < parameters.size(); ++i) set_value(parameters[i], p(static_cast<Index>(i)), values);
    return values;
}

/// Rows (value - start) / deviation for the components of vectors.
void append_priors(const std::vector<StudyParameter>& parameters, const VectorXd& p, ResidualEvaluation& evaluation) {
    const Index rows = evaluation.residuals.size(), count = static_cast<Index>(parameters.size());
    std::vector<Index> held;
    for (Index i = 0; i < count; ++i)
        if (parameters[static_cast<std::size_t>(i)].component >= 0) held.push_back(i);
    evaluation.residuals.conservativeResize(rows + static_cast<Index>(held.size()));
    evaluation.jacobian.conservativeResize(evaluation.residuals.size(), count);
    for (std::size_t k = 0; k < held.size(); ++k) {
        const Parameter& parameter = parameters[static_cast<std::size_t>(held[k])].parameter;
        const double weight = 1.0 / (prior_widths * parameter.scale);
        const Index row = rows + static_cast<Index>(k);
        evaluation.residuals(row) = weight * (p(held[k]) - parameter.value);
        evaluation.jacobian.row(row).setZero();
        evaluation.jacobian(row, held[k]) = weight;
    }
}

/// Places stay on the body.
void bound_places(const Study& study, std::vector<StudyParameter>& parameters) {
    const Box body = bounding_box(study.surface.vertices);
    for (StudyParameter& p : parameters)
        if (p.of_effect == "position_m" || p.of_effect == "centre_m") {
            p.parameter.lower = body.lowest(p.component);
            p.parameter.upper = body.highest(p.component);
        }
}

/// A model that lacks an effect may need a modulus that the material cannot have; held at the edge of its tolerance, it would leave a residual
/// that the modulus takes away, and hide the effect's own. With an effect in, the modulus has to be what was declared.
void free_modulus(std::vector<StudyParameter>& parameters) {
    for (StudyParameter& p : parameters)
        if (p.kind == StudyParameter::Kind::youngs_modulus) {
            p.parameter.lower = 0.2 * p.parameter.value;
            p.parameter.upper = 5.0 * p.parameter.value;
        }
}

}  // namespace

std::vector<StudyParameter> joint_parameters(const Study& study, const StudyValues& start) {
    std::vector<StudyParameter> parameters = study_parameters(study);
    for (std::size_t e = study.experiment.effects.size(); e < start.effects.size(); ++e)
        for (StudyParameter& parameter : effect_study_parameters(start.effects[e], e)) parameters.push_back(std::move(parameter));
    bound_places(study, parameters);
    if (start.effects.size() == study.experiment.effects.size()) free_modulus(parameters);
    for (StudyParameter& p : parameters) p.parameter.value = std::clamp(value_of(p, start), p.parameter.lower, p.parameter.upper);
    return parameters;
}

JointFit joint_fit(const Study& study, const FitData& data, const StudyValues& start, const LeastSquaresOptions& options, const Progress& progress) {
    const Stopwatch watch;
    JointFit fit;
    fit.parameters = joint_parameters(study, start);
    fit.values = start;
    double least = std::numeric_limits<double>::infinity();
    int evaluations = 0;
    const auto evaluate = [&](const VectorXd& p, const Progress& inner) {
        ResidualEvaluation evaluation;
        // The solver counts steps, of which it may take back many.
        if (evaluations++ > options.max_evaluations) {
            evaluation.message = "no more evaluations are wanted";
            return evaluation;
        }
        StudyValues values = values_at(fit.parameters, p, start);
        std::vector<PredictionTask> tasks;
        for (const std::size_t trial : data.trials) tasks.push_back({trial, &values});
        std::vector<TrialPrediction> predictions = predict_trials(study, tasks, fit.parameters, inner);
        for (std::size_t i = 0; i < predictions.size(); ++i)
            if (!predictions[i].ok()) {
                evaluation.message = "trial " + study.trials[data.trials[i]].name + ": " + predictions[i].message;
                return evaluation;
            }
        evaluation.ok = true;
        evaluation.residuals = flat_residual(data, predictions);
        evaluation.jacobian = flat_jacobian(data, predictions, fit.parameters.size());
        const VectorXd residual = evaluation.residuals;
        const Eigen::MatrixXd jacobian = evaluation.jacobian;
        append_priors(fit.parameters, p, evaluation);
        if (evaluation.residuals.squaredNorm() < least && evaluation.jacobian.allFinite()) {
            least = evaluation.residuals.squaredNorm();
            fit.residual = residual;
            fit.jacobian = jacobian;
            fit.values = std::move(values);
            for (TrialPrediction& prediction : predictions) prediction.tangents.clear();
            fit.predictions = std::move(predictions);
        }
        return evaluation;
    };
    std::vector<Parameter> parameters;
    for (const StudyParameter& p : fit.parameters) parameters.push_back(p.parameter);
    fit.report = fit_least_squares(parameters, evaluate, options, progress);
    fit.effects.assign(fit.values.effects.begin() + static_cast<std::ptrdiff_t>(study.experiment.effects.size()), fit.values.effects.end());
    fit.seconds = watch.seconds();
    return fit;
}

}  // namespace myo
