#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/fit_data.hpp"
#include "inverse/least_squares.hpp"

namespace myo::diagnosis {

/// Fit of declared parameters and effects, with the data for its assessment.
struct JointFit {
    /// Tried effects with the fitted values; declared effects are in `values` only.
    std::vector<effect::EffectDeclaration> effects;
    std::vector<prediction::ModelParameter> parameters;
    prediction::ParameterValues values;  // of the least cost
    inverse::LeastSquaresReport report;
    Eigen::VectorXd residual;                              // N, at `values`; of the markers
    Eigen::MatrixXd jacobian;                              // N x parameters; may contain secant updates
    Eigen::VectorXd sensor_residual;                       // S, at `values`; see sensor_rows()
    Eigen::MatrixXd sensor_jacobian;                       // S x parameters
    std::vector<prediction::TrialPrediction> predictions;  // of data.trials, without tangents and shift

    // Wall-clock time of the fit.
    double seconds = 0.0;

    bool usable() const { return residual.size() > 0; }
    /// Approximate number of model runs: parameters that do not act in a trial need no run of it.
    /// @param trials  number of fit trials
    int runs(int trials) const {
        return trials * (report.evaluations + report.jacobians * static_cast<int>(parameters.size()));
    }
    /// Number of compared coordinates and readings.
    double samples() const {
        return static_cast<double>(residual.size()) + static_cast<double>((sensor_residual.array() != 0.0).count());
    }
    /// Squared residual of markers and sensors [noise squares].
    double squares() const { return residual.squaredNorm() + sensor_residual.squaredNorm(); }
    /// Squared residual beyond its expectation for noise alone; at least 0.
    double excess() const { return std::max(0.0, squares() - samples()); }
};

/// Jacobian of markers and sensors, N + S x parameters.
Eigen::MatrixXd all_slopes(const JointFit& fit);

/// Derivatives of the flat residual and motions known near the start of a fit; they save runs and iterations.
struct WarmStart {
    std::vector<std::string> names;                                 // of the parameters
    Eigen::MatrixXd columns;                                        // N + S x names
    std::vector<std::shared_ptr<const dynamics::StagePath>> paths;  // of data.trials; null: unknown
};
/// Jacobian and paths of a fit.
WarmStart warm_start_of(const JointFit& fit);

/// First-order rms difference of the predictions of two fits with the same parameters [noise levels].
/// Computed from the Jacobian of `b`, without a run.
double change_between(const JointFit& a, const JointFit& b);

/// Fitted parameters of the tried effects: the first parameter of each, its amount, or all (place, direction, ...).
enum class EffectFreedom { amount, all };

/// What is fitted, and from where. Refers to values that outlive the fit.
struct FitTask {
    const setup::Setup& setup;
    const FitData& data;
    const prediction::ParameterValues& start;
    const DiagnosisPolicy& policy;
    EffectFreedom freedom = EffectFreedom::all;
    Effort effort;
    WarmStart warm = {};  // saves runs
};

/// Least-squares fit to markers and sensors from task.start (inverse::fit_by_secants). Effects of the start beyond
/// those of the experiment are fitted, too.
///
/// Runs setup.settings.threads trials in parallel. Vectors of effects have a weak prior around their start with a width
/// of ten times their scale (DeclaredFitPolicy::prior_widths): the data determine a place on a surface in two
/// directions only. The result is not usable if the model cannot be run at the start or has no Jacobian.
JointFit joint_fit(const FitTask& task, const Progress& progress);

/// Free parameters of the experiment, followed by those of the tried effects, with start values and bounds.
std::vector<prediction::ModelParameter> joint_parameters(const setup::Setup& setup,
                                                         const prediction::ParameterValues& start,
                                                         const DeclaredFitPolicy& policy,
                                                         EffectFreedom freedom = EffectFreedom::all);

}  // namespace myo::diagnosis
