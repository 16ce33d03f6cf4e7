#include "calibration/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "calibration/values_at_bounds.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/runnable_start.hpp"
#include "prediction/weighted_residuals.hpp"

namespace myo::calibration {
namespace {

using Eigen::Matrix3Xd;

/// Copy without node positions, which dominate the memory; only the run after the fit is displayed in motion.
prediction::TrialPrediction markers_only(const prediction::TrialPrediction& full) {
    return {full.status, full.message, {}, full.positions_m, full.start_m, full.residual_m, {}, full.sensor_residuals};
}

/// Predictions kept out of all evaluations of a fit: with the declared values, and with the lowest cost.
struct KeptPredictions {
    std::vector<prediction::TrialPrediction> first, best;
    double min_cost = std::numeric_limits<double>::infinity();

    /// Stores the markers of predictions with the declared values, once.
    void keep_declared(const std::vector<prediction::TrialPrediction>& predictions) {
        if (!first.empty()) return;
        for (const prediction::TrialPrediction& prediction : predictions) first.push_back(markers_only(prediction));
    }
    /// Stores the predictions if they have the lowest cost so far; returns whether they do.
    bool offer(std::vector<prediction::TrialPrediction> predictions, double cost) {
        if (!(cost < min_cost)) return false;
        min_cost = cost;
        best = std::move(predictions);
        return true;
    }
};

/// Root mean square of all compared marker coordinates [m]; occluded ones do not count.
double rms_of(const std::vector<prediction::TrialPrediction>& predictions) {
    std::vector<Matrix3Xd> all;
    for (const prediction::TrialPrediction& prediction : predictions)
        all.insert(all.end(), prediction.residual_m.begin(), prediction.residual_m.end());
    return prediction::rms(all);
}

/// Residuals and Jacobians of the fit trials as functions of the parameter vector.
class FitRuns {
public:
    FitRuns(const setup::Setup& setup, const CalibrationSettings& settings,
            const std::vector<prediction::ModelParameter>& parameters)
        : setup_(prediction::with_kept_paths(setup)),
          settings_(settings),
          parameters_(parameters),
          trials_(prediction::trials_with_role(setup, experiment::TrialRole::fit)),
          declared_(prediction::declared_values(setup)) {}

    const std::vector<std::size_t>& trials() const { return trials_; }

    prediction::ParameterValues values_at(const Eigen::VectorXd& p) const {
        prediction::ParameterValues values = declared_;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            prediction::set_value(parameters_[i], p(static_cast<Eigen::Index>(i)), values);
        return values;
    }

    /// Weighted residuals at p; keeps the predictions if they are the best so far and informs the listener.
    inverse::ResidualEvaluation residuals(const Eigen::VectorXd& p, const Progress& progress) {
        prediction::ParameterValues values = values_at(p);
        std::vector<prediction::TrialPrediction> predictions = run(values, {}, progress);
        if (prediction::all_ok(predictions)) {
            // Before the markers are moved to their probable places: the report shows the declared model as it is
            // declared.
            if (is_declared(p)) kept_.keep_declared(predictions);
            predictions = prediction::at_probable_places(setup_, trials_, values, std::move(predictions));
            evaluated_at_ = p;
            places_m_ = values.places_m;
        }
        inverse::ResidualEvaluation evaluation = prediction::weighted_residuals(setup_, trials_, predictions, 0);
        // Computed for the listener only, as it passes over all residuals.
        const double rms_m = settings_.evaluated && evaluation.ok ? rms_of(predictions) : 0.0;
        const bool best = evaluation.ok && kept_.offer(std::move(predictions), evaluation.residuals.squaredNorm());
        tell(values, evaluation, rms_m, best);
        return evaluation;
    }

