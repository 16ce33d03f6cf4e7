#include "diagnosis/discretisation/numerical_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "prediction/predict_trials.hpp"
#include "setup/integration_check.hpp"
#include "statistics/nuisance_space.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Matrix3Xd;

/// Sum of squares and count of entries, for a common rms [m].
struct Sum {
    double squares = 0.0, count = 0.0;
    void add(const std::vector<Matrix3Xd>& tracks) {
        for (const Matrix3Xd& track : tracks) {
            squares += track.squaredNorm();
            count += static_cast<double>(track.size());
        }
    }
    double rms() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }
};

/// Order of convergence of displacements with the edge length.
double mesh_order(fem::ElementKind element, const NumericsPolicy& policy) {
    if (element == fem::ElementKind::hex8) return policy.order_hex8;
    return fem::fine_element(element) == fem::ElementKind::tet10_fine ? policy.order_tet10_fine : policy.order_other;
}

/// Richardson factor: distance to the limit over the change by a refinement with this ratio (fine over coarse).
double extrapolation(double ratio, double order) { return 1.0 / (1.0 - std::pow(ratio, order)); }

/// Whether a fit determines the modulus of the whole body, which compensates for stiffer cells.
bool moves_modulus(const JointFit& fit) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(), [](const prediction::ModelParameter& p) {
        return p.kind == prediction::ModelParameter::Kind::youngs_modulus;
    });
}

/// The setup without paths, which no run starts from.
setup::Setup without_paths(setup::Setup setup) {
    for (setup::PreparedTrial& trial : setup.trials) trial.options.keep_path = false;
    return setup;
}

/// The setup with this share of its steps, and its modulus factor for them.
setup::Setup with_finer_steps(setup::Setup setup, double ratio, double modulus_factor) {
    setup.modulus_factor = modulus_factor;
    for (setup::PreparedTrial& trial : setup.trials) {
        trial.options.h_s *= ratio;
        trial.options.max_iterations = dynamics::SimulationOptions().max_iterations;  // limit for more steps
    }
    return setup;
}

/// Predictions of each trial; not run where there are none.
struct ErrorRuns {
    std::vector<prediction::TrialPrediction> base, fitted, finer_step, finer_mesh;
};

/// All runs in parallel: those of one kind alone would leave threads without work, since trials differ in length.
ErrorRuns run_all(const RefinedRuns& in, double step_ratio, bool with_finer_step, const Progress& progress) {
    const setup::Setup base = without_paths(in.setup),
                       halved = with_finer_steps(base, step_ratio, in.effective_modulus.factor_of_finer_step());
    std::optional<setup::Setup> finer;
    if (in.refined) {
        finer = without_paths(*in.refined);
        finer->modulus_factor = in.effective_modulus.factor_of_finer_mesh();
    }
    std::vector<prediction::PredictionTask> tasks;
    std::vector<prediction::TrialPrediction*> places;
    ErrorRuns runs;
    const auto add = [&](std::vector<prediction::TrialPrediction>& kind, const setup::Setup& setup,
                         const prediction::ParameterValues& values, bool holds_too) {
        for (std::size_t i = 0; i < in.trials.size(); ++i) {
            if (setup.trials[in.trials[i]].hold && !holds_too) continue;
            tasks.push_back({in.trials[i], &values, {}, &setup});
            places.push_back(&kind[i]);
        }
    };
    for (auto* kind : {&runs.base, &runs.fitted, &runs.finer_step, &runs.finer_mesh}) kind->resize(in.trials.size());
    // The longest first, so that the end is not one of them alone.
    if (finer) add(runs.finer_mesh, *finer, in.values.finer_mesh, true);
    if (with_finer_step) add(runs.finer_step, halved, in.values.finer_step, false);
    add(runs.base, base, in.values.setup, true);
    if (in.fitted) add(runs.fitted, base, *in.fitted, true);
    std::vector<prediction::TrialPrediction> done = prediction::predict_trials(in.setup, tasks, {}, progress);
    for (std::size_t k = 0; k < done.size(); ++k) *places[k] = std::move(done[k]);
    // A pose has no steps.
    if (with_finer_step)
        for (std::size_t i = 0; i < in.trials.size(); ++i)
            if (in.setup.trials[in.trials[i]].hold) runs.finer_step[i] = runs.base[i];
    return runs;
}

}  // namespace

double step_extrapolation(const NumericsPolicy& policy) { return extrapolation(policy.step_ratio, policy.step_order); }

std::vector<Matrix3Xd> difference(const prediction::TrialPrediction& finer,
                                  const prediction::TrialPrediction& coarser) {
    std::vector<Matrix3Xd> result;
    for (std::size_t m = 0; m < coarser.residual_m.size(); ++m) {
        result.push_back(finer.residual_m[m] - coarser.residual_m[m]);
        result.back() = result.back().unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
    }
    return result;
}

