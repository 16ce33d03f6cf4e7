#include "calibration/numerical_deviation.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/time_step.hpp"
#include "prediction/weighted_residuals.hpp"
#include "setup/first_vibration.hpp"
#include "setup/refined_setup.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Only the residuals are needed; copying traces would double the memory of the fit.
std::vector<prediction::TrialPrediction> residuals_of(const prediction::SetupRun& run,
                                                      const std::vector<std::size_t>& trials) {
    std::vector<prediction::TrialPrediction> result;
    for (const std::size_t t : trials) {
        const prediction::TrialPrediction& full = run.predictions[t];
        result.push_back({full.status,
                          full.message,
                          {},
                          {},
                          {},
                          full.residual_m,
                          {},
                          full.sensor_residuals,
                          {},
                          full.place_tangents,
                          full.places_m});
    }
    return result;
}

/// Fitted values on another mesh or with other steps, from the same data.
struct Refitted {
    VectorXd values;      // empty: not found
    std::string message;  // the reason if not found
    VectorXd left;        // change of the residual that the values do not absorb, in noise levels
    double run_s = 0.0;   // wall-clock time of the first run of all trials
};

/// Discretisation errors of the values and of the motion.
struct Errors {
    VectorXd values;      // empty: unknown
    std::string message;  // the reason if unknown
    double motion = 0.0;  // rms in noise levels
};

/// Lower bound of the mesh error per value, see the policy; zero for all but the modulus. Proportional to the edge
/// length, as the clamp's corners converge with first order.
VectorXd min_mesh_error(const setup::Setup& setup, const Calibration& calibration,
                        const NumericalDeviationPolicy& policy) {
    const double edges = setup.mesh.resolution_m /
                         setup::automatic_resolution(setup.surface, fem::cell_type(setup.mesh.element));
    VectorXd error = VectorXd::Zero(calibration.fit.values.size());
    for (Index i = 0; i < error.size(); ++i)
        if (calibration.parameters[static_cast<std::size_t>(i)].kind ==
            prediction::ModelParameter::Kind::youngs_modulus)
            error(i) = policy.min_mesh_error * edges * calibration.fit.values(i);
    return error;
}

/// Refits the parameters of a calibration on another setup, by Gauss-Newton with the Jacobian of the calibration.
class Refit {
public:
    Refit(const setup::Setup& setup, const Calibration& calibration, const Progress& progress,
          const NumericalDeviationPolicy& policy)
        : calibration_(calibration),
          progress_(progress),
          policy_(policy),
          trials_(prediction::trials_with_role(setup, experiment::TrialRole::fit)),
          residuals_(
              prediction::weighted_residuals(setup, trials_, residuals_of(calibration.after, trials_), 0).residuals),
          min_mesh_error_(min_mesh_error(setup, calibration, policy)) {
        const Eigen::MatrixXd& J = calibration.fit.jacobian;
        // Columns are scaled, and parameters that the fit could not determine are left out, so the system is well
        // conditioned.
        if (!ready()) return;
        std::vector<inverse::Parameter> parameters;
        for (const prediction::ModelParameter& p : calibration.parameters) parameters.push_back(p.parameter);
        scale_ = VectorXd::Zero(J.cols());  // parameters that the fit does not move keep 0
        for (const Index i : inverse::sufficient_parameters(parameters, J, {}))
            scale_(i) = parameters[static_cast<std::size_t>(i)].scale;
        solver_.compute(J * scale_.asDiagonal());
    }

    /// Whether the calibration has residuals and a Jacobian.
    bool ready() const { return residuals_.size() > 0 && residuals_.size() == calibration_.fit.jacobian.rows(); }

    /// The fit itself, where nothing changes.
    ///
    /// @param fit_s  its duration [s], of which one run takes a share
    Refitted as_fitted(double fit_s) const {
        const int runs = std::max(1, calibration_.evaluations());
        return {calibration_.fit.values, {}, VectorXd::Zero(residuals_.size()), fit_s / runs};
    }

    /// @param values  initial values
    /// Gauss-Newton iterations on another setup.
    ///
    /// @param beside  reference: corrections small relative to the change from it end the iteration
    /// @param max_s  no run but the first is started that would end later [s]
    Refitted on(const setup::Setup& other, VectorXd values, const VectorXd& beside, double max_s) const {
        const setup::Setup kept = prediction::with_kept_paths(other);
        const Stopwatch watch;
        Refitted result;
        // Paths of the last run: stages of the next one start from them, as the values change little.
        std::vector<std::shared_ptr<const dynamics::StagePath>> near(trials_.size());
        for (int run = 1; run <= policy_.max_runs; ++run) {
            const VectorXd at = within_bounds(values);
            const prediction::ParameterValues all = with_values(at);
            std::vector<prediction::PredictionTask> tasks;
            for (std::size_t i = 0; i < trials_.size(); ++i) tasks.push_back({trials_[i], &all, near[i]});
            const std::vector<prediction::TrialPrediction> predictions = prediction::predict_trials(kept, tasks, {},
                                                                                                    progress_);
            const inverse::ResidualEvaluation there = prediction::weighted_residuals(kept, trials_, predictions, 0);
            if (!there.ok) return {{}, progress_.cancelled() ? "stopped by the user" : there.message, {}};
            for (std::size_t i = 0; i < near.size(); ++i) near[i] = predictions[i].trace.path;
            // The estimate of how long runs on another mesh take.
            if (run == 1) result.run_s = watch.seconds();
            // Chord method: target residual minus current one, solved with the factorised, scaled Jacobian of the fit.
            const VectorXd step = scale_.cwiseProduct(solver_.solve(residuals_ - there.residuals));
            result.values = values = at + step;
            // Linearised residual after the correction, minus that of the fit: the part of the change outside the
            // column space.
            result.left = there.residuals + calibration_.fit.jacobian * step - residuals_;
            const bool settled = (step.array().abs() <= settled_change(values - beside)).all();
            if (settled || watch.seconds() * (run + 1) / run > max_s) break;
        }
        return result;
    }

