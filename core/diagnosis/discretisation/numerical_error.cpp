#include "diagnosis/discretisation/numerical_error.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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

/// Runs with other steps; poses, which have none, are those of `base`.
std::vector<prediction::TrialPrediction> runs_with(const setup::Setup& setup, const prediction::ParameterValues& values,
                                                   const std::vector<std::size_t>& trials,
                                                   const std::vector<prediction::TrialPrediction>& base,
                                                   const Progress& progress) {
    std::vector<std::size_t> moving;
    std::copy_if(trials.begin(), trials.end(), std::back_inserter(moving),
                 [&](std::size_t t) { return !setup.trials[t].hold; });
    std::vector<prediction::TrialPrediction> runs = prediction::predict_trials_with(setup, values, moving, progress);
    std::vector<prediction::TrialPrediction> all;
    for (std::size_t i = 0, next = 0; i < trials.size(); ++i)
        all.push_back(setup.trials[trials[i]].hold ? base[i] : runs[next++]);
    return all;
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

NumericalError numerical_error(const RefinedRuns& runs, const NumericsPolicy& policy, const Progress& progress) {
    const auto& [setup, refined, values, trials, base, known, effective_modulus] = runs;
    NumericalError error;
    error.effective_modulus = effective_modulus;
    error.step_ratio = policy.step_ratio;
    // Step errors of similar motions are similar: a negligible one is reused and saves a run of twice the steps.
    const bool negligible = known && known->step_rms_m < policy.negligible_step_error * setup.noise_m.minCoeff() &&
                            known->step_shift.size() == setup.trials.size();
    std::vector<prediction::TrialPrediction> finer_step(trials.size());
    if (!negligible) {
        setup::Setup halved = setup;
        halved.modulus_factor = effective_modulus.factor_of_finer_step();
        for (setup::PreparedTrial& trial : halved.trials) {
            trial.options.h_s *= error.step_ratio;
            trial.options.max_iterations = dynamics::SimulationOptions().max_iterations;  // limit for more steps
            trial.options.keep_path = false;
        }
        finer_step = runs_with(halved, values.finer_step, trials, base, progress);
    }
    std::vector<prediction::TrialPrediction> finer_mesh(trials.size());
    if (refined) {
        error.mesh_ratio = refined->mesh.resolution_m / setup.mesh.resolution_m;
        setup::Setup finer = *refined;
        finer.modulus_factor = effective_modulus.factor_of_finer_mesh();
        if (!progress.cancelled())
            finer_mesh = prediction::predict_trials_with(finer, values.finer_mesh, trials, progress);
    } else {
        error.message = "no finer mesh could be made";
    }
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
