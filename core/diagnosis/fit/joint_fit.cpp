#include "diagnosis/fit/joint_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "diagnosis/fit/sensor_rows.hpp"
#include "effect/catalogue.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The values with the parameters at p, in the order of `parameters`.
prediction::ParameterValues values_at(const std::vector<prediction::ModelParameter>& parameters, const VectorXd& p,
                                      prediction::ParameterValues values) {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        prediction::set_value(parameters[i], p(static_cast<Index>(i)), values);
    return values;
}

/// Prior of the components of vectors: rows (value - start) / deviation appended to residuals and Jacobian.
struct Priors {
    std::vector<Index> of;  // indices of the parameters
    VectorXd weight, start;

    Priors(const std::vector<prediction::ModelParameter>& parameters, double widths) {
        for (std::size_t i = 0; i < parameters.size(); ++i)
            if (parameters[i].component >= 0) of.push_back(static_cast<Index>(i));
        weight.resize(size());
        start.resize(size());
        for (Index k = 0; k < size(); ++k) {
            const inverse::Parameter& p = parameters[static_cast<std::size_t>(of[static_cast<std::size_t>(k)])]
                                              .parameter;
            weight(k) = 1.0 / (widths * p.scale);
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

/// Bounds masses to a multiple of the body's.
void bound_masses(const setup::Setup& setup, double max_mass_ratio,
                  std::vector<prediction::ModelParameter>& parameters) {
    const double body_kg = setup.experiment.material.density_kg_m3 * setup.body->volume_m3;
    for (prediction::ModelParameter& p : parameters)
        if (p.of_effect == "mass_kg") p.parameter.upper = max_mass_ratio * body_kg;
}

/// Residuals and derivatives of all trials. Keeps the last predictions, which the derivatives need.
class Residuals {
public:
    Residuals(const FitTask& task, JointFit& fit)
        : setup_(task.setup),
          data_(task.data),
          start_(task.start),
          max_evaluations_(task.effort.evaluations),
          fit_(fit),
          policy_(task.policy.declared),
          priors_(fit.parameters, task.policy.declared.prior_widths),
          warm_paths_(task.warm.paths) {}

    /// Residual at p: markers, sensors, priors, in this order. Enters the best evaluation into the fit. Not ok if a
    /// trial cannot be run, or if the evaluations are used up.
    inverse::ResidualEvaluation evaluate(const VectorXd& p, const Progress& progress) {
        // Solver and jacobian() ask for the same point in turn.
        if (last_at_.size() > 0 && p == last_at_ && last_.ok) return last_;
        inverse::ResidualEvaluation evaluation;
        // Also limits the evaluations made by jacobian(), which the solver does not count.
        if (evaluations_++ > max_evaluations_) {
            evaluation.message = "no more evaluations are wanted";
            return evaluation;
        }
        const prediction::ParameterValues values = values_at(fit_.parameters, p, start_);
        std::vector<prediction::PredictionTask> tasks;
        for (std::size_t i = 0; i < data_.trials.size(); ++i)
            tasks.push_back({data_.trials[i], &values, i < warm_paths_.size() ? warm_paths_[i] : nullptr});
        predictions_ = prediction::predict_trials(setup_, tasks, {}, progress);
        last_at_ = p;
        for (std::size_t i = 0; i < predictions_.size(); ++i)
            if (!predictions_[i].ok()) {
                evaluation.message = "trial " + setup_.trials[data_.trials[i]].name + ": " + predictions_[i].message;
                last_ = evaluation;
                return evaluation;
            }
        evaluation.ok = true;
        const VectorXd residual = flat_residual(data_, predictions_);
        const VectorXd of_sensors = sensor_rows(setup_, data_.trials, predictions_, policy_);
        // Priors are rows of the problem but not part of the fit's residual, which states the misfit to data only.
        evaluation.residuals.resize(residual.size() + of_sensors.size() + priors_.size());
        evaluation.residuals << residual, of_sensors, priors_.residual(p);
        // The fit is that of the least cost, even if the solver ends elsewhere or is stopped.
        if (evaluation.residuals.squaredNorm() < least_) {
            least_ = evaluation.residuals.squaredNorm();
            fit_.residual = residual;
            fit_.sensor_residual = of_sensors;
            fit_.values = values;
            fit_.predictions = predictions_;
            warm_paths_.clear();
            // The next runs start from the stages of the best one, which saves iterations.
            for (const prediction::TrialPrediction& prediction : predictions_)
                warm_paths_.push_back(prediction.trace.path);
        }
        last_ = evaluation;
        return evaluation;
    }

    /// Jacobian at p. Known columns are taken over; the others are computed by runs of all trials in parallel. Empty if
    /// the model could not be run.
    MatrixXd jacobian(const VectorXd& p, const WarmStart& warm, const Progress& progress) {
        if (last_at_.size() == 0 || p != last_at_) evaluate(p, progress);
        if (!last_.ok) return {};
        const prediction::ParameterValues values = values_at(fit_.parameters, p, start_);
        const auto count = static_cast<Index>(fit_.parameters.size());
        MatrixXd J(last_.residuals.size(), count);
        // Rows of priors are exact and cheap; known columns belong to markers and sensors only.
        J.bottomRows(priors_.size()) = priors_.jacobian(count);
        const Index known = last_.residuals.size() - priors_.size();
        std::vector<Index> wanted;
        for (Index i = 0; i < count; ++i) {
            const auto found = std::find(warm.names.begin(), warm.names.end(),
                                         fit_.parameters[static_cast<std::size_t>(i)].parameter.name);
            if (found == warm.names.end())
                wanted.push_back(i);
            else
                J.col(i).head(known) = warm.columns.col(found - warm.names.begin());
        }
        std::vector<prediction::ModelParameter> sought;
        for (const Index i : wanted) sought.push_back(fit_.parameters[static_cast<std::size_t>(i)]);
        const MatrixXd columns = slopes(values, sought, known, progress);
        if (columns.cols() < static_cast<Index>(wanted.size())) return {};
        for (std::size_t k = 0; k < wanted.size(); ++k)
            J.col(wanted[k]).head(known) = columns.col(static_cast<Index>(k));
        return J;
    }

private:
    /// Derivatives of markers and sensors, rows x parameters; empty if the model could not be run.
    MatrixXd slopes(const prediction::ParameterValues& values,
                    const std::vector<prediction::ModelParameter>& parameters, Index rows,
                    const Progress& progress) const {
        std::vector<prediction::PredictionTask> tasks;
        for (std::size_t t = 0; t < data_.trials.size(); ++t)
            tasks.push_back({data_.trials[t], &values, predictions_[t].trace.path});
        const std::vector<prediction::TrialPrediction> runs = prediction::predict_trials(setup_, tasks, parameters,
                                                                                         progress);
        if (!prediction::all_ok(runs)) return {};
        MatrixXd columns(rows, static_cast<Index>(parameters.size()));
        columns.topRows(data_.layout.size()) = flat_jacobian(data_, runs, parameters.size());
        for (std::size_t k = 0; k < parameters.size(); ++k)
            columns.col(static_cast<Index>(k)).tail(rows - data_.layout.size()) = sensor_slope(setup_, data_.trials,
                                                                                               runs, k, policy_);
        return columns;
    }

    const setup::Setup& setup_;
    const FitData& data_;
    const prediction::ParameterValues& start_;
    int max_evaluations_;
    JointFit& fit_;
    const DeclaredFitPolicy& policy_;
    Priors priors_;
    std::vector<std::shared_ptr<const dynamics::StagePath>> warm_paths_;  // paths of the best evaluation so far
    double least_ = std::numeric_limits<double>::infinity();
    int evaluations_ = 0;
    VectorXd last_at_;
    inverse::ResidualEvaluation last_;                      // at last_at_
    std::vector<prediction::TrialPrediction> predictions_;  // at last_at_
};

/// Options of the solver from the effort of the task and the policy.
inverse::LeastSquaresOptions options_of(const FitTask& task) {
    inverse::LeastSquaresOptions options;
    options.max_evaluations = task.effort.evaluations;
    options.relative_decrease = task.effort.relative_decrease;
    options.max_jacobians = task.effort.max_jacobians;
    options.relative_step = task.policy.fits.relative_step;
    return options;
}

}  // namespace

std::vector<prediction::ModelParameter> joint_parameters(const setup::Setup& setup,
                                                         const prediction::ParameterValues& start,
                                                         const DeclaredFitPolicy& policy, EffectFreedom freedom) {
    std::vector<prediction::ModelParameter> parameters = prediction::free_parameters(setup);
    // Declared effects come first in the start; their parameters are among those of the experiment.
    for (std::size_t e = setup.experiment.effects.size(); e < start.effects.size(); ++e) {
        std::vector<prediction::ModelParameter> own = prediction::effect_parameters(setup, start.effects[e], e);
        if (freedom == EffectFreedom::amount && !own.empty())
            std::erase_if(own, [amount = own.front().of_effect](const prediction::ModelParameter& p) {
                return p.of_effect != amount;
            });
        for (prediction::ModelParameter& parameter : own) parameters.push_back(std::move(parameter));
    }
    bound_masses(setup, policy.max_mass_ratio, parameters);
    for (prediction::ModelParameter& p : parameters)
        p.parameter.value = std::clamp(prediction::value_of(p, start), p.parameter.lower, p.parameter.upper);
    return parameters;
}

MatrixXd all_slopes(const JointFit& fit) {
    MatrixXd J(fit.jacobian.rows() + fit.sensor_jacobian.rows(), fit.jacobian.cols());
    J.topRows(fit.jacobian.rows()) = fit.jacobian;
    if (fit.sensor_jacobian.rows() > 0) J.bottomRows(fit.sensor_jacobian.rows()) = fit.sensor_jacobian;
    return J;
}

WarmStart warm_start_of(const JointFit& fit) {
    WarmStart warm;
    for (const prediction::ModelParameter& p : fit.parameters) warm.names.push_back(p.parameter.name);
    warm.columns = all_slopes(fit);
    for (const prediction::TrialPrediction& prediction : fit.predictions) warm.paths.push_back(prediction.trace.path);
    return warm;
}

double change_between(const JointFit& a, const JointFit& b) {
    VectorXd step(static_cast<Index>(b.parameters.size()));
    for (std::size_t i = 0; i < b.parameters.size(); ++i)
        step(static_cast<Index>(i)) = prediction::value_of(b.parameters[i], b.values) -
                                      prediction::value_of(b.parameters[i], a.values);
    return (b.jacobian * step).norm() / std::sqrt(static_cast<double>(std::max<Index>(1, b.residual.size())));
}

JointFit joint_fit(const FitTask& task, const Progress& progress) {
    const Stopwatch watch;
    const setup::Setup& setup = task.setup;
    JointFit fit;
    fit.parameters = joint_parameters(setup, task.start, task.policy.declared, task.freedom);
    fit.values = task.start;
    Residuals residuals(task, fit);
    std::vector<inverse::Parameter> parameters;
    for (const prediction::ModelParameter& p : fit.parameters) parameters.push_back(p.parameter);
    VectorXd origin(static_cast<Index>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i) origin(static_cast<Index>(i)) = parameters[i].value;
    inverse::LeastSquaresOptions options = options_of(task);
    if (!task.warm.names.empty()) options.jacobian_guess = residuals.jacobian(origin, task.warm, progress);
    fit.report = inverse::fit_by_secants(
        parameters, [&](const VectorXd& p, const Progress& inner) { return residuals.evaluate(p, inner); },
        [&](const VectorXd& p, const inverse::ResidualEvaluation&, const Progress& inner) {
            return residuals.jacobian(p, {}, inner);
        },
        options, progress);
    // The report has no Jacobian if the start could not be run or the computation of derivatives failed.
    if (fit.report.jacobian.rows() < fit.residual.size() + fit.sensor_residual.size())
        fit.residual.resize(0);  // no Jacobian, so the fit cannot be assessed
    if (fit.usable()) {
        fit.jacobian = fit.report.jacobian.topRows(fit.residual.size());
        fit.sensor_jacobian = fit.report.jacobian.middleRows(fit.residual.size(), fit.sensor_residual.size());
    }
    // Different numbers may mean one effect (a direction and its opposite); the canonical ones are reported and stored.
    for (std::size_t e = setup.experiment.effects.size(); e < fit.values.effects.size(); ++e) {
        effect::EffectDeclaration& tried = fit.values.effects[e];
        if (const effect::Effect* const effect = effect::find_effect(tried); effect && effect->canonical)
            tried.parameters = effect->canonical(setup.trials.front().model, tried.parameters);
    }
    fit.effects.assign(fit.values.effects.begin() + static_cast<std::ptrdiff_t>(setup.experiment.effects.size()),
                       fit.values.effects.end());
    fit.seconds = watch.seconds();
    return fit;
}

}  // namespace myo::diagnosis