void add_scaled(const std::vector<Matrix3Xd>& tracks, double factor, std::vector<Matrix3Xd>& sum) {
    if (sum.empty())
        for (const Matrix3Xd& track : tracks) sum.push_back(Matrix3Xd::Zero(3, track.cols()));
    for (std::size_t m = 0; m < tracks.size(); ++m) sum[m] += factor * tracks[m];
}

NumericalError numerical_error(const RefinedRuns& in, const NumericsPolicy& policy, const Progress& progress) {
    const auto& [setup, refined, values, fitted_values, trials, known, effective_modulus] = in;
    NumericalError error;
    error.effective_modulus = effective_modulus;
    error.step_ratio = policy.step_ratio;
    // Step errors of similar motions are similar: a negligible one is reused and saves a run of twice the steps.
    const bool negligible = known && known->step_rms_m < policy.negligible_step_error * setup.noise_m.minCoeff() &&
                            known->step_shift.size() == setup.trials.size();
    const ErrorRuns runs = run_all(in, error.step_ratio, !negligible, progress);
    const auto& [base, fitted, finer_step, finer_mesh] = runs;
    if (refined)
        error.mesh_ratio = refined->mesh.resolution_m / setup.mesh.resolution_m;
    else
        error.message = "no finer mesh could be made";
    error.step_shift.resize(setup.trials.size());
    if (negligible) error.step_shift = known->step_shift;
    error.shift.resize(setup.trials.size());
    error.mesh_change.resize(setup.trials.size());
    Sum by_step, by_mesh;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const std::size_t t = trials[i];
        if (!base[i].ok()) continue;
        // A refined run that fails leaves its part of the error unknown (empty); the others are still removed.
        if (finer_step[i].ok()) {
            const std::vector<Matrix3Xd> change = difference(finer_step[i], base[i]);
            by_step.add(change);
            add_scaled(change, step_extrapolation(policy), error.step_shift[t]);
        }
        error.shift[t] = error.step_shift[t];
        if (finer_mesh[i].ok()) {
            const std::vector<Matrix3Xd> change = difference(finer_mesh[i], base[i]);
            by_mesh.add(change);
            error.mesh_change[t] = change;
        }
    }
    // The order does not hold far from the limit: a large change is taken over without extrapolation.
    if (by_mesh.rms() < policy.asymptotic_change * setup.noise_m.maxCoeff() && refined)
        error.mesh_factor = extrapolation(error.mesh_ratio, mesh_order(setup.mesh.element, policy));
    for (const std::size_t t : trials)
        if (!error.mesh_change[t].empty()) add_scaled(error.mesh_change[t], error.mesh_factor, error.shift[t]);
    error.step_rms_m = negligible ? known->step_rms_m : by_step.rms();
    error.mesh_rms_m = by_mesh.rms();
    error.rest_rms_m = shift_rms_m(error.shift);
    // The runs had the matched values: their distance from those with the fitted ones belongs to the shift.
    if (fitted_values)
        for (std::size_t i = 0; i < trials.size(); ++i)
            if (base[i].ok() && fitted[i].ok() && !error.shift[trials[i]].empty())
                add_scaled(difference(base[i], fitted[i]), 1.0, error.shift[trials[i]]);
    const setup::PreparedTrial& first = setup.trials.front();
    // Stated for the report only; the step error contains its effect on the motion.
    error.numerical_damping = setup::check_integration(prediction::trial_model(setup, 0, values.setup),
                                                       first.options.integrator, first.options.h_s)
                                  .numerical_damping_ratio;
    return error;
}

double shift_rms_m(const PredictionShift& shift) {
    Sum sum;
    for (const std::vector<Matrix3Xd>& trial : shift) sum.add(trial);
    return sum.rms();
}

NumericalError completed(NumericalError error, const NumericalError& other) {
    for (std::size_t t = 0; t < error.shift.size(); ++t) {
        if (error.shift[t].empty()) error.shift[t] = other.shift[t];
        if (error.step_shift[t].empty()) error.step_shift[t] = other.step_shift[t];
    }
    return error;
}

double extrapolation_left_m(const FitData& data, const NumericalError& error, const JointFit& fit,
                            const NumericsPolicy& policy) {
    // The part of the error within the space of the parameters moves the fitted values, not the residual.
    const statistics::NuisanceSpace nuisance(fit.jacobian);
    Eigen::VectorXd shift = flat_shift(data, error.shift);
    if (!moves_modulus(fit)) shift += flat_shift(data, error.by_modulus);
    double squares = 0.0;
    for (const int trial : statistics::trials_of(data.layout)) {
        Eigen::VectorXd own = Eigen::VectorXd::Zero(shift.size());
        for (const statistics::ResidualSeries& series : data.layout.series)
            if (series.trial == trial)
                own.segment(series.begin, series.size()) = shift.segment(series.begin, series.size());
        // Each trial by itself, squares added: the errors are taken as independent between trials.
        squares += std::pow(flat_rms_m(data, nuisance.outside(own)), 2);
    }
    return policy.extrapolation_doubt * std::sqrt(squares);
}

}  // namespace myo::diagnosis