    /// Root mean square over the compared coordinates; occluded ones have residual 0.
    double rms(const VectorXd& change) const {
        const auto count = static_cast<double>((residuals_.array() != 0.0).count());
        return count > 0.0 ? change.norm() / std::sqrt(count) : 0.0;
    }

private:
    /// Gauss-Newton steps know no bounds; models outside of them may not run.
    VectorXd within_bounds(VectorXd values) const {
        for (Index i = 0; i < values.size(); ++i) {
            const inverse::Parameter& p = calibration_.parameters[static_cast<std::size_t>(i)].parameter;
            values(i) = std::clamp(values(i), p.lower, p.upper);
        }
        return values;
    }

    /// Fitted values of the calibration, with these in place of the parameters.
    prediction::ParameterValues with_values(const VectorXd& at) const {
        prediction::ParameterValues values = calibration_.after.values;
        for (Index i = 0; i < at.size(); ++i)
            prediction::set_value(calibration_.parameters[static_cast<std::size_t>(i)], at(i), values);
        return values;
    }

    /// Corrections below this are negligible relative to the total change, the noise and the least mesh error. Infinite
    /// for parameters that the data do not determine.
    Eigen::ArrayXd settled_change(const VectorXd& change) const {
        Eigen::ArrayXd most = policy_.settled *
                              (change.array().abs() + calibration_.fit.deviations.array() + min_mesh_error_.array());
        for (double& one : most)
            if (std::isnan(one)) one = std::numeric_limits<double>::infinity();
        return most;
    }

    const Calibration& calibration_;
    Progress progress_;
    const NumericalDeviationPolicy& policy_;
    std::vector<std::size_t> trials_;
    VectorXd residuals_, min_mesh_error_, scale_;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver_;
};

/// Error of a value over its change if edges or steps are multiplied by `ratio` (Richardson extrapolation).
double extrapolation(double ratio, double order) { return 1.0 / std::abs(1.0 - std::pow(ratio, order)); }

/// Estimates both errors within a limited time, steps first because they need no new mesh.
class Estimate {
public:
    Estimate(const setup::Setup& setup, const Calibration& calibration, const Progress& progress,
             const NumericalDeviationPolicy& policy)
        : setup_(setup),
          calibration_(calibration),
          policy_(policy),
          progress_(progress.with_sink([progress](ProgressEvent event) {
              event.task = "numerical errors";
              progress.report(event);
          })),
          refit_(setup, calibration, progress_, policy),
          max_s_(std::max(policy.always_s, policy.max_share * calibration.seconds)) {}

    NumericalDeviations run() {
        NumericalDeviations result;
        const setup::Setup longer = with_longer_steps(setup_);
        const VectorXd& fitted = calibration_.fit.values;
        const Refitted with_longer = !refit_.ready() ? Refitted{{}, "the fit ended without derivatives", {}}
                                     : no_steps()    ? refit_.as_fitted(calibration_.seconds)
                                                     : refit_.on(longer, fitted, fitted, 0.3 * left_s());
        // The mesh error is measured with the longer steps on both meshes, so it needs the refit with them.
        const Errors steps = of_steps(with_longer);
        const Errors mesh = steps.values.size() > 0 ? of_mesh(longer, with_longer) : Errors{{}, steps.message};
        result.step = steps.values;
        result.mesh = mesh.values;
        result.motion_noise_levels = std::hypot(steps.motion, mesh.motion, other_vibrations());
        if (steps.values.size() == 0)
            result.message =
                "the standard deviations are those of the markers' noise alone, without the errors of "
                "mesh and time step: " +
                steps.message;
        else if (mesh.values.size() == 0)
            result.message = "the standard deviations leave out the mesh's error: " + mesh.message;
        result.seconds = watch_.seconds();
        return result;
    }

private:
    /// Error of the steps in vibrations other than the dominant one, for which they were chosen [noise levels, rms over
    /// the fit trials].
    double other_vibrations() const {
        const prediction::SetupRun& run = calibration_.after;
        double squares = 0.0;
        int count = 0;
        for (const std::size_t t : prediction::trials_with_role(setup_, experiment::TrialRole::fit)) {
            if (!run.predictions[t].trace.complete()) continue;
            const double error_m = prediction::step_seen_in(setup_, t, run.values, run.predictions[t].trace)
                                       .other_vibrations_m;
            squares += error_m * error_m;
            ++count;
        }
        return count > 0 ? std::sqrt(squares / count) / setup::mean_noise(setup_) : 0.0;
    }

