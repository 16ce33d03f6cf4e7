#include "loop/joint_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double prior_widths = 10.0;

StudyValues values_at(const std::vector<StudyParameter>& parameters, const VectorXd& p, StudyValues values) {
    for (std::size_t i = 0; i < parameters.size(); ++i) set_value(parameters[i], p(static_cast<Index>(i)), values);
    return values;
}

/// Rows (value - start) / deviation for the components of vectors: what they add to residuals and Jacobian.
struct Priors {
    std::vector<Index> of;    // parameters
    VectorXd weight, start;

    explicit Priors(const std::vector<StudyParameter>& parameters) {
        for (std::size_t i = 0; i < parameters.size(); ++i)
            if (parameters[i].component >= 0) of.push_back(static_cast<Index>(i));
        weight.resize(size());
        start.resize(size());
        for (Index k = 0; k < size(); ++k) {
            const Parameter& p = parameters[static_cast<std::size_t>(of[static_cast<std::size_t>(k)])].parameter;
            weight(k) = 1.0 / (prior_widths * p.scale);
            start(k) = p.value;
        }
    }
    Index size() const { return static_cast<Index>(of.size()); }
    VectorXd residual(const VectorXd& p) const { return weight.cwiseProduct(VectorXd(p(of)) - start); }
    MatrixXd jacobian(Index parameters) const {
        MatrixXd J = MatrixXd::Zero(size(), parameters);
        for (Index k = 0; k < size(); ++k) J(k, of[static_cast<std::size_t>(k)]) = weight(k);
        return J;
    }
};

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
    const Priors priors(fit.parameters);
    const auto count = static_cast<Index>(fit.parameters.size());
    double least = std::numeric_limits<double>::infinity();
    int evaluations = 0;
    std::vector<TrialPrediction> last;   // of the last evaluation
    VectorXd last_at;
    const auto evaluate = [&](const VectorXd& p, const Progress& inner) {
        ResidualEvaluation evaluation;
        // The solver counts steps, of which it may take back many.
        if (evaluations++ > options.max_evaluations) {
            evaluation.message = "no more evaluations are wanted";
            return evaluation;
        }
        const StudyValues values = values_at(fit.parameters, p, start);
        std::vector<PredictionTask> tasks;
        for (const std::size_t trial : data.trials) tasks.push_back({trial, &values});
        last = predict_trials(study, tasks, {}, inner);
        last_at = p;
        for (std::size_t i = 0; i < last.size(); ++i)
            if (!last[i].ok()) {
                evaluation.message = "trial " + study.trials[data.trials[i]].name + ": " + last[i].message;
                return evaluation;
            }
        evaluation.ok = true;
        const VectorXd residual = flat_residual(data, last);
        evaluation.residuals.resize(residual.size() + priors.size());
        evaluation.residuals << residual, priors.residual(p);
        if (evaluation.residuals.squaredNorm() < least) {
            least = evaluation.residuals.squaredNorm();
            fit.residual = residual;
            fit.values = values;
            fit.predictions = last;
        }
        return evaluation;
    };
    const auto derive = [&](const VectorXd& p, const ResidualEvaluation&, const Progress& inner) -> MatrixXd {
        const StudyValues values = values_at(fit.parameters, p, start);
        if (p != last_at) {
            std::vector<PredictionTask> again;
            for (const std::size_t trial : data.trials) again.push_back({trial, &values});
            last = predict_trials(study, again, {}, inner);
            last_at = p;
        }
        const auto trials = data.trials.size();
        std::vector<ResidualTangent> tangents(trials * fit.parameters.size());
        parallel_tasks(static_cast<int>(tangents.size()), study.settings.threads, [&](int task) {
            const auto k = static_cast<std::size_t>(task);
            tangents[k] = residual_tangent(study, data.trials[k % trials], values, fit.parameters[k / trials], last[k % trials], inner);
        });
        MatrixXd J(fit.residual.size() + priors.size(), count);
        for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
            std::vector<const ResidualTangent*> of_trials;
            for (std::size_t t = 0; t < trials; ++t) {
                of_trials.push_back(&tangents[i * trials + t]);
                if (!of_trials.back()->ok()) return {};
            }
            J.col(static_cast<Index>(i)).head(fit.residual.size()) = flat_tangent(data, of_trials);
        }
        J.bottomRows(priors.size()) = priors.jacobian(count);
        return J;
    };
    std::vector<Parameter> parameters;
    for (const StudyParameter& p : fit.parameters) parameters.push_back(p.parameter);
    fit.report = fit_least_squares(parameters, evaluate, derive, options, progress);
    if (fit.usable()) fit.jacobian = fit.report.jacobian.topRows(fit.residual.size());
    fit.effects.assign(fit.values.effects.begin() + static_cast<std::ptrdiff_t>(study.experiment.effects.size()), fit.values.effects.end());
    fit.seconds = watch.seconds();
    return fit;
}

}  // namespace myo
