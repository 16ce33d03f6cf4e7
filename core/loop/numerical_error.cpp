#include "loop/numerical_error.hpp"

#include <cmath>

#include "diagnosis/nuisance_space.hpp"
#include "project/integration_check.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

/// Share of the extrapolated error by which it may be wrong: orders between 1.5 and 2.5 change the factor by so much.
constexpr double extrapolation_doubt = 0.35;

/// Changes below so many times the noise are taken to be in the range where errors follow their order.
constexpr double asymptotic_over_noise = 3.0;

/// A step that changes predictions by less than this part of the noise is not looked at again.
constexpr double negligible_step = 0.3;

/// finer - coarser of the residuals, per marker; what is not compared is 0.
std::vector<Matrix3Xd> difference(const TrialPrediction& finer, const TrialPrediction& coarser) {
    std::vector<Matrix3Xd> result;
    for (std::size_t m = 0; m < coarser.residual_m.size(); ++m) {
        result.push_back(finer.residual_m[m] - coarser.residual_m[m]);
        result.back() = result.back().unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
    }
    return result;
}

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

double change_rms(const std::vector<Matrix3Xd>& tracks) {
    Sum sum;
    sum.add(tracks);
    return sum.rms();
}

/// 1 / (1 - ratio^2): from the change by a refinement of second order to its limit.
double extrapolation(double ratio) { return 1.0 / (1.0 - ratio * ratio); }

void add_scaled(const std::vector<Matrix3Xd>& tracks, double factor, std::vector<Matrix3Xd>& sum) {
    if (sum.empty())
        for (const Matrix3Xd& track : tracks) sum.push_back(Matrix3Xd::Zero(3, track.cols()));
    for (std::size_t m = 0; m < tracks.size(); ++m) sum[m] += factor * tracks[m];
}

}  // namespace

Result<Study> refined_study(const Study& study, double ratio, const Progress& progress) {
    StudySettings settings = study.settings;
    settings.mesh.element = study.mesh.element;
    settings.mesh.resolution_m = ratio * study.mesh.resolution_m;
    return prepare_study(study.experiment, settings, progress);
}

NumericalError numerical_error(const Study& study, const Study* refined, const StudyValues& values, const std::vector<std::size_t>& trials,
                               const std::vector<TrialPrediction>& base, const NumericalError* known, const Progress& progress) {
    NumericalError error;
    error.step_ratio = 0.5;
    std::vector<PredictionTask> tasks;
    for (const std::size_t t : trials) tasks.push_back({t, &values});
    const bool negligible = known && known->step_rms_m < negligible_step * study.noise_m.minCoeff() && known->step_shift.size() == study.trials.size();
    std::vector<TrialPrediction> finer_step(trials.size());
    if (!negligible) {
        Study halved = study;
        for (StudyTrial& trial : halved.trials) {
            trial.options.h_s *= error.step_ratio;
            trial.options.most_iterations = SimulationOptions().most_iterations;   // it has more steps
            trial.options.keep_path = false;
        }
        finer_step = predict_trials(halved, tasks, {}, progress);
    }
    std::vector<TrialPrediction> finer_mesh(trials.size());
    if (refined) {
        error.mesh_ratio = refined->mesh.resolution_m / study.mesh.resolution_m;
        if (!progress.cancelled()) finer_mesh = predict_trials(*refined, tasks, {}, progress);
    } else {
        error.message = "no finer mesh could be made";
    }
    error.step_shift.resize(study.trials.size());
    if (negligible) error.step_shift = known->step_shift;
    error.shift.resize(study.trials.size());
    Sum by_step, by_mesh;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const std::size_t t = trials[i];
        if (!base[i].ok()) continue;
        if (finer_step[i].ok()) {
            const std::vector<Matrix3Xd> change = difference(finer_step[i], base[i]);
            by_step.add(change);
            add_scaled(change, extrapolation(error.step_ratio), error.step_shift[t]);
        }
        error.shift[t] = error.step_shift[t];
        if (finer_mesh[i].ok()) {
            const std::vector<Matrix3Xd> change = difference(finer_mesh[i], base[i]);
            by_mesh.add(change);
            // A mesh so coarse that its error is far from small does not follow its order: then the finer one is taken as it is.
            const bool small = change_rms(change) < asymptotic_over_noise * study.noise_m.maxCoeff();
            add_scaled(change, small ? extrapolation(error.mesh_ratio) : 1.0, error.shift[t]);
        }
    }
    error.step_rms_m = negligible ? known->step_rms_m : by_step.rms();
    error.mesh_rms_m = by_mesh.rms();
    const StudyTrial& first = study.trials.front();
    error.numerical_damping = check_integration(trial_model(study, 0, values), first.options.integrator, first.options.h_s).numerical_damping_ratio;
    return error;
}

void complete(NumericalError& error, const NumericalError& other) {
    for (std::size_t t = 0; t < error.shift.size(); ++t) {
        if (error.shift[t].empty()) error.shift[t] = other.shift[t];
        if (error.step_shift[t].empty()) error.step_shift[t] = other.step_shift[t];
    }
}

double extrapolation_left_m(const FitData& data, const Eigen::MatrixXd& jacobian) {
    const NuisanceSpace nuisance(jacobian);
    const Eigen::VectorXd shift = flat_shift(data);
    double squares = 0.0;
    for (const int trial : trials_of(data.layout)) {
        Eigen::VectorXd own = Eigen::VectorXd::Zero(shift.size());
        for (const ResidualSeries& series : data.layout.series)
            if (series.trial == trial) own.segment(series.begin, series.size()) = shift.segment(series.begin, series.size());
        squares += std::pow(flat_rms_m(data, nuisance.outside(own)), 2);
    }
    return extrapolation_doubt * std::sqrt(squares);
}

}  // namespace myo