    /// Whether all fit trials are poses: there is no time to step through.
    bool no_steps() const {
        const std::vector<std::size_t> trials = prediction::trials_with_role(setup_, experiment::TrialRole::fit);
        return std::all_of(trials.begin(), trials.end(), [&](std::size_t t) { return setup_.trials[t].hold; });
    }

    /// Wall-clock time that is left for further runs [s].
    double left_s() const { return max_s_ - watch_.seconds(); }

    /// Steps of the given setup relative to those that the calibration ended with.
    setup::Setup with_longer_steps(setup::Setup setup) const {
        for (std::size_t t = 0; t < setup.trials.size(); ++t)
            setup::set_step(setup.trials[t], policy_.longer_steps * setup_.trials[t].options.h_s);
        return setup;
    }

    /// Error of the time steps, from a refit with longer ones.
    Errors of_steps(const Refitted& longer) const {
        if (longer.values.size() == 0) return {{}, longer.message};
        // Order of the integrator: implicit Euler is the only first-order scheme.
        const double order = setup_.settings.integrator == dynamics::Integrator::implicit_euler ? 1.0 : 2.0,
                     error = extrapolation(policy_.longer_steps, order);
        return {error * (longer.values - calibration_.fit.values).cwiseAbs(), {}, error * refit_.rms(longer.left)};
    }

    /// Mesh error, from runs with the longer steps on both meshes: it hardly depends on the step, and they are cheaper.
    Errors of_mesh(const setup::Setup& longer, const Refitted& here) const {
        std::string message = "no other mesh can be made";
        for (const double edges : policy_.edges) {
            if (progress_.cancelled()) return {{}, "stopped by the user"};
            Result<setup::Setup> other = setup::refined_setup(longer, edges, progress_.with_sink({}));
            // A mesh that is hardly different would amplify rounding by the extrapolation.
            if (!other || std::abs(std::log(edge_ratio(*other))) < std::log(policy_.another)) continue;
            message = "runs on another mesh would take too long";
            const double larger = static_cast<double>(other->body->dofs()) / static_cast<double>(setup_.body->dofs());
            if (here.run_s * std::pow(larger, policy_.time_exponent) > left_s()) continue;
            *other = with_longer_steps(std::move(*other));
            const Refitted there = refit_.on(*other, start_on(*other, here.values), here.values, left_s());
            if (there.values.size() == 0) return {{}, there.message};
            return {error_of(*other, there.values - here.values),
                    {},
                    extrapolation(edge_ratio(*other), policy_.mesh_order) * refit_.rms(there.left - here.left)};
        }
        return {{}, message};
    }

    /// Mean ratio of edge lengths from the numbers of cells: layers are integers, so directions change differently.
    double edge_ratio(const setup::Setup& other) const {
        const auto cells = [](const setup::Setup& s) { return static_cast<double>(s.mesh.mesh.cell_count()); };
        return std::cbrt(cells(setup_) / cells(other));
    }

    /// Mesh error of each value, from its change on the other mesh; at least the least error of the policy.
    VectorXd error_of(const setup::Setup& other, const VectorXd& change) const {
        const VectorXd error = extrapolation(edge_ratio(other), policy_.mesh_order) * change.cwiseAbs();
        return error.cwiseMax(min_mesh_error(setup_, calibration_, policy_));
    }

    /// Start for another mesh: the modulus that gives the same first frequency. Otherwise the phase would drift from
    /// the data and Gauss-Newton would need more runs.
    VectorXd start_on(const setup::Setup& other, VectorXd start) const {
        const prediction::ParameterValues& values = calibration_.after.values;
        const double here = setup::first_vibration_rad_s(prediction::trial_model(setup_, 0, values)),
                     there = setup::first_vibration_rad_s(prediction::trial_model(other, 0, values));
        if (!(here > 0.0) || !(there > 0.0)) return start;
        for (std::size_t i = 0; i < calibration_.parameters.size(); ++i)
            if (calibration_.parameters[i].kind == prediction::ModelParameter::Kind::youngs_modulus)
                start(static_cast<Index>(i)) *= std::pow(here / there, 2);
        return start;
    }

    const setup::Setup& setup_;
    const Calibration& calibration_;
    const NumericalDeviationPolicy& policy_;
    Progress progress_;
    Stopwatch watch_;
    Refit refit_;
    double max_s_;
};

}  // namespace

NumericalDeviations numerical_deviations(const setup::Setup& setup, const Calibration& calibration,
                                         const Progress& progress, const NumericalDeviationPolicy& policy) {
    return Estimate(setup, calibration, progress, policy).run();
}

}  // namespace myo::calibration