    /// Jacobian at p, from the tangents of a new run with the markers at their most probable places.
    Eigen::MatrixXd jacobian(const Eigen::VectorXd& p, const Progress& progress) {
        prediction::ParameterValues values = values_at(p);
        // Places belong to the residuals at p; at any other p they are unknown and left at the declared ones.
        if (p == evaluated_at_) values.places_m = places_m_;
        jacobian_ = prediction::weighted_residuals(setup_, trials_, run(values, parameters_, progress),
                                                   parameters_.size())
                        .jacobian;
        return jacobian_;
    }

    /// Places of the markers in the best evaluation, with deviations from this fit.
    std::vector<prediction::FoundPlace> places(const inverse::LeastSquaresReport& fit) const {
        return prediction::found_places(setup_, prediction::unknown_places(setup_, trials_, kept_.best),
                                        prediction::weighted_residuals(setup_, trials_, kept_.best, 0).residuals, fit);
    }

    /// Kept predictions after the fit, without solver paths.
    KeptPredictions take() {
        for (prediction::TrialPrediction& prediction : kept_.best) prediction.trace.path.reset();
        return std::move(kept_);
    }

private:
    /// Simulates the fit trials; stages start from the path of the best run so far.
    std::vector<prediction::TrialPrediction> run(const prediction::ParameterValues& values,
                                                 const std::vector<prediction::ModelParameter>& parameters,
                                                 const Progress& progress) const {
        std::vector<prediction::PredictionTask> tasks;
        for (std::size_t i = 0; i < trials_.size(); ++i)
            tasks.push_back({trials_[i], &values, kept_.best.empty() ? nullptr : kept_.best[i].trace.path});
        return prediction::predict_trials(setup_, tasks, parameters, progress);
    }

    // Exact comparison: the declared values reach this function unchanged as the start of the fit.
    bool is_declared(const Eigen::VectorXd& p) const {
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            if (p(static_cast<Eigen::Index>(i)) != prediction::value_of(parameters_[i], declared_)) return false;
        return true;
    }

    /// Reports an evaluation to the listener, if there is one.
    void tell(const prediction::ParameterValues& values, const inverse::ResidualEvaluation& evaluation, double rms_m,
              bool best) const {
        if (!settings_.evaluated) return;
        constexpr double infinity = std::numeric_limits<double>::infinity(),
                         unknown = std::numeric_limits<double>::quiet_NaN();
        if (!evaluation.ok) return settings_.evaluated({values, infinity, unknown, unknown, nullptr});
        settings_.evaluated({values, 0.5 * evaluation.residuals.squaredNorm(), rms_m, gradient(evaluation.residuals),
                             best ? &kept_.best : nullptr});
    }

    // Gradient in scaled parameters, with the last Jacobian: the solver does not compute one for every evaluation.
    double gradient(const Eigen::VectorXd& residuals) const {
        // No Jacobian yet.
        if (jacobian_.rows() != residuals.size()) return std::numeric_limits<double>::quiet_NaN();
        Eigen::VectorXd gradient = jacobian_.transpose() * residuals;
        for (std::size_t p = 0; p < parameters_.size(); ++p)
            gradient(static_cast<Eigen::Index>(p)) *= parameters_[p].parameter.scale;
        return gradient.norm();
    }

    setup::Setup setup_;
    const CalibrationSettings& settings_;
    const std::vector<prediction::ModelParameter>& parameters_;
    std::vector<std::size_t> trials_;
    prediction::ParameterValues declared_;
    KeptPredictions kept_;
    Eigen::MatrixXd jacobian_;               // of the last linearisation
    Eigen::VectorXd evaluated_at_;           // of the last complete evaluation
    std::vector<Eigen::Vector3d> places_m_;  // most probable ones there
};

/// Fills before and after: fit trials reuse the runs of the fit, all others are simulated now, in one parallel batch.
/// After cancellation nothing is simulated.
void set_runs(const setup::Setup& setup, const prediction::ParameterValues& declared,
              const prediction::ParameterValues& fitted, KeptPredictions kept, const Progress& progress,
              Calibration& result) {
    const std::vector<std::size_t> fit = prediction::trials_with_role(setup, experiment::TrialRole::fit),
                                   validation = prediction::trials_with_role(setup, experiment::TrialRole::validate);
    std::vector<prediction::TrialPrediction> before(setup.trials.size()), after(setup.trials.size());
    std::vector<prediction::PredictionTask> tasks;
    std::vector<prediction::TrialPrediction*> places;
    const auto run = [&](std::size_t trial, const prediction::ParameterValues& values,
                         prediction::TrialPrediction& place) {
        tasks.push_back({trial, &values});
        places.push_back(&place);
    };
    for (std::size_t i = 0; i < fit.size(); ++i) {
        // Runs with the declared values are missing if the search began from other values.
        after[fit[i]] = std::move(kept.best[i]);
        if (kept.first.empty())
            run(fit[i], declared, before[fit[i]]);
        else
            before[fit[i]] = std::move(kept.first[i]);
    }
    for (const std::size_t t : validation) run(t, declared, before[t]);
    for (const std::size_t t : validation) run(t, fitted, after[t]);
    std::vector<prediction::TrialPrediction> predicted(
        tasks.size(), {dynamics::RunStatus::cancelled, "stopped by the user", {}, {}, {}, {}, {}});
    // Results of cancelled tasks keep the status "cancelled", so that missing runs are reported with a reason.
    if (!progress.cancelled()) predicted = prediction::predict_trials(setup, tasks, {}, progress);
    for (std::size_t i = 0; i < tasks.size(); ++i)
        *places[i] = tasks[i].values == &declared ? markers_only(predicted[i]) : std::move(predicted[i]);
    for (const prediction::TrialPrediction& prediction : after)
        result.stopped = result.stopped || prediction.status == dynamics::RunStatus::cancelled;
    for (const prediction::TrialPrediction& prediction : before)
        result.stopped = result.stopped || prediction.status == dynamics::RunStatus::cancelled;

    // Trials that are only simulated take no part: it is no failure that they were not run.
    std::vector<std::size_t> compared = fit;
    compared.insert(compared.end(), validation.begin(), validation.end());
    std::sort(compared.begin(), compared.end());
    result.before = prediction::scored_run(setup, declared, std::move(before), compared);
    result.after = prediction::scored_run(setup, fitted, std::move(after), compared);
}

/// One sentence per parameter without influence, and one per group that the data determine only in combination.
std::vector<std::string> undetermined_sentences(const Calibration& calibration) {
    std::vector<std::string> sentences;
    const auto parameter = [&](Eigen::Index i) -> const prediction::ModelParameter& {
        return calibration.parameters[static_cast<std::size_t>(i)];
    };
    for (const inverse::Undetermined& group : calibration.fit.undetermined) {
        const Eigen::Index first = group.parameters.front();
        std::string sentence = parameter(first).parameter.name + ": " +
                               calibration.undetermined_reason(static_cast<std::size_t>(first));
        if (group.parameters.size() == 1 && calibration.fit.values(first) == calibration.fit.start(first))
            sentence += ", so it is left at its start, " + format_number(calibration.fit.start(first)) +
                        (parameter(first).unit.empty() ? "" : " " + parameter(first).unit);
        sentences.push_back(std::move(sentence));
    }
    return sentences;
}

/// What a reader of the result should know: undetermined and correlated parameters, bounds, several minima, failed
/// runs.
std::vector<std::string> calibration_warnings(const setup::Setup& setup, const Calibration& calibration) {
    std::vector<std::string> warnings = undetermined_sentences(calibration);
    const inverse::LeastSquaresReport& fit = calibration.fit;
    const auto name = [&](Eigen::Index i) {
        return calibration.parameters[static_cast<std::size_t>(i)].parameter.name;
    };
    for (Eigen::Index i = 0; i < fit.deviations.size(); ++i) {
        const inverse::Parameter& parameter = calibration.parameters[static_cast<std::size_t>(i)].parameter;
        // The standard deviation exceeds half the range, so the bounds carry more information than the data.
        if (fit.deviations(i) > 0.5 * (parameter.upper - parameter.lower))
            warnings.push_back(name(i) + ": the data determine it less than its bounds do (± " +
                               format_number(fit.deviations(i), 2) + ")");
        for (Eigen::Index j = 0; j < i; ++j)
            // Above this correlation the two standard deviations are dominated by the common combination.
            if (std::abs(fit.correlation(i, j)) > 0.999)
                warnings.push_back(name(j) + " and " + name(i) + ": these trials cannot separate them (correlation " +
                                   format_number(fit.correlation(i, j), 6) + ")");
    }
    for (const ValueAtBound& at : values_at_bounds(calibration))
        warnings.push_back(bound_sentence(setup, calibration, at));
    // 1 % in cost separates distinct minima from different ends of the same one.
    for (const CalibrationStart& start : calibration.starts)
        if (start.status == inverse::FitStatus::converged && start.cost_after > 1.01 * fit.cost_after) {
            warnings.emplace_back(several_minima);
            break;
        }
    if (calibration.stopped) return warnings;  // missing runs are due to the user's cancellation
    if (!calibration.before.ok())
        warnings.push_back("with the declared values a prediction failed: " + calibration.before.failure);
    if (!calibration.after.ok())
        warnings.push_back("with the fitted values a prediction failed: " + calibration.after.failure);
    return warnings;
}

// Values of an earlier calibration may lie outside bounds that were changed since.
double given_start(const inverse::Parameter& parameter, const CalibrationSettings& settings) {
    const auto found = settings.from.find(parameter.name);
    return found == settings.from.end() ? parameter.value : std::clamp(found->second, parameter.lower, parameter.upper);
}

/// Random start: uniform within three scales of the declared value and the bounds; logarithmic for parameters over
/// decades.
double random_start(const inverse::Parameter& p, std::mt19937_64& random) {
    // Top 53 bits of the generator: std::uniform_real_distribution differs between standard libraries.
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
    const auto between = [unit](double low, double high) { return low + unit * (high - low); };
    if (!p.over_decades)
        return std::clamp(
            between(std::max(p.lower, p.value - 3.0 * p.scale), std::min(p.upper, p.value + 3.0 * p.scale)), p.lower,
            p.upper);
    const double at = std::log1p(p.value / p.scale);
    return std::clamp(p.scale * std::expm1(between(std::max(0.0, at - 2.0), at + 2.0)), p.lower, p.upper);
}

}  // namespace

int Calibration::evaluations() const {
    int sum = 0;
    for (const CalibrationStart& start : starts) sum += static_cast<int>(start.history.size());
    return sum;
}

double Calibration::deviation(std::size_t parameter) const {
    const auto i = static_cast<Eigen::Index>(parameter);
    const double noise = fit.deviations(i);
    if (!(noise > 0.0)) return noise;
    // Noise, mesh and step are independent causes, hence the root of the sum of squares.
    const auto part = [i](const Eigen::VectorXd& known) { return known.size() > 0 ? known(i) : 0.0; };
    return std::hypot(noise, part(numerical.mesh), part(numerical.step));
}

std::string Calibration::undetermined_reason(std::size_t parameter) const {
    std::vector<inverse::Parameter> plain;
    for (const prediction::ModelParameter& p : parameters) plain.push_back(p.parameter);
    return myo::inverse::undetermined_reason(plain, fit.undetermined, fit.values, static_cast<Eigen::Index>(parameter));
}

Calibration calibrate(const setup::Setup& setup, const CalibrationSettings& settings, const Progress& progress) {
    const Stopwatch watch;
    Calibration result;
    result.settings = settings;
    result.parameters = prediction::free_parameters(setup, settings.names);
    // Keeps the predictions of the best values, so that these need not be simulated again after the fit.
    FitRuns runs(setup, settings, result.parameters);
    const auto residuals = [&](const Eigen::VectorXd& p, const Progress& inner) { return runs.residuals(p, inner); };
    const auto jacobian = [&](const Eigen::VectorXd& p, const inverse::ResidualEvaluation&, const Progress& inner) {
        return runs.jacobian(p, inner);
    };
    // One generator for all starts: more starts leave the first ones as they are.
    std::mt19937_64 random(settings.seed);
    // Parameters without influence, as found by the first start.
    std::vector<bool> unmoved(result.parameters.size(), false);
    double done = 0.0;
    for (int s = 0; s < settings.starts && (s == 0 || !progress.cancelled()); ++s) {
        std::vector<inverse::Parameter> parameters;
        for (const prediction::ModelParameter& p : result.parameters) parameters.push_back(p.parameter);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            // Drawn for every parameter, used or not, so that the other values of a start do not depend on which ones
            // are fixed.
            const double drawn = s == 0 ? 0.0 : random_start(parameters[i], random);
            parameters[i].value = s == 0 || unmoved[i] ? given_start(parameters[i], settings) : drawn;
        }
        const Progress inner = progress.with_sink([&](const ProgressEvent& event) {
            const std::string words = settings.starts > 1 ? "start " + std::to_string(s + 1) + " of " +
                                                                std::to_string(settings.starts) + "  "
                                                          : "";
            progress.report(
                {event.task, done + event.done, event.total * settings.starts, event.unit, words + event.message});
        });
        // Each start has its own budget of evaluations.
        inverse::LeastSquaresOptions options;
        options.max_evaluations = settings.max_evaluations;
        inverse::LeastSquaresReport fit = inverse::fit_least_squares(parameters, residuals, jacobian, options, inner);
        // A body that is declared too soft may have no equilibrium under its commands; with stiffer moduli it can be
        // run.
        if (s == 0 && fit.status == inverse::FitStatus::failed)
            if (const auto start = prediction::runnable_start(setup, runs.values_at(fit.start), result.parameters,
                                                              runs.trials(), inner)) {
                for (std::size_t i = 0; i < parameters.size(); ++i)
                    parameters[i].value = prediction::value_of(result.parameters[i], *start);
                fit = inverse::fit_least_squares(parameters, residuals, jacobian, options, inner);
            }
        done += static_cast<double>(fit.history.size());
        // Without influence on the data, a random start of such a parameter would only add noise to the comparison.
        if (s == 0)
            for (const inverse::Undetermined& group : fit.undetermined)
                if (group.parameters.size() == 1) unmoved[static_cast<std::size_t>(group.parameters.front())] = true;
        result.starts.push_back(
            {fit.status, fit.message, fit.start, fit.values, fit.cost_before, fit.cost_after, fit.history});
        const bool better = fit.usable() && (!result.usable() || fit.cost_after < result.fit.cost_after);
        // The first start is kept even if it failed, so that its status and message are reported.
        if (better || s == 0) result.fit = std::move(fit);
    }
    result.stopped = progress.cancelled();
    if (result.usable()) {
        prediction::ParameterValues fitted = runs.values_at(result.fit.values);
        result.places = runs.places(result.fit);
        // Places that the fit found are part of the fitted model: predictions of all trials use them.
        for (const prediction::FoundPlace& place : result.places) fitted.places_m.push_back(place.shift_m);
        // Validation trials get levels predicted from those of the fit trials, before and after the fit.
        set_runs(setup, prediction::with_predicted_levels(setup, prediction::declared_values(setup)),
                 prediction::with_predicted_levels(setup, std::move(fitted)), runs.take(), progress, result);
        result.warnings = calibration_warnings(setup, result);
    }
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo::calibration
